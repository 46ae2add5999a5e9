// How the import dialog is laid out: files above, questions at the left, what they make of the
// recordings at the right, what was found below.

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFontMetrics>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>

#include "studio/app/comfort.h"
#include "studio/app/import/import_dialog.h"
#include "studio/app/import/import_preview.h"
#include "studio/app/import/role_table.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/jobs/job_bar.h"

namespace kumite::studio {

namespace {

constexpr int kFieldWidth = 104;  ///< at text of 100 %

QLabel* fighterLabel(int player, QWidget* parent) {
    const Colours& c = coloursFor(parent->palette());
    auto* label = new QLabel(parent);
    label->setText(
        QStringLiteral("<span style='color:%1'>●</span> %2")
            .arg(c.fighters[player].name(), ImportDialog::tr("Fighter %1").arg(player + 1)));
    return label;
}

}  // namespace

QLineEdit* ImportDialog::makeField(const QString& name, const QString& hint, const QString& tip) {
    auto* field = new QLineEdit(this);
    field->setAccessibleName(name);
    field->setPlaceholderText(hint);
    field->setToolTip(tip);
    field->setFixedWidth(withTextSize(kFieldWidth));
    field->setAcceptDrops(false);
    connect(field, &QLineEdit::textChanged, this, [this] {
        looksOld_ = true;
        soon_.start();
    });
    return field;
}

QComboBox* ImportDialog::makeChoice(const QString& name, const QString& tip) {
    auto* box = new QComboBox(this);
    box->setAccessibleName(name);
    box->setToolTip(tip);
    box->setFixedWidth(withTextSize(kFieldWidth));
    connect(box, &QComboBox::currentIndexChanged, this, [this] {
        looksOld_ = true;
        soon_.start();
    });
    return box;
}

void ImportDialog::makeAnswers(int player) {
    Answers& a = answers_[player];
    const auto of = [&](const QString& what) {
        return tr("%1 of %2").arg(what, fighterText(player));
    };
    a.file = new QLineEdit(this);
    a.file->setAccessibleName(of(tr("Recording")));
    a.file->setToolTip(tr("Path of the recording; the button beside it, or a drop, chooses one"));
    a.file->setAcceptDrops(false);
    a.file->setPlaceholderText(player == 0 ? tr("a .bvh or .amc file")
                                           : tr("none: a single fighter"));
    connect(a.file, &QLineEdit::editingFinished, this, [this, &a] {
        if (!a.file->isModified()) return;
        a.file->setModified(false);
        readFiles();
    });
    a.root = makeChoice(of(tr("Skeleton")), tr("Which skeleton of a file that holds several"));
    a.asf = makeField(of(tr("ASF skeleton")), tr("the one beside it"),
                      tr("The .asf file that belongs to the .amc"));
    connect(a.asf, &QLineEdit::editingFinished, this, &ImportDialog::readFiles);
    a.units = makeChoice(of(tr("Unit of length")), tr("What one unit of the file is"));
    a.units->addItem(tr("found"), QString());
    for (const char* unit : {"m", "dm", "cm", "mm", "inch", "foot", "cmu"})
        a.units->addItem(QLatin1String(unit), QLatin1String(unit));
    a.up = makeChoice(of(tr("Up axis")), tr("The file's axis that points up"));
    a.up->addItems({tr("found"), QStringLiteral("y"), QStringLiteral("z")});
    const QString zero = QStringLiteral("0");
    a.offset = makeField(of(tr("Start")), zero,
                         tr("Seconds on the take's clock at which its first frame stands"));
    a.x = makeField(of(tr("Place x")), zero, tr("Metres along x from where the file stands"));
    a.z = makeField(of(tr("Place z")), zero, tr("Metres along z from where the file stands"));
    a.yaw =
        makeField(of(tr("Turn")), zero, tr("Degrees about the vertical, about the file's origin"));
    a.floor =
        makeField(of(tr("Floor")), tr("found"), tr("Height of the floor in the file, metres"));
}

QWidget* ImportDialog::makeFileRows() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(8);
    for (int player = 0; player < 2; ++player) {
        makeAnswers(player);
        auto* choose = new QPushButton(tr("Choose…"), box);
        choose->setAutoDefault(false);
        choose->setAccessibleName(tr("Choose the recording of %1").arg(fighterText(player)));
        choose->setToolTip(tr("BVH, or AMC with its ASF; others go through Blender"));
        connect(choose, &QPushButton::clicked, this, [this, player] {
            chooseFile(answers_[player].file,
                       tr("Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)"));
        });
        grid->addWidget(fighterLabel(player, this), player, 0);
        grid->addWidget(answers_[player].file, player, 1);
        grid->addWidget(choose, player, 2);
    }
    auto* swap = new QPushButton(tr("S&wap"), box);
    swap->setAutoDefault(false);
    swap->setAccessibleName(tr("Swap fighters"));
    swap->setToolTip(tr("Fighter 1 becomes fighter 2, with all that is said of them (Alt+W)"));
    connect(swap, &QPushButton::clicked, this, &ImportDialog::swapFighters);
    grid->addWidget(swap, 0, 3, 2, 1, Qt::AlignVCenter);
    return box;
}

