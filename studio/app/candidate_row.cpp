#include "studio/app/candidate_row.h"

#include <QApplication>
#include <QPainter>

#include <algorithm>

#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

QString chanceText(double probability) {
    return probability < 0.005 ? QStringLiteral("<0.01") : numberText(probability, 2);
}

QSize candidateRowSize(const QStyleOptionViewItem& option) {
    return {100, 2 * option.fontMetrics.height() + 8};
}

void paintCandidateRow(QPainter& painter, const QStyleOptionViewItem& option,
                       const CandidateRow& row) {
    QStyleOptionViewItem ground = option;
    ground.text.clear();
    QApplication::style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &ground, &painter,
                                         option.widget);
    const Colours& c = coloursFor(option.palette);
    const QRectF area = QRectF(option.rect).adjusted(4, 3, -4, -3);
    const double line = option.fontMetrics.height();
    painter.save();
    QFont font = option.font;
    font.setBold(row.isTaken);
    painter.setFont(font);
    const QRectF first(area.left(), area.top(), area.width(), line);
    const double room = painter.fontMetrics().horizontalAdvance(row.chance) + 6;
    painter.setPen(row.isFaint ? c.secondText : c.text);
    painter.drawText(first, Qt::AlignRight | Qt::AlignVCenter, row.chance);
    const QString mark = row.isTaken ? QStringLiteral("▸ ") : QString();
    painter.drawText(first, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(mark + row.name, Qt::ElideMiddle,
                                                      static_cast<int>(first.width() - room)));
    font.setBold(false);
    font.setPointSizeF(std::max(7.5, font.pointSizeF() - 1.0));
    painter.setFont(font);
    // As wide in every row, so that the bars stand below each other.
    const QFontMetrics metrics = painter.fontMetrics();
    const double count = row.count.isEmpty()
                             ? 0
                             : std::max(metrics.horizontalAdvance(QStringLiteral("n 000")),
                                        metrics.horizontalAdvance(row.count) + 4);
    const double width = (area.width() - count) / static_cast<double>(row.bars.size());
    for (int i = 0; i < row.bars.size(); ++i) {
        const QRectF box(area.left() + i * width, area.top() + line + 2, width - 4, line - 2);
        painter.fillRect(box, mixed(c.panel, c.line, 0.45));
        QRectF part = box;
        part.setWidth(std::max(1.0, box.width() * std::clamp(row.bars[i].share, 0.0, 1.0)));
        painter.fillRect(part, mixed(c.panel, row.colour, c.dark ? 0.6 : 0.45));
        painter.setPen(row.isFaint ? c.secondText : c.text);
        painter.drawText(box.adjusted(3, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         row.bars[i].text);
    }
    painter.setPen(row.isCountFaint ? c.secondText : c.text);
    painter.drawText(QRectF(area.right() - count, area.top() + line + 2, count, line - 2),
                     Qt::AlignRight | Qt::AlignVCenter, row.count);
    painter.restore();
}

}  // namespace kumite::studio
