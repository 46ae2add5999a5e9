#include "studio/app/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/key_editor.h"
#include "studio/app/language.h"
#include "studio/app/panel_parts.h"
#include "studio/app/preferences.h"

namespace kumite::studio {

namespace {

/// Changes one value of the preferences.
template <typename Change>
void change(Preferences& preferences, const Change& how) {
    PreferenceValues values = preferences.values();
    how(values);
    preferences.set(values);
}

void describe(QWidget* field, const QString& name, const QString& tip) {
    field->setAccessibleName(name);
    field->setToolTip(tip);
}

}  // namespace

PreferencesDialog::PreferencesDialog(Preferences& preferences, CommandTable& commands,
                                     QWidget* parent)
    : QDialog(parent), preferences_(preferences), pages_(new QTabWidget(this)) {
    setWindowTitle(tr("Preferences"));
    resize(roomFor(*this, {640, 560}));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->setSpacing(12);
    pages_->setDocumentMode(true);
    pages_->tabBar()->setDrawBase(false);
    auto* general = new QScrollArea(pages_);
    general->setFrameShape(QFrame::NoFrame);
    general->setWidgetResizable(true);
    general->setFocusPolicy(Qt::NoFocus);
    general->setWidget(makeGeneralPage());
    pages_->addTab(general, tr("General"));
    pages_->addTab(new KeyEditor(commands, pages_), tr("Keys"));
    layout->addWidget(pages_, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* defaults = buttons->addButton(tr("Restore defaults"), QDialogButtonBox::ResetRole);
    defaults->setAutoDefault(false);
    defaults->setToolTip(tr("All values of the General page as the studio brings them."));
    connect(defaults, &QPushButton::clicked, this, [this] { preferences_.set({}); });
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close this page (Esc)"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(pages_, &QTabWidget::currentChanged, this,
            [defaults](int page) { defaults->setVisible(page == GeneralPage); });
    layout->addWidget(buttons);
}

void PreferencesDialog::showPage(Page page) {
    pages_->setCurrentIndex(page);
}

QWidget* PreferencesDialog::makeGeneralPage() {
    auto* page = new QWidget(pages_);
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 16, 0, 0);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    const auto heading = [&](const QString& text) {
        auto* label = headingLabel(text, page);
        if (form->rowCount() > 0) label->setContentsMargins(0, 10, 0, 0);
        form->addRow(label);
    };

    heading(tr("Appearance"));
    auto* theme = new QComboBox(page);
    theme->addItems({tr("As the system"), tr("Light"), tr("Dark")});
    describe(theme, tr("Theme"), tr("Colours of the whole window."));
    form->addRow(tr("Theme"), theme);
    auto* language = new QComboBox(page);
    language->addItem(tr("As the system"), QString());
    for (const Language& each : languages())
        language->addItem(each.name, each.code);
    describe(language, tr("Language"),
             tr("Of all texts, numbers and dates in the window; files do not know it. The window "
                "is made anew at once, with what is open in it."));
    form->addRow(tr("Language"), language);
    auto* size = new QSpinBox(page);
    size->setRange(100, 200);
    size->setSingleStep(25);
    size->setSuffix(tr(" %"));
    describe(size, tr("Text size, percent"),
             tr("How large all text is; pages that it makes too "
                "large can be scrolled."));
    form->addRow(tr("Text size"), size);
    auto* still = new QCheckBox(tr("Reduce motion"), page);
    describe(still, tr("Reduce motion"),
             tr("Nothing begins to move by itself: questions and similar actions stand still until "
                "you play them."));
    form->addRow(QString(), still);

    heading(tr("Playback"));
    auto* speed = new QDoubleSpinBox(page);
    speed->setRange(10, 400);
    speed->setDecimals(0);
    speed->setSingleStep(25);
    speed->setSuffix(tr(" %"));
    describe(speed, tr("Playback speed of a bout that is opened, percent"),
             tr("How fast a bout plays when it is opened. While it is open, - and + change it."));
    form->addRow(tr("Speed at opening"), speed);
    auto* looping = new QCheckBox(tr("Play in a loop"), page);
    describe(looping, tr("Play in a loop"), tr("Whether a bout loops when it is opened."));
    form->addRow(QString(), looping);
    auto* leap = new QSpinBox(page);
    leap->setRange(2, 1000);
    leap->setSuffix(tr(" frames"));
    describe(leap, tr("Frames of a leap"), tr("How far Shift+← and Shift+→ go."));
    form->addRow(tr("Shift+← → goes"), leap);

