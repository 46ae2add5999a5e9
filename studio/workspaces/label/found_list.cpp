#include "studio/workspaces/label/found_list.h"

#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/session.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/label_words.h"

namespace kumite::studio {

namespace {

/// Narrower, a list has no room for labels beside all its columns, pixels.
constexpr int kNarrow = 300;

double secondsOf(LabelSession& labels, const FoundRow& row) {
    const Project& project = labels.session().document().project();
    return timeOfFrame(fighterAt(project, row.fighter), row.peak);
}

}  // namespace

FoundModel::FoundModel(LabelSession& labels, QObject* parent)
    : QAbstractTableModel(parent), labels_(labels) {}

void FoundModel::show(std::vector<FoundRow> rows) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
}

void FoundModel::setBrief(bool brief) {
    if (brief == brief_) return;
    brief_ = brief;
    if (rows_.empty()) return;
    Q_EMIT dataChanged(index(0, ConfidenceColumn),
                       index(static_cast<int>(rows_.size()) - 1, ConfidenceColumn));
}

int FoundModel::rowOf(FighterAddress fighter, int peak) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const FoundRow& row) {
        return row.fighter == fighter && row.peak == peak;
    });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int FoundModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int FoundModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString FoundModel::toolTip(const FoundRow& row) const {
    const Project& project = labels_.session().document().project();
    QString text = tr("%1, %2: %3, %4")
                       .arg(timeText(secondsOf(labels_, row)), fighterText(row.fighter.player),
                            row.label, row.source);
    if (row.confidence) text += tr(", p %1").arg(numberText(*row.confidence, 2));
    if (project.takes.size() > 1) {
        const auto& take = project.takes[static_cast<std::size_t>(row.fighter.take)];
        text = QString::fromStdString(take.name) + QStringLiteral(", ") + text;
    }
    return text;
}

QVariant FoundModel::data(const QModelIndex& index, int role) const {
    const FoundRow& row = rows_[static_cast<std::size_t>(index.row())];
    const Colours& c = coloursFor(QGuiApplication::palette());
    switch (role) {
        case Qt::DisplayRole:
            switch (index.column()) {
                case TimeColumn:
                    return timeText(secondsOf(labels_, row), 0.1);
                case LabelColumn:
                    return row.label;
                case SourceColumn:
                    return row.source;
                default:
                    if (brief_ && row.source == sourceWords(LabelSource::Hand)) return row.source;
                    return row.confidence ? numberText(*row.confidence, 2) : QString();
            }
        case Qt::ForegroundRole:
            if (index.column() == TimeColumn) return c.fighterText[row.fighter.player];
            return index.column() == LabelColumn ? c.text : c.secondText;
        case Qt::TextAlignmentRole:
            return index.column() == ConfidenceColumn ? int(Qt::AlignRight | Qt::AlignVCenter)
                                                      : int(Qt::AlignLeft | Qt::AlignVCenter);
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            return toolTip(row);
        default:
            return {};
    }
}

QVariant FoundModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) {
        return section == ConfidenceColumn ? int(Qt::AlignRight) : int(Qt::AlignLeft);
    }
    if (role == Qt::ToolTipRole && section == SourceColumn)
        return tr("Who says it; of several aspects the least sure");
    if (role == Qt::ToolTipRole && section == ConfidenceColumn)
        return tr("Confidence; of several aspects the least");
    if (role != Qt::DisplayRole) return {};
    const QString names[] = {tr("time"), tr("label"), tr("by"), tr("p")};
    return names[section];
}

FoundList::FoundList(LabelSession& labels, const QString& name, QWidget* parent)
    : QWidget(parent),
      labels_(labels),
      model_(new FoundModel(labels, this)),
      table_(new QTableView(this)),
      empty_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(table_, 1);
    layout->addWidget(empty_, 1);
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop);
    empty_->setProperty("role", "second");
    table_->setModel(model_);
    table_->setAccessibleName(name);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setTabKeyNavigation(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setMinimumHeight(72);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(22);
    QHeaderView* header = table_->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(30);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(FoundModel::LabelColumn, QHeaderView::Stretch);
    const QFontMetrics metrics = fontMetrics();
    header->resizeSection(FoundModel::TimeColumn,
                          metrics.horizontalAdvance(QStringLiteral("00:00.0")) + 10);
    header->resizeSection(FoundModel::SourceColumn,
                          metrics.horizontalAdvance(sourceWords(LabelSource::Machine)) + 10);
    header->resizeSection(FoundModel::ConfidenceColumn,
                          std::max(metrics.horizontalAdvance(QStringLiteral("0.00")),
                                   metrics.horizontalAdvance(sourceWords(LabelSource::Hand))) +
                              14);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &FoundList::rowsChosen);
    connect(&labels_, &LabelSession::choiceChanged, this, &FoundList::followCurrent);
    show({}, {});
}

void FoundList::show(std::vector<FoundRow> rows, const QString& said) {
    following_ = true;
    empty_->setText(said);
    empty_->setVisible(rows.empty());
    table_->setVisible(!rows.empty());
    model_->show(std::move(rows));
    following_ = false;
    followCurrent();
}

void FoundList::resizeEvent(QResizeEvent*) {
    const bool narrow = width() < kNarrow;
    table_->setColumnHidden(FoundModel::SourceColumn, narrow);
    model_->setBrief(narrow);
}

void FoundList::goToRow(int row) {
    const FoundRow& found = model_->rows()[static_cast<std::size_t>(row)];
    const int index = labels_.indexOf(found.fighter, found.peak);
    if (index < 0) return;
    labels_.goTo(labels_.actions()[static_cast<std::size_t>(index)]);
    labels_.session().transport().setPlaying(true);
}

void FoundList::rowsChosen() {
    if (following_) return;
    const QModelIndexList rows = table_->selectionModel()->selectedRows();
    if (rows.isEmpty()) return;
    following_ = true;
    if (rows.size() == 1) {
        goToRow(rows.front().row());
    } else {
        std::vector<ActionRef> chosen;
        const int current = table_->currentIndex().row();
        const auto add = [&](int row) {
            const FoundRow& found = model_->rows()[static_cast<std::size_t>(row)];
            if (found.fighter.take == labels_.session().take())
                chosen.push_back({found.fighter.player, found.peak});
        };
        for (const QModelIndex& row : rows) {
            if (row.row() != current) add(row.row());
        }
        if (current >= 0) add(current);
        labels_.choose(std::move(chosen));
    }
    following_ = false;
}

void FoundList::step(int direction) {
    const int count = model_->rowCount();
    if (count == 0) return;
    const QModelIndexList chosen = table_->selectionModel()->selectedRows();
    const int from = chosen.isEmpty() ? (direction > 0 ? -1 : 0) : table_->currentIndex().row();
    const int row = (from + direction + count) % count;
    table_->selectRow(row);
    table_->scrollTo(model_->index(row, 0));
}

void FoundList::chooseAll() {
    table_->selectAll();
}

void FoundList::followCurrent() {
    if (following_ || model_->rowCount() == 0) return;
    const ShownAction* current = labels_.current();
    const int row = current ? model_->rowOf(current->fighter, current->peak) : -1;
    if (labels_.chosen().size() > 1) return;
    following_ = true;
    if (row < 0) {
        table_->clearSelection();
    } else {
        table_->selectRow(row);
    }
    following_ = false;
}

}  // namespace kumite::studio
