#include "studio/timeline/ruler.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/words.h"

namespace kumite::studio {

void paintRuler(QPainter& painter, const QRectF& ruler, const Session& session,
                const Colours& colours, const TimeMapping& mapping) {
    const QFont font = painter.font();
    QFont small = font;
    small.setPointSizeF(std::max(7.5, font.pointSizeF() - 1.0));
    painter.setFont(small);
    painter.fillRect(ruler, colours.panel);
    painter.setPen(colours.secondText);
    painter.drawText(QRectF(ruler.left() + 12, ruler.top(), mapping.left - 18, ruler.height()),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QCoreApplication::translate("kumite::studio::TimelineView", "time, frame"));
    const QRectF scale(mapping.left, ruler.top(), mapping.width, ruler.height());
    painter.save();
    painter.setClipRect(
        QRectF(scale.left() - 1, ruler.top(), ruler.right() - scale.left() + 1, ruler.height()));
    const double step = rulerStep(mapping.pixelsPerSecond(), 104);
    const double fine = step / 5;
    const FighterAnalysis* fighter = session.fighter(session.activePlayer());
    const auto first = static_cast<long long>(std::floor(mapping.begin / fine));
    const auto last = static_cast<long long>(std::ceil(mapping.end / fine));
    for (long long tick = first; tick <= last; ++tick) {
        const double seconds = static_cast<double>(tick) * fine;
        const double x = std::floor(mapping.xOf(seconds)) + 0.5;
        const bool labelled = tick % 5 == 0;
        if (x > scale.right() + 1) break;
        painter.setPen(labelled ? colours.secondText : colours.line);
        painter.drawLine(QPointF(x, ruler.bottom() - (labelled ? 8 : 4)),
                         QPointF(x, ruler.bottom()));
        if (!labelled || x < scale.left() - 1) continue;
        const QString time = timeText(seconds, step);
        const QRectF room(x + 4, ruler.top(), 100, ruler.height() - 3);
        painter.setPen(colours.text);
        QRectF used;
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, time, &used);
        if (fighter == nullptr) continue;
        const auto frame = std::llround((seconds - fighter->input.offset) * fighter->input.rate);
        if (frame < 0 || frame >= fighter->frameCount()) continue;
        const QString number = QString::number(frame);
        const double from = used.right() + 6;
        if (from + painter.fontMetrics().horizontalAdvance(number) > ruler.right() - 2) continue;
        painter.setPen(colours.secondText);
        painter.drawText(QRectF(from, room.top(), 60, room.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, number);
    }
    const Transport& transport = session.transport();
    if (transport.loopIn() || transport.loopOut()) {
        const double from = mapping.xOf(transport.loopIn().value_or(transport.span().begin));
        const double to = mapping.xOf(transport.loopOut().value_or(transport.span().end));
        painter.fillRect(QRectF(from, ruler.top(), to - from, 4),
                         withAlpha(colours.accent, transport.isLooping() ? 0.9 : 0.4));
    }
    painter.restore();
    painter.setPen(colours.line);
    painter.drawLine(QPointF(ruler.left(), ruler.bottom()), QPointF(ruler.right(), ruler.bottom()));
    painter.setFont(font);
}

void paintMarker(QPainter& painter, const QRectF& ruler, double bottom, const TimeMapping& mapping,
                 const TimeMarker& marker) {
    const double x = std::floor(mapping.xOf(marker.seconds)) + 0.5;
    if (x < mapping.left - 1 || x > mapping.left + mapping.width + 1) return;
    painter.setPen(QPen(marker.colour, marker.width, marker.line));
    painter.drawLine(QPointF(x, ruler.bottom() - 3), QPointF(x, bottom));
    if (marker.text.isEmpty()) return;
    const double width = painter.fontMetrics().horizontalAdvance(marker.text) + 12;
    const double left = std::clamp(x - width / 2, mapping.left, ruler.right() - width - 2);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(marker.colour);
    painter.drawRoundedRect(QRectF(left, ruler.top() + 2, width, ruler.height() - 5), 4, 4);
    painter.setPen(marker.textColour);
    painter.drawText(QRectF(left, ruler.top() + 2, width, ruler.height() - 5), Qt::AlignCenter,
                     marker.text);
}

}  // namespace kumite::studio
