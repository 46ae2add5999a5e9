#include "studio/app/history_model.h"

#include <QFont>
#include <QPainter>
#include <QPixmap>

#include "studio/app/core_words.h"
#include "studio/app/document.h"
#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

QPixmap dot(const QColor& colour) {
    constexpr double kRatio = 2;
    QPixmap pixmap(QSize(10, 10) * kRatio);
    pixmap.setDevicePixelRatio(kRatio);
    pixmap.fill(Qt::transparent);
    if (colour.isValid()) {
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(QRectF(2, 2, 6, 6));
    }
    return pixmap;
}

}  // namespace

HistoryModel::HistoryModel(const Document& document, QObject* parent)
    : QAbstractListModel(parent), document_(document) {}

void HistoryModel::refresh(const QPalette& palette) {
    const Colours& c = coloursFor(palette);
    undone_ = mixed(c.secondText, c.panel, 0.4);
    mark_ = c.accent;
    const int steps = document_.isOpen() ? static_cast<int>(document_.history().steps().size()) : 0;
    if (steps != rows_) {
        beginResetModel();
        rows_ = steps;
        endResetModel();
    } else if (steps > 0) {
        Q_EMIT dataChanged(index(0), index(steps - 1));
    }
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rows_;
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
    const History& history = document_.history();
    const auto step = static_cast<std::size_t>(index.row());
    if (!index.isValid() || step >= history.steps().size()) return {};
    const bool current = step == history.position();
    const QString name = coreWords(history.steps()[step].name);
    switch (role) {
        case Qt::DisplayRole:
            return name;
        case Qt::ToolTipRole:
            if (current) return tr("%1\nThe project as it is now.").arg(name);
            return step < history.position()
                       ? tr("%1\nClick to go back to this state.").arg(name)
                       : tr("%1\nUndone. Click to redo up to here.").arg(name);
        case Qt::AccessibleTextRole:
            return step > history.position() ? tr("%1, undone").arg(name)
                   : current                 ? tr("%1, now").arg(name)
                                             : name;
        case Qt::DecorationRole:
            return dot(current ? mark_ : QColor());
        case Qt::ForegroundRole:
            return step > history.position() ? QVariant(undone_) : QVariant();
        default:
            return {};
    }
}

}  // namespace kumite::studio
