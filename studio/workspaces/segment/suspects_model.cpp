#include "studio/workspaces/segment/suspects_model.h"

#include <QFont>
#include <QGuiApplication>
#include <QIcon>
#include <QPainter>
#include <QPalette>
#include <QPixmap>

#include <algorithm>

#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

QIcon dot(const QColor& colour) {
    constexpr double kRatio = 2;  // sharp on dense screens, too
    QPixmap pixmap(QSize(8, 8) * kRatio);
    pixmap.setDevicePixelRatio(kRatio);
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

QString stateText(MarkState state) {
    switch (state) {
        case MarkState::Removed:
            return SuspectsModel::tr(", removed");
        case MarkState::Accepted:
            return SuspectsModel::tr(", accepted");
        case MarkState::Moved:
        case MarkState::Added:
            return SuspectsModel::tr(", set by hand");
        case MarkState::Detected:
        case MarkState::End:
            break;
    }
    return {};
}

}  // namespace

SuspectsModel::SuspectsModel(const Session& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session) {}

void SuspectsModel::refresh() {
    beginResetModel();
    rows_ = suspectsOf(session_);
    endResetModel();
}

std::optional<SuspectReason> SuspectsModel::reasonOf(int row) const {
    const Suspect& suspect = suspectAt(row);
    const FighterAnalysis* fighter = session_.fighter(suspect.boundary.player);
    if (fighter == nullptr || !fighter->force) return std::nullopt;
    return suspectReason(*fighter, suspect.minimum);
}

QString SuspectsModel::reasonAt(int row) const {
    const auto reason = reasonOf(row);
    return (reason ? reasonText(*reason) : QString()) + stateText(suspectAt(row).state);
}

QString SuspectsModel::toldAt(int row) const {
    const Suspect& suspect = suspectAt(row);
    return tr("%1, suspicion %2: %3")
        .arg(fighterText(suspect.boundary.player), percentText(suspect.suspicion), reasonAt(row));
}

int SuspectsModel::rowOf(const BoundaryRef& boundary) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(),
                                    [&](const Suspect& row) { return row.boundary == boundary; });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int SuspectsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SuspectsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant SuspectsModel::data(const QModelIndex& index, int role) const {
    const Suspect& row = suspectAt(index.row());
    const Colours& c = coloursFor(QGuiApplication::palette());
    switch (role) {
        case Qt::DisplayRole:
            if (index.column() == TimeColumn) return timeText(row.seconds, 0.01);
            if (index.column() == ReasonColumn) {
                const auto reason = reasonOf(index.row());
                return reason ? shortReasonText(*reason) : QString();
            }
            if (row.isOpen()) return percentText(row.suspicion);
            return row.state == MarkState::Removed ? QStringLiteral("×") : QStringLiteral("✓");
        case Qt::DecorationRole:
            if (index.column() != TimeColumn) return {};
            return dot(c.fighters[row.boundary.player]);
        case Qt::TextAlignmentRole:
            return index.column() == SuspicionColumn ? int(Qt::AlignRight | Qt::AlignVCenter)
                                                     : int(Qt::AlignLeft | Qt::AlignVCenter);
        case Qt::FontRole: {
            QFont font;
            font.setStrikeOut(row.state == MarkState::Removed);
            return font;
        }
        case Qt::ForegroundRole:
            // Those that are worth a look stand out from the rest.
            return row.isOpen() && row.suspicion >= kSuspect ? c.text : c.secondText;
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            return tr("%1, %2").arg(timeText(row.seconds), toldAt(index.row()));
        default:
            return {};
    }
}

QVariant SuspectsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) {
        return section == SuspicionColumn ? int(Qt::AlignRight) : int(Qt::AlignLeft);
    }
    if (role == Qt::ToolTipRole) {
        if (section == ReasonColumn) {
            return tr("What speaks against the minimum, and how deep it is");
        }
        if (section == SuspicionColumn) {
            return tr(
                "How likely the minimum is spurious, learnt from what hands removed "
                "and accepted; ✓ accepted or set by hand, × removed");
        }
    }
    if (role != Qt::DisplayRole) return {};
    if (section == TimeColumn) return tr("time");
    if (section == ReasonColumn) return tr("why");
    return tr("susp.");
}

}  // namespace kumite::studio
