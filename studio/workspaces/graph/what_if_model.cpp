#include "studio/workspaces/graph/what_if_model.h"

#include <algorithm>

#include "studio/app/candidate_row.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

WhatIfModel::WhatIfModel(const GraphSession& graph, QObject* parent)
    : QAbstractListModel(parent), graph_(graph) {}

void WhatIfModel::show(int mover, std::vector<NextLabel> rows, bool geometry) {
    beginResetModel();
    mover_ = mover;
    rows_ = std::move(rows);
    geometry_ = geometry;
    endResetModel();
}

void WhatIfModel::setActual(int node) {
    if (node == actual_) return;
    actual_ = node;
    if (!rows_.empty()) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

int WhatIfModel::rowOf(int node) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(),
                                    [&](const NextLabel& row) { return row.node == node; });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int WhatIfModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant WhatIfModel::data(const QModelIndex& index, int role) const {
    const NextLabel& row = rows_[static_cast<std::size_t>(index.row())];
    const QString name = graph_.nameOf(mover_, row.node);
    if (role == Qt::DisplayRole) return name;
    if (role != Qt::ToolTipRole && role != Qt::AccessibleTextRole) return {};
    QString text = tr("%1: P %2, label term %3")
                       .arg(name, numberText(row.product, 3), numberText(row.label, 3));
    if (geometry_) text += tr(", geometry term %1").arg(numberText(row.geometry, 3));
    text += tr("\nSeen %1 times with both labels, %2 with the own, %3 with the opponent's")
                .arg(row.examples)
                .arg(row.ownExamples)
                .arg(row.opponentExamples);
    if (row.node == actual_) text += tr("\nThis is what came next");
    return text;
}

WhatIfDelegate::WhatIfDelegate(const WhatIfModel& model, QObject* parent)
    : QStyledItemDelegate(parent), model_(model) {}

QSize WhatIfDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return candidateRowSize(option);
}

void WhatIfDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    const NextLabel& next = model_.rows()[static_cast<std::size_t>(index.row())];
    CandidateRow row;
    row.name = index.data().toString();
    row.chance = tr("P %1").arg(chanceText(next.product));
    row.isTaken = model_.isActual(index.row());
    row.colour = coloursFor(option.palette).fighters[model_.mover()];
    row.bars.append({tr("label %1").arg(chanceText(next.label)), next.label});
    if (model_.hasGeometry()) {
        row.bars.append({tr("geom. %1").arg(chanceText(next.geometry)), next.geometry});
    }
    row.count = tr("n %1").arg(next.examples);
    row.isCountFaint = next.examples == 0;
    paintCandidateRow(*painter, option, row);
}

}  // namespace kumite::studio
