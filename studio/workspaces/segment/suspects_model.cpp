#include "studio/workspaces/segment/suspects_model.h"

#include <QFont>
#include <QGuiApplication>
#include <QIcon>
#include <QPainter>
#include <QPalette>
#include <QPixmap>

#include <algorithm>
#include <tuple>

#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

QIcon dot(const QColor& colour) {
    QPixmap pixmap(8, 8);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QRectF(0.5, 0.5, 7, 7));
    painter.end();
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

}  // namespace

SuspectsModel::SuspectsModel(const Session& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session) {}

void SuspectsModel::refresh() {
    beginResetModel();
    rows_.clear();
    for (int player = 0; player < session_.playerCount(); ++player) {
        const FighterAnalysis* fighter = session_.fighter(player);
        if (fighter == nullptr) continue;
        for (const BoundaryMark& mark : session_.marks(player)) {
            if (!mark.minimum) continue;
            const auto& minimum = fighter->force->minima[static_cast<std::size_t>(*mark.minimum)];
            const BoundaryRef boundary{player, mark.frame};
            rows_.push_back({boundary, session_.timeOf(boundary), minimum.prominence,
                             mark.suspicion, !mark.isLive()});
        }
    }
    std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) {
        return std::tuple(-a.suspicion, a.seconds) < std::tuple(-b.suspicion, b.seconds);
    });
    endResetModel();
}

BoundaryRef SuspectsModel::boundaryAt(int row) const {
    return rows_[static_cast<std::size_t>(row)].boundary;
}

bool SuspectsModel::isRemoved(int row) const {
    return rows_[static_cast<std::size_t>(row)].removed;
}

int SuspectsModel::rowOf(const BoundaryRef& boundary) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(),
                                    [&](const Row& row) { return row.boundary == boundary; });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int SuspectsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SuspectsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant SuspectsModel::data(const QModelIndex& index, int role) const {
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const Colours& c = coloursFor(QGuiApplication::palette());
    switch (role) {
        case Qt::DisplayRole:
            if (index.column() == TimeColumn) return timeText(row.seconds);
            if (index.column() == ProminenceColumn) return bodyWeightsText(row.prominence);
            return percentText(row.suspicion);
        case Qt::DecorationRole:
            if (index.column() != TimeColumn) return {};
            return dot(c.fighters[row.boundary.player]);
        case Qt::TextAlignmentRole:
            return index.column() == TimeColumn ? int(Qt::AlignLeft | Qt::AlignVCenter)
                                                : int(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::FontRole: {
            QFont font;
            font.setStrikeOut(row.removed);
            return font;
        }
        case Qt::ForegroundRole:
            return row.removed ? c.secondText : c.text;
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            return tr("%1, %2, prominence %3, suspicion %4%5")
                .arg(fighterText(row.boundary.player), timeText(row.seconds),
                     bodyWeightsText(row.prominence), percentText(row.suspicion),
                     row.removed ? tr(", removed") : QString());
        default:
            return {};
    }
}

QVariant SuspectsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) {
        return section == TimeColumn ? int(Qt::AlignLeft) : int(Qt::AlignRight);
    }
    if (role == Qt::ToolTipRole) {
        if (section == ProminenceColumn) {
            return tr("How deep the minimum is against its surroundings, body weights");
        }
        if (section == SuspicionColumn) {
            return tr("How likely the minimum is spurious, learnt from what hands removed");
        }
    }
    if (role != Qt::DisplayRole) return {};
    if (section == TimeColumn) return tr("time");
    if (section == ProminenceColumn) return tr("promin.");
    return tr("suspic.");
}

}  // namespace kumite::studio
