#include "studio/workspaces/bout/bout_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <functional>
#include <numbers>

#include "studio/app/panel_parts.h"
#include "studio/app/words.h"
#include "studio/workspaces/bout/bout_session.h"
#include "studio/workspaces/bout/candidates_model.h"

namespace kumite::studio {

namespace {

/// What is measured: its name, and its text for a quality; empty where it is not known.
struct Measure {
    QString name;
    QString tip;
    std::function<QString(const Quality&)> text;
};

QString percent(const std::optional<double>& share) {
    return share ? numberText(100 * *share, 1) + QStringLiteral(" %") : QString();
}

QString percent(const std::optional<Penetration>& found) {
    return percent(found ? std::optional(found->share) : std::nullopt);
}

std::vector<Measure> measures() {
    return {
        {BoutPanel::tr("foot skate"),
         BoutPanel::tr("Share of frames in which a foot near the floor slides faster than "
                       "0.5 m/s"),
         [](const Quality& q) { return percent(q.footSkate); }},
        {BoutPanel::tr("in the floor"),
         BoutPanel::tr("Share of frames with a foot more than 5 mm in the floor"),
         [](const Quality& q) { return percent(q.floor); }},
        {BoutPanel::tr("overlap"),
         BoutPanel::tr("Share of frames with the bodies more than 3 cm in each other"),
         [](const Quality& q) { return percent(q.interpenetration); }},
        {BoutPanel::tr("joins"),
         BoutPanel::tr("Joint accelerations where actions are joined, their 99th percentile over "
                       "that inside recorded actions"),
         [](const Quality& q) {
             return q.joinAccelerationRatio
                        ? numberText(*q.joinAccelerationRatio, 2) + QStringLiteral("×")
                        : QString();
         }},
        {BoutPanel::tr("facing"),
         BoutPanel::tr("Mean angle between where a fighter faces and its opponent"),
         [](const Quality& q) {
             return q.facingError ? numberText(*q.facingError * 180 / std::numbers::pi, 0) +
                                        QStringLiteral("°")
                                  : QString();
         }},
        {BoutPanel::tr("distance"), BoutPanel::tr("Mean distance between both fighters"),
         [](const Quality& q) {
             return q.distance ? numberText(q.distance->mean, 2) + QStringLiteral(" m") : QString();
         }},
        {BoutPanel::tr("hit timing"),
         BoutPanel::tr("How far reactions are from their due moment, on average"),
         [](const Quality& q) {
             return q.hitTiming ? numberText(1000 * *q.hitTiming, 0) + QStringLiteral(" ms")
                                : QString();
         }},
        {BoutPanel::tr("variety"),
         BoutPanel::tr("Share of distinct runs of three labels; falls with length"),
         [](const Quality& q) { return q.variety ? percent(q.variety->share()) : QString(); }}};
}

}  // namespace

BoutPanel::BoutPanel(BoutSession& bout, QWidget* parent)
    : QWidget(parent),
      bout_(bout),
      candidates_(new CandidatesModel(bout, this)),
      modes_(new QButtonGroup(this)),
      who_(new QComboBox(this)),
      whoText_(new QLabel(this)),
      reactFirst_(new QCheckBox(tr("reacts first"), this)),
      seed_(new QSpinBox(this)),
      temperature_(new QDoubleSpinBox(this)),
      state_(new QLabel(this)),
      choiceText_(new QLabel(this)),
      list_(new QListView(this)),
      quality_(new QTableWidget(this)),
      judge_(new QPushButton(tr("Measure"), this)),
      buttons_(new QWidget(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeSettings());
    layout->addWidget(makeChoice(), 1);
    layout->addWidget(makeQuality());
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    layout->addWidget(buttons_);
    setMinimumWidth(200);
    connect(&bout_, &BoutSession::begun, this, &BoutPanel::showState);
    connect(&bout_, &BoutSession::begun, this, &BoutPanel::showQuality);
    connect(&bout_, &BoutSession::stateChanged, this, &BoutPanel::showState);
    connect(&bout_, &BoutSession::choicesChanged, this, &BoutPanel::showChoice);
    connect(&bout_, &BoutSession::judged, this, &BoutPanel::showQuality);
    showSettings();
    showState();
    showChoice();
    showQuality();
}

void BoutPanel::addButton(QWidget* button) {
    buttons_->layout()->addWidget(button);
}

QWidget* BoutPanel::makeSettings() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* modes = new QHBoxLayout;
    modes->setSpacing(4);
    const QString names[] = {tr("Automatic"), tr("Avatar"), tr("Passive")};
    const QString tips[] = {tr("The model decides for both"),
                            tr("Keys and pointer lead one fighter, the model the other"),
                            tr("One replays a captured attack that the model has not seen; the "
                               "other answers and may not attack")};
    for (const int mode : {0, 1, 2}) {
        auto* button = new QToolButton(box);
        button->setText(names[mode]);
        button->setToolTip(tips[mode]);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        modes_->addButton(button, mode);
        modes->addWidget(button);
    }
    layout->addLayout(modes);
    connect(modes_, &QButtonGroup::idClicked, this, [this](int mode) {
        BoutSettings settings = bout_.wanted();
        settings.mode = static_cast<BoutMode>(mode);
        bout_.setWanted(settings);
    });
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    whoText_->setProperty("role", "second");
    who_->addItems({fighterText(0), fighterText(1)});
    who_->setFocusPolicy(Qt::TabFocus);
    grid->addWidget(whoText_, 0, 0);
    grid->addWidget(who_, 0, 1);
    reactFirst_->setToolTip(tr("Under attack the avatar may answer before it does as asked"));
    grid->addWidget(reactFirst_, 0, 2);
    connect(who_, &QComboBox::activated, this, [this](int player) {
        BoutSettings settings = bout_.wanted();
        (settings.mode == BoutMode::Passive ? settings.attacker : settings.avatar) = player;
        bout_.setWanted(settings);
    });
    connect(reactFirst_, &QCheckBox::clicked, this, [this](bool on) {
        BoutSettings settings = bout_.wanted();
        settings.reactFirst = on;
        bout_.setWanted(settings);
    });
    auto* seedText = new QLabel(tr("seed"), box);
    seedText->setProperty("role", "second");
    seed_->setRange(0, 999999);
    seed_->setAccessibleName(tr("Seed"));
    seed_->setToolTip(tr("The same seed gives the same bout"));
    auto* temperatureText = new QLabel(tr("T"), box);
    temperatureText->setProperty("role", "second");
    temperature_->setRange(0, 10);
    temperature_->setSingleStep(0.1);
    temperature_->setDecimals(1);
    temperature_->setAccessibleName(tr("Temperature"));
    temperature_->setToolTip(tr("0: always the likeliest; 1: as learnt; above: more even"));
    grid->addWidget(seedText, 1, 0);
    grid->addWidget(seed_, 1, 1);
    auto* warmth = new QHBoxLayout;
    warmth->addWidget(temperatureText);
    warmth->addWidget(temperature_, 1);
    grid->addLayout(warmth, 1, 2);
    grid->setColumnStretch(1, 1);
    layout->addLayout(grid);
    const auto settle = [this] {
        if (showing_) return;
        BoutSettings settings = bout_.wanted();
        settings.seed = static_cast<std::uint64_t>(seed_->value());
        settings.temperature = temperature_->value();
        bout_.setWanted(settings);
    };
    for (QAbstractSpinBox* field :
         {static_cast<QAbstractSpinBox*>(seed_), static_cast<QAbstractSpinBox*>(temperature_)}) {
        field->setKeyboardTracking(false);
    }
    connect(seed_, &QSpinBox::valueChanged, this, settle);
    connect(temperature_, &QDoubleSpinBox::valueChanged, this, settle);
    state_->setWordWrap(true);
    state_->setProperty("role", "second");
    state_->setAccessibleName(tr("State of the bout"));
    layout->addWidget(state_);
    return box;
}