void ImportDialog::addRow(QGridLayout* grid, const QString& name, QWidget* first, QWidget* second) {
    const int row = grid->rowCount();
    auto* label = new QLabel(name, this);
    grid->addWidget(label, row, 0, Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(first, row, 1);
    grid->addWidget(second, row, 2);
}

QWidget* ImportDialog::makeQuestions(const QString& project) {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 8, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    name_ = makeField(tr("Take name"), {}, tr("How the take is called in the project"));
    name_->setFixedWidth(2 * withTextSize(kFieldWidth) + 8);
    rate_ = makeField(tr("Rate in Hz"), tr("as the header"),
                      tr("True frame rate, where the header is wrong: the preview shows it"));
    frames_ = makeField(tr("Frames, begin:end"), tr("found"),
                        tr("Frames of the files; the end is the first frame left out. Empty: all, "
                           "without a leading T-pose."));
    rateFound_ = new QLabel(tr("Hz"), this);
    framesFound_ = new QLabel(tr("begin:end"), this);
    for (QLabel* found : {rateFound_, framesFound_}) {
        found->setProperty("role", "second");
        found->setWordWrap(true);
    }
    grid->addWidget(new QLabel(tr("Take"), this), 0, 0, Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(name_, 0, 1, 1, 2);
    addRow(grid, tr("Rate"), rate_, rateFound_);
    addRow(grid, tr("Frames"), frames_, framesFound_);
    grid->setRowMinimumHeight(grid->rowCount(), 8);
    addRow(grid, {}, fighterLabel(0, this), fighterLabel(1, this));
    const auto both = [&](const QString& name, auto Answers::*answer) {
        addRow(grid, name, answers_[0].*answer, answers_[1].*answer);
    };
    const auto remembered = [&](std::vector<QWidget*>& row, auto Answers::*answer) {
        const int last = grid->rowCount() - 1;
        row = {grid->itemAtPosition(last, 0)->widget(), answers_[0].*answer, answers_[1].*answer};
        for (QWidget* widget : row)
            widget->hide();
    };
    both(tr("Skeleton"), &Answers::root);
    remembered(rootRow_, &Answers::root);
    both(tr("ASF file"), &Answers::asf);
    remembered(asfRow_, &Answers::asf);
    both(tr("Unit"), &Answers::units);
    both(tr("Up axis"), &Answers::up);
    both(tr("Starts at, s"), &Answers::offset);
    both(tr("Place x, m"), &Answers::x);
    both(tr("Place z, m"), &Answers::z);
    both(tr("Turned, °"), &Answers::yaw);
    both(tr("Floor, m"), &Answers::floor);
    add_ = new QCheckBox(tr("Add as a take to %1").arg(project), this);
    add_->setToolTip(tr("Otherwise it becomes a project of its own"));
    add_->setChecked(!project.isEmpty());
    add_->setVisible(!project.isEmpty());
    grid->addWidget(add_, grid->rowCount(), 0, 1, 3);
    grid->setRowStretch(grid->rowCount(), 1);
    return box;
}

void ImportDialog::layOut(const QString& project) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addWidget(makeFileRows());
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addWidget(makeQuestions(project));
    tabs_ = new QTabWidget(this);
    tabs_->setDocumentMode(true);
    auto* shown = new QWidget(tabs_);
    auto* column = new QVBoxLayout(shown);
    column->setContentsMargins(0, 8, 0, 0);
    preview_ = new ImportPreview(shown);
    play_ = new QPushButton(tr("&Play"), shown);
    play_->setAutoDefault(false);
    play_->setToolTip(tr("Play or pause (Space in the preview, Alt+P)"));
    play_->setEnabled(false);
    connect(play_, &QPushButton::clicked, preview_, &ImportPreview::togglePlaying);
    connect(preview_, &ImportPreview::playingChanged, this,
            [this] { play_->setText(preview_->isPlaying() ? tr("&Pause") : tr("&Play")); });
    column->addWidget(preview_, 1);
    column->addWidget(play_, 0, Qt::AlignLeft);
    roles_ = new RoleTable(tabs_);
    connect(roles_, &RoleTable::changed, this, &ImportDialog::look);
    tabs_->addTab(shown, tr("Preview"));
    tabs_->addTab(roles_, tr("Roles"));
    middle->addWidget(tabs_, 1);
    layout->addLayout(middle, 1);

    findings_ = new QLabel(this);
    findings_->setObjectName(QStringLiteral("findings"));
    findings_->setWordWrap(true);
    findings_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    findings_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(findings_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedHeight(72);
    scroll->setAccessibleName(tr("What was found in the recordings"));
    layout->addWidget(scroll);

    auto* row = new QHBoxLayout;
    auto* jobs = new JobBar(this);
    jobs->watch(reading_);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setAutoDefault(false);
    cancel->setToolTip(tr("Open nothing (Esc)"));
    open_ = new QPushButton(tr("Open bout"), this);
    open_->setProperty("role", "step");
    open_->setToolTip(tr("Make a take of these recordings (Enter)"));
    open_->setDefault(true);
    row->addWidget(jobs);
    row->addStretch(1);
    row->addWidget(cancel);
    row->addWidget(open_);
    layout->addLayout(row);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(open_, &QPushButton::clicked, this, &ImportDialog::accept);
    resize(roomFor(*this, {1080, 680}));
}

}  // namespace kumite::studio