    heading(tr("Mouse"));
    auto* mouse = new QDoubleSpinBox(page);
    mouse->setRange(25, 400);
    mouse->setDecimals(0);
    mouse->setSingleStep(25);
    mouse->setSuffix(tr(" %"));
    describe(mouse, tr("Mouse sensitivity in the 3D view, percent"),
             tr("How fast a drag turns and the wheel zooms in the 3D view."));
    form->addRow(tr("Sensitivity in 3D"), mouse);

    heading(tr("Safety"));
    auto* autosave = new QSpinBox(page);
    autosave->setRange(5, 600);
    autosave->setSuffix(tr(" s"));
    describe(autosave, tr("Autosave interval in seconds"),
             tr("After how long at most changes are kept for a recovery. The project file itself "
                "is written only when you save."));
    form->addRow(tr("Autosave every"), autosave);

    // The fields follow the values, whoever changed them.
    const auto show = [=, this] {
        const PreferenceValues& v = preferences_.values();
        theme->setCurrentIndex(static_cast<int>(v.theme));
        language->setCurrentIndex(std::max(0, language->findData(v.language)));
        size->setValue(v.textSize);
        still->setChecked(v.reduceMotion);
        speed->setValue(v.playbackSpeed * 100);
        looping->setChecked(v.looping);
        leap->setValue(v.leapFrames);
        mouse->setValue(v.mouseSpeed * 100);
        autosave->setValue(v.autosaveSeconds);
    };
    show();
    for (QAbstractSpinBox* box :
         {static_cast<QAbstractSpinBox*>(size), static_cast<QAbstractSpinBox*>(speed),
          static_cast<QAbstractSpinBox*>(leap), static_cast<QAbstractSpinBox*>(mouse),
          static_cast<QAbstractSpinBox*>(autosave)}) {
        box->setLocale(fieldLocale());
        box->setKeyboardTracking(false);
        box->setMinimumWidth(withTextSize(120));
    }
    theme->setMinimumWidth(withTextSize(160));
    language->setMinimumWidth(withTextSize(160));
    connect(&preferences_, &Preferences::changed, page, show);
    connect(theme, &QComboBox::currentIndexChanged, page,
            [this](int index) { preferences_.setTheme(static_cast<ThemeChoice>(index)); });
    connect(language, &QComboBox::activated, page, [this, language] {
        change(preferences_,
               [=](PreferenceValues& v) { v.language = language->currentData().toString(); });
    });
    connect(size, &QSpinBox::valueChanged, page, [this](int percent) {
        change(preferences_, [=](PreferenceValues& v) { v.textSize = percent; });
    });
    connect(still, &QCheckBox::toggled, page, [this](bool on) {
        change(preferences_, [=](PreferenceValues& v) { v.reduceMotion = on; });
    });
    connect(speed, &QDoubleSpinBox::valueChanged, page, [this](double percent) {
        change(preferences_, [=](PreferenceValues& v) { v.playbackSpeed = percent / 100; });
    });
    connect(looping, &QCheckBox::toggled, page, [this](bool on) {
        change(preferences_, [=](PreferenceValues& v) { v.looping = on; });
    });
    connect(leap, &QSpinBox::valueChanged, page, [this](int frames) {
        change(preferences_, [=](PreferenceValues& v) { v.leapFrames = frames; });
    });
    connect(mouse, &QDoubleSpinBox::valueChanged, page, [this](double percent) {
        change(preferences_, [=](PreferenceValues& v) { v.mouseSpeed = percent / 100; });
    });
    connect(autosave, &QSpinBox::valueChanged, page, [this](int seconds) {
        change(preferences_, [=](PreferenceValues& v) { v.autosaveSeconds = seconds; });
    });
    return page;
}

}  // namespace kumite::studio
