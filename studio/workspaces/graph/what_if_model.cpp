#include "studio/workspaces/graph/what_if_model.h"

#include <QApplication>
#include <QPainter>

#include <algorithm>

#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

/// "0.42", "<0.01": two digits tell candidates apart.
QString shortNumber(double p) {
    return p < 0.005 ? QStringLiteral("<0.01") : QString::number(p, 'f', 2);
}

}  // namespace

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
    QString text =
        tr("%1: P %2, label term %3")
            .arg(name, QString::number(row.product, 'f', 3), QString::number(row.label, 'f', 3));
    if (geometry_) text += tr(", geometry term %1").arg(QString::number(row.geometry, 'f', 3));
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
    return {100, 2 * option.fontMetrics.height() + 8};
}

void WhatIfDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    QStyleOptionViewItem ground = option;
    ground.text.clear();
    QApplication::style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &ground, painter,
                                         option.widget);
    const Colours& c = coloursFor(option.palette);
    const NextLabel& row = model_.rows()[static_cast<std::size_t>(index.row())];
    const QColor colour = c.fighters[model_.mover()];
    const QRectF area = QRectF(option.rect).adjusted(4, 3, -4, -3);
    const double line = option.fontMetrics.height();
    painter->save();
    QFont font = option.font;
    const bool actual = model_.isActual(index.row());
    font.setBold(actual);
    painter->setFont(font);
    const QRectF first(area.left(), area.top(), area.width(), line);
    const QString p = tr("P %1").arg(shortNumber(row.product));
    const double room = painter->fontMetrics().horizontalAdvance(p) + 6;
    painter->setPen(c.text);
    painter->drawText(first, Qt::AlignRight | Qt::AlignVCenter, p);
    const QString mark = actual ? QStringLiteral("▸ ") : QString();
    painter->drawText(
        first, Qt::AlignLeft | Qt::AlignVCenter,
        painter->fontMetrics().elidedText(mark + index.data().toString(), Qt::ElideMiddle,
                                          static_cast<int>(first.width() - room)));
    font.setBold(false);
    font.setPointSizeF(std::max(7.5, font.pointSizeF() - 1.0));
    painter->setFont(font);
    const double count = 30;
    const int terms = model_.hasGeometry() ? 2 : 1;
    const double width = (area.width() - count) / terms;
    const auto bar = [&](int place, const QString& text, double share) {
        const QRectF box(area.left() + place * width, area.top() + line + 2, width - 4, line - 2);
        painter->fillRect(box, mixed(c.panel, c.line, 0.45));
        QRectF part = box;
        part.setWidth(std::max(1.0, box.width() * std::clamp(share, 0.0, 1.0)));
        painter->fillRect(part, mixed(c.panel, colour, c.dark ? 0.6 : 0.45));
        painter->setPen(c.text);
        painter->drawText(box.adjusted(3, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
    };
    bar(0, tr("label %1").arg(shortNumber(row.label)), row.label);
    if (terms == 2) bar(1, tr("geom. %1").arg(shortNumber(row.geometry)), row.geometry);
    painter->setPen(row.examples > 0 ? c.text : c.secondText);
    painter->drawText(QRectF(area.right() - count, area.top() + line + 2, count, line - 2),
                      Qt::AlignRight | Qt::AlignVCenter, tr("n %1").arg(row.examples));
    painter->restore();
}

}  // namespace kumite::studio
