#include "studio/timeline/track_painter.h"

#include <QPainter>
#include <QtMath>

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"
#include "studio/app/words.h"
#include "studio/timeline/curve_painter.h"
#include "studio/timeline/mark_painter.h"

namespace kumite::studio {

QFont smallFont(const QPainter& painter) {
    QFont font = painter.font();
    font.setPointSizeF(std::max(7.5, font.pointSizeF() - 1.0));
    return font;
}

SampleAxis frameAxis(const Fighter& fighter, const TimeMapping& mapping) {
    return {mapping.xOf(fighter.offset), mapping.pixelsPerSecond() / fighter.rate};
}

TrackPainter::TrackPainter(QPainter& painter, const Session& session, const Colours& colours,
                           const TimeMapping& mapping)
    : painter_(painter), session_(session), colours_(colours), mapping_(mapping) {}

void TrackPainter::paint(const Track& track, int player) {
    paintHeader(track, player);
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) {
        paintNote(track, tr("The recording of %1 is missing. File ▸ Find recording… points to it.")
                             .arg(fighterText(player)));
        return;
    }
    const bool hasCurve = track.hasCurve();
    if (hasCurve) paintForceAxis(track);
    for (const SpeedRow& row : track.speeds())
        paintSpeedAxis(row, player);
    painter_.save();
    painter_.setClipRect(track.row().adjusted(track.plot().left() - track.row().left(), 0,
                                              track.plot().right() - track.row().right(), 0));
    painter_.setRenderHint(QPainter::Antialiasing);
    MarkPainter marks(painter_, session_, colours_, mapping_);
    marks.paintActions(track, player);
    marks.paintComparison(track, player);
    marks.paintBoundaries(track, player);
    paintCurves(track, fighter->input, player);
    if (hasCurve) {
        marks.paintMinima(track, player);
        marks.paintSuspects(track, player);
    } else {
        paintNote(track,
                  tr("No contact force: this skeleton has no body that is known here. S adds "
                     "boundaries by hand."));
    }
    painter_.restore();
}

void TrackPainter::paintNote(const Track& track, const QString& text) {
    painter_.setPen(colours_.secondText);
    painter_.drawText(track.plot(), Qt::AlignCenter, text);
}

void TrackPainter::paintHeader(const Track& track, int player) {
    const QRectF row = track.row();
    const bool active = player == session_.activePlayer();
    if (active && session_.playerCount() > 1) {
        painter_.fillRect(QRectF(row.left(), row.top() + 1, row.width(), row.height() - 2),
                          mixed(colours_.ground, colours_.line, colours_.dark ? 0.28 : 0.30));
    }
    painter_.fillRect(QRectF(row.left(), row.top() + 1, 4, row.height() - 2),
                      colours_.fighters[player]);
    const QFont font = painter_.font();
    QFont name = font;
    name.setBold(active);
    painter_.setFont(name);
    painter_.setPen(active ? colours_.text : colours_.secondText);
    const double left = row.left() + 12;
    const double lineHeight = painter_.fontMetrics().height();
    const double width = track.plot().left() - left - 30;
    painter_.drawText(QRectF(left, row.top() + 5, width + 20, lineHeight), Qt::AlignLeft,
                      fighterText(player));
    painter_.setFont(font);
    painter_.setFont(smallFont(painter_));
    const auto legend = [&](int line, const QColor& colour, double pen, const QString& text) {
        const double y = row.top() + 5 + lineHeight + 3 + line * (lineHeight - 1);
        if (y + lineHeight > track.plot().bottom() + 4) return;
        painter_.setPen(QPen(colour, pen));
        painter_.drawLine(QPointF(left, y + lineHeight / 2),
                          QPointF(left + 10, y + lineHeight / 2));
        painter_.setPen(colours_.secondText);
        painter_.drawText(QRectF(left + 15, y, width, lineHeight), Qt::AlignLeft | Qt::AlignVCenter,
                          text);
    };
    int line = 0;
    legend(line++, colours_.fighterText[player], 2, tr("force, BW"));
    if (track.rawForce().size() > 0) {
        legend(line++, withAlpha(colours_.fighterText[player], 0.4), 1, tr("unsmoothed"));
    }
    if (track.height().size() > 0) {
        legend(line++, withAlpha(colours_.secondText, 0.75), 1, tr("COM, m"));
    }
    painter_.setFont(font);
}

