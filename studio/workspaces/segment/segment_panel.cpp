#include "studio/workspaces/segment/segment_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "core/project/edits.h"
#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/workspaces/segment/suspects_model.h"

namespace kumite::studio {

namespace {

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "heading");
    return label;
}

}  // namespace

SegmentPanel::SegmentPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      model_(new SuspectsModel(session, this)),
      table_(new QTableView(this)),
      empty_(new QLabel(this)),
      remove_(new QPushButton(tr("Remove minimum"), this)),
      cutoff_(new QDoubleSpinBox(this)),
      prominence_(new QDoubleSpinBox(this)),
      counts_(new QLabel(this)),
      unmatched_(new QLabel(this)),
      forget_(new QPushButton(tr("Forget"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 4, 8);
    layout->setSpacing(6);
    layout->addWidget(heading(tr("Suspect minima"), this));
    table_->setModel(model_);
    table_->setAccessibleName(tr("Suspect minima"));
    table_->setShowGrid(false);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(22);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(SuspectsModel::ProminenceColumn,
                                                     QHeaderView::Stretch);
    table_->horizontalHeader()->setMinimumSectionSize(40);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setIconSize({8, 8});
    layout->addWidget(table_, 1);
    empty_->setText(
        tr("Minima of the force curves that cut actions appear here, the most "
           "suspicious first. Lower the prominence below to see more."));
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop);
    empty_->setProperty("role", "second");
    layout->addWidget(empty_, 1);
    remove_->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(remove_);
    layout->addSpacing(6);
    layout->addWidget(makeSettings());
    counts_->setWordWrap(true);
    layout->addWidget(counts_);
    unmatched_->setWordWrap(true);
    unmatched_->setProperty("role", "second");
    layout->addWidget(unmatched_);
    layout->addWidget(forget_, 0, Qt::AlignLeft);
    setMinimumWidth(180);

    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) { chooseRow(current.row()); });
    connect(table_, &QTableView::clicked, this,
            [this](const QModelIndex& index) { chooseRow(index.row()); });
    connect(table_, &QTableView::activated, this,
            [this](const QModelIndex& index) { chooseRow(index.row()); });
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (session_.selection()) session_.toggleCurrentBoundary();
    });
    connect(forget_, &QPushButton::clicked, this, &SegmentPanel::forgetUnmatched);
    connect(&session_, &Session::fightersChanged, this, &SegmentPanel::showFighters);
    connect(&session_, &Session::takeChanged, this, &SegmentPanel::showFighters);
    connect(&session_, &Session::selectionChanged, this, &SegmentPanel::showSelection);
    connect(&session_.document(), &Document::changed, this, &SegmentPanel::showSettings);
    showFighters();
    showSettings();
}

QWidget* SegmentPanel::makeSettings() {
    auto* box = new QWidget(this);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(6);
    form->addRow(heading(tr("Segmentation"), box));
    cutoff_->setRange(0.5, 60.0);
    cutoff_->setDecimals(1);
    cutoff_->setSingleStep(0.5);
    cutoff_->setSuffix(tr(" Hz"));
    cutoff_->setAccessibleName(tr("Cutoff of the low-pass in Hz"));
    cutoff_->setToolTip(
        tr("Low-pass over the centre of mass: lower gives smoother curves and "
           "fewer minima."));
    prominence_->setRange(0.0, 5.0);
    prominence_->setDecimals(3);
    prominence_->setSingleStep(0.01);
    prominence_->setSuffix(tr(" BW"));
    prominence_->setAccessibleName(tr("Least prominence in body weights"));
    prominence_->setToolTip(tr("A minimum must be at least this deep to be a boundary."));
    for (QDoubleSpinBox* field : {cutoff_, prominence_}) {
        field->setLocale(QLocale::c());
        field->setKeyboardTracking(false);
        field->setAlignment(Qt::AlignRight);
        connect(field, &QDoubleSpinBox::editingFinished, this, &SegmentPanel::applySettings);
    }
    form->addRow(tr("Cutoff"), cutoff_);
    form->addRow(tr("Prominence"), prominence_);
    return box;
}

void SegmentPanel::applySettings() {
    if (filling_ || !session_.document().isOpen()) return;
    SegmentationSettings settings = session_.document().project().segmentation;
    // What the fields cannot show exactly must not become an edit when they are left untouched.
    if (cutoff_->text() != cutoff_->textFromValue(settings.cutoff) + cutoff_->suffix()) {
        settings.cutoff = cutoff_->value();
    }
    if (prominence_->text() !=
        prominence_->textFromValue(settings.prominence) + prominence_->suffix()) {
        settings.prominence = prominence_->value();
    }
    session_.document().apply(
        [&](const Project& project) { return setSegmentation(project, settings); });
    showSettings();
}

void SegmentPanel::showSettings() {
    filling_ = true;
    const SegmentationSettings& settings = session_.document().project().segmentation;
    cutoff_->setValue(settings.cutoff);
    prominence_->setValue(settings.prominence);
    filling_ = false;
}

void SegmentPanel::showFighters() {
    filling_ = true;
    model_->refresh();
    filling_ = false;
    table_->setVisible(model_->rowCount() > 0);
    empty_->setVisible(model_->rowCount() == 0);
    QStringList lines;
    QStringList lost;
    for (int player = 0; player < session_.playerCount(); ++player) {
        const FighterAnalysis* fighter = session_.fighter(player);
        if (fighter == nullptr) continue;
        const Segmentation& segmentation = *fighter->segmentation;
        const auto count = segmentation.actions.size();
        QString line = count == 1 ? tr("%1: 1 action").arg(fighterText(player))
                                  : tr("%1: %2 actions").arg(fighterText(player)).arg(count);
        const auto removed = segmentation.removed.size();
        if (removed > 0) line += tr(", %1 removed").arg(removed);
        lines.append(line);
        for (const Correction& correction : segmentation.unmatched) {
            lost.append(tr("%1 at %2")
                            .arg(fighterText(player),
                                 timeText(timeOfFrame(fighter->input, correction.frame))));
        }
    }
    counts_->setText(lines.join(QLatin1Char('\n')));
    unmatched_->setText(
        tr("No minimum is left for the correction of %1.").arg(lost.join(tr(", "))));
    unmatched_->setVisible(!lost.isEmpty());
    forget_->setVisible(!lost.isEmpty());
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
    const bool minimum = mark == nullptr || mark->minimum.has_value();
    remove_->setEnabled(mark != nullptr);
    remove_->setText(removed   ? (minimum ? tr("Restore minimum") : tr("Restore boundary"))
                     : minimum ? tr("Remove minimum")
                               : tr("Remove boundary"));
    filling_ = false;
}

void SegmentPanel::chooseRow(int row) {
    if (filling_ || row < 0 || row >= model_->rowCount()) return;
    session_.goTo(model_->boundaryAt(row));
}

void SegmentPanel::forgetUnmatched() {
    for (int player = 0; player < session_.playerCount(); ++player) {
        const FighterAddress address{session_.take(), player};
        session_.document().apply([&](const Project& project, const Analysis& analysis) {
            return dropUnmatchedCorrections(project, analysis, address);
        });
    }
}

}  // namespace kumite::studio