QWidget* BoutPanel::makeChoice() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(headingLabel(tr("Why this?"), box));
    choiceText_->setWordWrap(true);
    choiceText_->setProperty("role", "second");
    choiceText_->setAccessibleName(tr("The choice"));
    layout->addWidget(choiceText_);
    list_->setModel(candidates_);
    list_->setItemDelegate(new CandidatesDelegate(*candidates_, list_));
    list_->setAccessibleName(tr("What else it could have done"));
    list_->setUniformItemSizes(true);
    list_->setSelectionMode(QAbstractItemView::SingleSelection);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMinimumHeight(92);
    list_->setToolTip(tr("A click takes another one and goes on from there"));
    const auto takeRow = [this](const QModelIndex& index) {
        const BoutChoice* choice = candidates_->choice();
        if (choice == nullptr || index.row() < 0 || index.row() >= candidates_->rowCount()) return;
        if (candidates_->isChosen(index.row())) return;
        const Option& option = candidates_->at(index.row());
        if (option.barred == Barred::NoSample || option.barred == Barred::Mode) {
            Q_EMIT bout_.session().hinted(
                tr("It cannot be taken: %1.").arg(CandidatesModel::barredText(option.barred)));
            return;
        }
        const auto kept = bout_.choice();  // the model forgets it while it is taken
        bout_.chooseInstead(*kept, option.candidate.node);
    };
    connect(list_, &QListView::clicked, this, takeRow);
    connect(list_, &QListView::activated, this, takeRow);
    layout->addWidget(list_, 1);
    return box;
}

