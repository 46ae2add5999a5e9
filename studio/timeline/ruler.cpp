#include "studio/timeline/ruler.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/words.h"
#include "studio/timeline/loop_handles.h"

namespace kumite::studio {

namespace {

/// Labels at round times, with the frames there; or at round frames.
struct Scale {
    double step = 1;    ///< seconds between labels
    double origin = 0;  ///< seconds of the label 0
};

Scale scaleOf(const TimeMapping& mapping, const Fighter* fighter, RulerUnits units) {
    const double apart = withTextSize(104.0);  // pixels
    if (units != RulerUnits::Frames || fighter == nullptr) {
        return {rulerStep(mapping.pixelsPerSecond(), apart), 0};
    }
    return {frameStep(mapping.pixelsPerSecond() / fighter->rate, apart) / fighter->rate,
            fighter->offset};
}

void paintLoop(QPainter& painter, const QRectF& ruler, const Transport& transport,
               const Colours& colours, const TimeMapping& mapping) {
    const auto range = loopRange(transport);
    if (!range) return;
    const double from = mapping.xOf(range->begin);
    const double to = mapping.xOf(range->end);
    const QColor colour = withAlpha(colours.accent, transport.isLooping() ? 0.9 : 0.4);
    painter.fillRect(QRectF(from, ruler.top(), to - from, 4), colour);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const QPointF in[] = {{from, ruler.top()}, {from + 7, ruler.top()}, {from, ruler.top() + 11}};
    const QPointF out[] = {{to, ruler.top()}, {to - 7, ruler.top()}, {to, ruler.top() + 11}};
    painter.drawPolygon(in, 3);
    painter.drawPolygon(out, 3);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace

void paintRuler(QPainter& painter, const QRectF& ruler, const Session& session,
                const Colours& colours, const TimeMapping& mapping, RulerUnits units) {
    const QFont font = painter.font();
    QFont small = font;
    small.setPointSizeF(std::max(7.5, font.pointSizeF() - 1.0));
    painter.setFont(small);
    painter.fillRect(ruler, colours.panel);
    painter.setPen(colours.secondText);
    const char* const kCaptions[] = {
        QT_TRANSLATE_NOOP("kumite::studio::TimelineView", "time, frame"),
        QT_TRANSLATE_NOOP("kumite::studio::TimelineView", "time"),
        QT_TRANSLATE_NOOP("kumite::studio::TimelineView", "frame")};
    painter.drawText(QRectF(ruler.left() + 12, ruler.top(), mapping.left - 18, ruler.height()),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QCoreApplication::translate("kumite::studio::TimelineView",
                                                 kCaptions[static_cast<int>(units)]));
    const QRectF area(mapping.left, ruler.top(), mapping.width, ruler.height());
    painter.save();
    painter.setClipRect(
        QRectF(area.left() - 1, ruler.top(), ruler.right() - area.left() + 1, ruler.height()));
    const FighterAnalysis* analysed = session.fighter(session.activePlayer());
    const Fighter* fighter = analysed ? &analysed->input : nullptr;
    const Scale scale = scaleOf(mapping, fighter, units);
    const double fine = scale.step / 5;
    const auto first = static_cast<long long>(std::floor((mapping.begin - scale.origin) / fine));
    const auto last = static_cast<long long>(std::ceil((mapping.end - scale.origin) / fine));
    for (long long tick = first; tick <= last; ++tick) {
        const double seconds = scale.origin + static_cast<double>(tick) * fine;
        const double x = std::floor(mapping.xOf(seconds)) + 0.5;
        const bool labelled = tick % 5 == 0;
        if (x > area.right() + 1) break;
        painter.setPen(labelled ? colours.secondText : colours.line);
        painter.drawLine(QPointF(x, ruler.bottom() - (labelled ? 8 : 4)),
                         QPointF(x, ruler.bottom()));
        if (!labelled || x < area.left() - 1) continue;
        double from = x + 4;
        const auto label = [&](const QString& text, const QColor& colour) {
            const double width = painter.fontMetrics().horizontalAdvance(text);
            if (from + width > ruler.right() - 2) return;
            painter.setPen(colour);
            painter.drawText(QRectF(from, ruler.top(), width + 2, ruler.height() - 3),
                             Qt::AlignLeft | Qt::AlignVCenter, text);
            from += width + 6;
        };
        if (units != RulerUnits::Frames) label(timeText(seconds, scale.step), colours.text);
        if (fighter == nullptr || units == RulerUnits::Time) continue;
        const auto frame = std::llround((seconds - fighter->offset) * fighter->rate);
        if (frame < 0 || frame >= analysed->frameCount()) continue;
        label(QString::number(frame),
              units == RulerUnits::Frames ? colours.text : colours.secondText);
    }
    paintLoop(painter, ruler, session.transport(), colours, mapping);
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