void TrackPainter::paintForceAxis(const Track& track) {
    const QFont font = painter_.font();
    painter_.setFont(smallFont(painter_));
    const QRectF plot = track.plot();
    const ValueAxis& axis = track.forceAxis();
    const double lineHeight = painter_.fontMetrics().height();
    const double perHalf = 0.5 * plot.height() / (axis.high - axis.low);
    const int step = perHalf >= lineHeight ? 1 : 2 * std::max(1, qCeil(lineHeight / (2 * perHalf)));
    for (int half = qCeil(2 * axis.low); half <= 2 * axis.high; ++half) {
        if (step > 1 && half % 2 != 0) continue;
        const double weight = 0.5 * half;
        const double y = std::round(track.yOfForce(weight)) + 0.5;
        // One body weight is what standing still reads: the line that everything is measured by.
        const bool rest = half == 2;
        painter_.setPen(QPen(rest ? mixed(colours_.line, colours_.secondText, 0.45)
                                  : mixed(colours_.ground, colours_.line, 0.8),
                             1, rest ? Qt::DashLine : Qt::SolidLine));
        painter_.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        if (half % step != 0) continue;
        painter_.setPen(colours_.secondText);
        painter_.drawText(QRectF(plot.left() - withTextSize(34), y - lineHeight / 2,
                                 withTextSize(29), lineHeight),
                          Qt::AlignRight | Qt::AlignVCenter, numberText(weight));
    }
    painter_.setPen(withAlpha(colours_.secondText, 0.9));
    if (track.height().size() == 0) {
        painter_.setFont(font);
        return;
    }
    const auto height = [&](double metres, double y) {
        painter_.drawText(QRectF(plot.right() + 5, y, withTextSize(40), lineHeight), Qt::AlignLeft,
                          tr("%1 m").arg(numberText(metres, 1)));
    };
    height(track.heightAxis().high, plot.top() - 3);
    if (plot.height() < 2 * lineHeight - 6) return painter_.setFont(font);  // no room for both
    height(track.heightAxis().low, plot.bottom() - lineHeight + 3);
    painter_.setFont(font);
}

void TrackPainter::paintSpeedAxis(const SpeedRow& row, int player) {
    const QFont font = painter_.font();
    painter_.setFont(smallFont(painter_));
    const double lineHeight = painter_.fontMetrics().height();
    painter_.setPen(mixed(colours_.ground, colours_.line, 0.8));
    for (const double y : {row.plot.top(), row.plot.bottom()}) {
        const double pixel = std::round(y) + 0.5;
        painter_.drawLine(QPointF(row.plot.left(), pixel), QPointF(row.plot.right(), pixel));
    }
    painter_.setPen(colours_.secondText);
    painter_.drawText(QRectF(row.plot.left() - withTextSize(34), row.plot.top() - 3,
                             withTextSize(29), lineHeight),
                      Qt::AlignRight, numberText(row.axis.high));
    const double left = 12;
    const QString text = row.hands ? tr("hands, m/s") : tr("feet, m/s");
    painter_.drawText(QRectF(left, row.plot.top() - 3, row.plot.left() - left - 30, lineHeight),
                      Qt::AlignLeft, text);
    if (row.plot.height() >= 2 * lineHeight - 2) {
        // Which side is which: the stronger colour is the left one.
        const double y = row.plot.top() - 3 + 1.5 * lineHeight;
        double x = left;
        for (const bool leftSide : {true, false}) {
            painter_.setPen(QPen(
                leftSide ? colours_.fighterText[player] : withAlpha(colours_.text, 0.55), 1.4));
            painter_.drawLine(QPointF(x, y), QPointF(x + 8, y));
            painter_.setPen(colours_.secondText);
            const QString side = leftSide ? tr("left") : tr("right");
            painter_.drawText(QRectF(x + 11, y - lineHeight / 2, 40, lineHeight),
                              Qt::AlignLeft | Qt::AlignVCenter, side);
            x += 11 + painter_.fontMetrics().horizontalAdvance(side) + 8;
        }
    }
    painter_.setFont(font);
}

void TrackPainter::paintCurves(const Track& track, const Fighter& fighter, int player) {
    const SampleAxis axis = frameAxis(fighter, mapping_);
    const QRectF plot = track.plot();
    const QColor own = colours_.fighterText[player];
    const auto faint = [this](const QColor& colour, double share) {
        return mixed(colours_.ground, colour, share);
    };
    // No bigger than what the curves take: it is cleared and laid over the row as a whole.
    constexpr double kAir = 2;
    QRectF area = plot;
    for (const SpeedRow& speed : track.speeds())
        area |= speed.plot;
    CurvePicture curves(area.adjusted(0, -kAir, 0, kAir), painter_.device()->devicePixelRatioF());
    // The noise of the unsmoothed force may be higher than the axis, and so may rare speeds be.
    curves.draw(track.rawForce(), axis, track.forceAxis(), plot, faint(own, 0.35), 1.0);
    curves.draw(track.height(), axis, track.heightAxis(), plot, faint(colours_.secondText, 0.75),
                1.0);
    for (const SpeedRow& speed : track.speeds()) {
        curves.draw(speed.sides[1], axis, speed.axis, speed.plot, faint(colours_.text, 0.45), 1.0);
        curves.draw(speed.sides[0], axis, speed.axis, speed.plot, own, 1.0);
    }
    curves.draw(track.forceCurve(), axis, track.forceAxis(), plot, own, 1.4);
    curves.paintOnto(painter_);
}

}  // namespace kumite::studio