QWidget* BoutPanel::makeQuality() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* head = new QHBoxLayout;
    head->addWidget(headingLabel(tr("Quality"), box), 1);
    judge_->setToolTip(tr("Measures all that was shown, beside the longest recording"));
    judge_->setFocusPolicy(Qt::TabFocus);
    head->addWidget(judge_);
    connect(judge_, &QPushButton::clicked, &bout_, &BoutSession::judge);
    layout->addLayout(head);
    const std::vector<Measure> all = measures();
    quality_->setColumnCount(3);
    quality_->setRowCount(static_cast<int>(all.size()));
    quality_->setAccessibleName(tr("Quality of the bout and of the recording"));
    quality_->setHorizontalHeaderLabels({QString(), tr("bout"), tr("recorded")});
    quality_->setShowGrid(false);
    quality_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    quality_->setSelectionMode(QAbstractItemView::NoSelection);
    quality_->setFocusPolicy(Qt::NoFocus);
    quality_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    quality_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    quality_->verticalHeader()->hide();
    quality_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 3);
    QHeaderView* header = quality_->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(0, QHeaderView::Stretch);
    header->setMinimumSectionSize(20);
    header->resizeSection(1, fontMetrics().horizontalAdvance(QStringLiteral("100.0 %")) + 14);
    header->resizeSection(2, fontMetrics().horizontalAdvance(tr("recorded")) + 14);
    header->setHighlightSections(false);
    for (int row = 0; row < quality_->rowCount(); ++row) {
        for (int column = 0; column < 3; ++column) {
            auto* item = new QTableWidgetItem;
            item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) |
                                   Qt::AlignVCenter);
            item->setToolTip(all[static_cast<std::size_t>(row)].tip);
            if (column == 0) item->setText(all[static_cast<std::size_t>(row)].name);
            quality_->setItem(row, column, item);
        }
    }
    quality_->setFixedHeight(header->sizeHint().height() +
                             quality_->rowCount() * quality_->rowHeight(0) + 12);
    layout->addWidget(quality_);
    return box;
}

void BoutPanel::showSettings() {
    const BoutSettings& wanted = bout_.wanted();
    showing_ = true;
    modes_->button(static_cast<int>(wanted.mode))->setChecked(true);
    const bool passive = wanted.mode == BoutMode::Passive;
    const bool automatic = wanted.mode == BoutMode::Automatic;
    whoText_->setText(passive ? tr("attacker") : tr("avatar"));
    who_->setAccessibleName(passive ? tr("Who attacks") : tr("Who is led"));
    who_->setToolTip(passive ? tr("The fighter that replays a captured attack")
                             : tr("The fighter that keys and clicks on the floor lead"));
    who_->setCurrentIndex(passive ? wanted.attacker : wanted.avatar);
    whoText_->setVisible(!automatic);
    who_->setVisible(!automatic);
    reactFirst_->setVisible(wanted.mode == BoutMode::Avatar);
    reactFirst_->setChecked(wanted.reactFirst);
    seed_->setValue(static_cast<int>(wanted.seed));
    temperature_->setValue(wanted.temperature);
    showing_ = false;
}

void BoutPanel::showState() {
    showSettings();
    QString text;
    if (bout_.isPreparing()) {
        text = tr("A bout is being prepared.");
    } else if (bout_.steers()) {
        const std::string& wish = bout_.tape()->now().wish();
        text = wish.empty() ? tr("Keys 1 to 9 ask the avatar for something, a click on the floor "
                                 "says where to be.")
                            : tr("Asked for: %1").arg(QString::fromStdString(wish));
    } else if (bout_.tape() != nullptr && bout_.isOutdated()) {
        text = tr("Labels or boundaries changed: begin anew to use them.");
    }
    state_->setText(text);
    state_->setVisible(!text.isEmpty());
    judge_->setEnabled(bout_.tape() != nullptr && !bout_.judging().isRunning());
}

void BoutPanel::showChoice() {
    const auto choice = bout_.choice();
    candidates_->show(choice);
    if (!choice) {
        choiceText_->setText(tr("Each choice, with all that could have been, appears here."));
        return;
    }
    const int player = choice->player;
    QString text =
        tr("%1 at %2, after %3, while %4")
            .arg(fighterText(player), timeText(choice->frame / bout_.rate(), 0.01),
                 bout_.nameOf(player, choice->own), bout_.nameOf(1 - player, choice->opponent));
    if (choice->options.options.empty()) text += tr(": replayed");
    if (choice->forced) text += tr(": chosen by hand");
    if (choice->commanded) text += tr(": as asked for");
    if (choice->options.stanceGaveWay) text += tr(" (no other stance was left)");
    choiceText_->setText(text);
    for (int row = 0; row < candidates_->rowCount(); ++row) {
        if (!candidates_->isChosen(row)) continue;
        list_->scrollTo(candidates_->index(row), QAbstractItemView::EnsureVisible);
        break;
    }
}

void BoutPanel::showQuality() {
    const auto& judgement = bout_.judgement();
    const std::vector<Measure> all = measures();
    for (int row = 0; row < quality_->rowCount(); ++row) {
        const auto& measure = all[static_cast<std::size_t>(row)];
        const auto textOf = [&](const Quality& quality) {
            const QString text = measure.text(quality);
            return text.isEmpty() ? QStringLiteral("–") : text;
        };
        // Nothing is measured unasked: "…" waits for the button.
        const QString none = QStringLiteral("…");
        quality_->item(row, 1)->setText(judgement ? textOf(judgement->bout) : none);
        quality_->item(row, 2)->setText(judgement ? textOf(judgement->recording) : none);
    }
    judge_->setText(judgement ? tr("Measure (%1 s)").arg(numberText(judgement->seconds, 0))
                              : tr("Measure"));
}

}  // namespace kumite::studio
