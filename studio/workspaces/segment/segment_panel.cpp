#include "studio/workspaces/segment/segment_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QVBoxLayout>

#include "studio/app/commands.h"
#include "studio/app/panel_parts.h"
#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/workspaces/segment/compare_box.h"
#include "studio/workspaces/segment/detection_box.h"
#include "studio/workspaces/segment/review.h"
#include "studio/workspaces/segment/statistics_box.h"
#include "studio/workspaces/segment/suspects_model.h"
#include "studio/workspaces/segment/unmatched_box.h"

namespace kumite::studio {

SegmentPanel::SegmentPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      model_(new SuspectsModel(session, this)),
      table_(makeTable()),
      empty_(new QLabel(this)),
      reason_(new QLabel(this)),
      accept_(new QPushButton(tr("Keep"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      statistics_(new StatisticsBox(session, this)),
      unmatched_(new UnmatchedBox(session, this)),
      compare_(new CompareBox(session, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(5);
    layout->addWidget(headingLabel(tr("Suspect minima"), this));
    layout->addWidget(table_, 1);
    empty_->setText(
        tr("Minima of the force curves that cut actions appear here, the most "
           "suspicious first. Lower the prominence below to see more."));
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop);
    empty_->setProperty("role", "second");
    layout->addWidget(empty_, 1);
    layout->addWidget(makeDecisions());
    layout->addSpacing(3);
    layout->addWidget(headingLabel(tr("Review"), this));
    layout->addWidget(statistics_);
    layout->addWidget(unmatched_);
    layout->addSpacing(3);
    layout->addWidget(headingLabel(tr("Detection"), this));
    layout->addWidget(new DetectionBox(session, this));
    layout->addWidget(compare_);
    setMinimumWidth(200);

    connect(&session_, &Session::fightersChanged, this, &SegmentPanel::showFighters);
    connect(&session_, &Session::takeChanged, this, &SegmentPanel::showFighters);
    connect(&session_.document(), &Document::stepped, this, [this](const Project& before) {
        if (isVisible()) selectChanged(session_, before);
    });
    connect(&session_, &Session::selectionChanged, this, &SegmentPanel::showSelection);
    showFighters();
}

QTableView* SegmentPanel::makeTable() {
    auto* table = new QTableView(this);
    table->setModel(model_);
    table->setAccessibleName(tr("Suspect minima"));
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);
    table->setMinimumHeight(92);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(22);
    QHeaderView* header = table->horizontalHeader();
    header->setMinimumSectionSize(36);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(SuspectsModel::ReasonColumn, QHeaderView::Stretch);
    const QFontMetrics metrics = fontMetrics();
    header->resizeSection(SuspectsModel::SuspicionColumn,
                          metrics.horizontalAdvance(QStringLiteral("100 %")) + 12);
    header->setHighlightSections(false);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setIconSize({8, 8});
    connect(table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) { chooseRow(current.row()); });
    connect(table, &QTableView::clicked, this,
            [this](const QModelIndex& index) { chooseRow(index.row()); });
    return table;
}

QWidget* SegmentPanel::makeDecisions() {
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    reason_->setWordWrap(true);
    reason_->setProperty("role", "second");
    reason_->setAlignment(Qt::AlignTop);
    reason_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    reason_->setAccessibleName(tr("Why the minimum is suspected"));
    layout->addWidget(reason_);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(accept_, 1);
    buttons->addWidget(remove_, 1);
    layout->addLayout(buttons);
    for (QPushButton* button : {accept_, remove_})
        button->setFocusPolicy(Qt::TabFocus);
    accept_->setToolTip(tr("It is a boundary: no suspect any more; goes on to the next"));
    connect(accept_, &QPushButton::clicked, this,
            [this] { commands_->run(QStringLiteral("review.accept")); });
    connect(remove_, &QPushButton::clicked, this, [this] {
        const auto& selected = session_.selection();
        const BoundaryMark* mark =
            selected ? nearestMark(session_.marks(selected->player), selected->frame, 0.5)
                     : nullptr;
        if (mark != nullptr && !mark->isLive()) {
            commands_->run(QStringLiteral("boundary.toggle"));
        } else {
            commands_->run(QStringLiteral("review.reject"));
        }
    });
    return box;
}

QWidget* SegmentPanel::list() const {
    return table_;
}

void SegmentPanel::showFighters() {
    filling_ = true;
    model_->refresh();
    filling_ = false;
    // As wide as the latest moment and the dot before it.
    const QString latest = timeText(session_.transport().span().end, 0.01);
    table_->horizontalHeader()->resizeSection(SuspectsModel::TimeColumn,
                                              fontMetrics().horizontalAdvance(latest) + 30);
    table_->setVisible(model_->rowCount() > 0);
    empty_->setVisible(model_->rowCount() == 0);
    statistics_->refresh();
    unmatched_->refresh();
    showSelection();
}

void SegmentPanel::showSelection() {
    filling_ = true;
    const auto& selected = session_.selection();
    const int row = selected ? model_->rowOf(*selected) : -1;
    if (row >= 0) {
        table_->setCurrentIndex(model_->index(row, 0));
    } else {
        table_->clearSelection();
        table_->setCurrentIndex({});
    }
    const BoundaryMark* mark =
        selected ? nearestMark(session_.marks(selected->player), selected->frame, 0.5) : nullptr;
    const bool removed = mark != nullptr && !mark->isLive();
    accept_->setEnabled(mark != nullptr &&
                        (mark->isOpen() || (removed && mark->minimum.has_value())));
    remove_->setEnabled(mark != nullptr);
    remove_->setText(removed ? tr("Restore") : tr("Remove"));
    showTips(removed);
    if (row >= 0) {
        // A number and its unit stay together.
        static const QRegularExpression beforeUnit(QStringLiteral("(?<=\\d) "));
        reason_->setText(model_->reasonAt(row).replace(beforeUnit, QString(QChar::Nbsp)));
    } else {
        const bool anySuspect = model_->rowCount() > 0 && model_->suspectAt(0).isOpen() &&
                                model_->suspectAt(0).suspicion >= kSuspect;
        const QString key = commands_ ? commands_->find("review.next")->keysText() : QString();
        reason_->setText(
            mark ? tr("A boundary that a hand has set.")
            : anySuspect
                ? tr("%1 leads to the most suspicious minimum. Remove it where the body hardly "
                     "dips: a kick down and up again is one action. Keep it where one ends and "
                     "another begins.")
                      .arg(key)
                : tr("No suspect is left. %1 leads through the others.").arg(key));
    }
    filling_ = false;
}

void SegmentPanel::showTips(bool removed) {
    const QString command = removed ? "boundary.toggle" : "review.reject";
    const QString tip =
        removed ? tr("Bring the boundary back") : tr("It is spurious; goes on to the next");
    remove_->setProperty("command", command);
    remove_->setToolTip(commands_ ? commands_->withKey(tip, command) : tip);
}

void SegmentPanel::tellKeys(CommandTable& commands) {
    commands_ = &commands;
    commands.tellKey(accept_, "review.accept");
    commands.tellKey(compare_->toggle(), "segment.compare");
    connect(&commands, &CommandTable::renamed, this, &SegmentPanel::showSelection);
    showSelection();
}

void SegmentPanel::chooseRow(int row) {
    if (filling_ || row < 0 || row >= model_->rowCount()) return;
    session_.examine(model_->suspectAt(row).boundary);
}

}  // namespace kumite::studio
