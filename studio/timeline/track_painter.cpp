#include "studio/timeline/track_painter.h"

#include <QPainter>
#include <QPainterPath>
#include <QtMath>

#include <algorithm>
#include <cmath>

#include "studio/app/words.h"

namespace kumite::studio {

namespace {

QFont smallFont(const QPainter& painter) {
    QFont font = painter.font();
    font.setPointSizeF(std::max(7.5, font.pointSizeF() - 1.0));
    return font;
}

void cross(QPainter& painter, const QPointF& centre, double half) {
    painter.drawLine(centre - QPointF(half, half), centre + QPointF(half, half));
    painter.drawLine(centre - QPointF(half, -half), centre + QPointF(half, -half));
}

}  // namespace

TrackPainter::TrackPainter(QPainter& painter, const Session& session, const Colours& colours,
                           const TimeMapping& mapping)
    : painter_(painter), session_(session), colours_(colours), mapping_(mapping) {}

double TrackPainter::xOfFrame(const Fighter& fighter, double frame) const {
    return mapping_.xOf(timeOfFrame(fighter, frame));
}

void TrackPainter::paint(const Track& track, int player) {
    paintHeader(track, player);
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) {
        paintNote(track, tr("The recording of %1 is missing. File ▸ Find recording… points to it.")
                             .arg(fighterText(player)));
        return;
    }
    const bool hasCurve = track.hasCurve();
    if (hasCurve) paintAxes(track);
    painter_.save();
    painter_.setClipRect(track.row().adjusted(track.plot().left() - track.row().left(), 0,
                                              track.plot().right() - track.row().right(), 0));
    painter_.setRenderHint(QPainter::Antialiasing);
    paintActions(track, *fighter, player);
    if (hasCurve) {
        paintCurve(track, fighter->input, false, withAlpha(colours_.secondText, 0.75));
        paintCurve(track, fighter->input, true, colours_.fighterText[player]);
        paintMinima(track, *fighter, player);
    } else {
        paintNote(track,
                  tr("No contact force: this skeleton has no body that is known here. S adds "
                     "boundaries by hand."));
    }
    paintBoundaries(track, *fighter, player);
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
                          withAlpha(colours_.line, colours_.dark ? 0.28 : 0.30));
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
        if (y + lineHeight > row.bottom() + 2) return;
        painter_.setPen(QPen(colour, pen));
        painter_.drawLine(QPointF(left, y + lineHeight / 2),
                          QPointF(left + 10, y + lineHeight / 2));
        painter_.setPen(colours_.secondText);
        painter_.drawText(QRectF(left + 15, y, width, lineHeight), Qt::AlignLeft | Qt::AlignVCenter,
                          text);
    };
    legend(0, colours_.fighterText[player], 2, tr("force, BW"));
    legend(1, withAlpha(colours_.secondText, 0.75), 1, tr("COM, m"));
    painter_.setFont(font);
}

void TrackPainter::paintAxes(const Track& track) {
    const QFont font = painter_.font();
    painter_.setFont(smallFont(painter_));
    const QRectF plot = track.plot();
    const double lineHeight = painter_.fontMetrics().height();
    const double perHalf = 0.5 * plot.height() / (track.forceTop() - track.forceLow());
    const int step = perHalf >= lineHeight ? 1 : 2 * std::max(1, qCeil(lineHeight / (2 * perHalf)));
    for (int half = qCeil(2 * track.forceLow()); half <= 2 * track.forceTop(); ++half) {
        if (step > 1 && half % 2 != 0) continue;
        const double weight = 0.5 * half;
        const double y = std::round(track.yOfForce(weight)) + 0.5;
        // One body weight is what standing still reads: the line that everything is measured by.
        const bool rest = half == 2;
        painter_.setPen(QPen(
            rest ? mixed(colours_.line, colours_.secondText, 0.45) : withAlpha(colours_.line, 0.8),
            1, rest ? Qt::DashLine : Qt::SolidLine));
        painter_.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        if (half % step != 0) continue;
        painter_.setPen(colours_.secondText);
        painter_.drawText(QRectF(plot.left() - 34, y - lineHeight / 2, 29, lineHeight),
                          Qt::AlignRight | Qt::AlignVCenter, QString::number(weight));
    }
    painter_.setPen(withAlpha(colours_.secondText, 0.9));
    const auto height = [&](double metres, double y) {
        painter_.drawText(QRectF(plot.right() + 5, y, 40, lineHeight), Qt::AlignLeft,
                          tr("%1 m").arg(metres, 0, 'f', 1));
    };
    height(track.heightHigh(), plot.top() - 3);
    height(track.heightLow(), plot.bottom() - lineHeight + 3);
    painter_.setFont(font);
}

void TrackPainter::paintCurve(const Track& track, const Fighter& fighter, bool force,
                              const QColor& colour) {
    const CurvePyramid& curve = force ? track.forceCurve() : track.height();
    if (curve.size() == 0) return;
    const auto yOf = [&](double value) {
        return force ? track.yOfForce(value) : track.yOfHeight(value);
    };
    const auto frameAt = [&](double x) {
        return (mapping_.timeAt(x) - fighter.offset) * fighter.rate;
    };
    const double left = track.plot().left();
    const double right = track.plot().right();
    const auto last = static_cast<double>(curve.size()) - 1;
    const double framesPerPixel = fighter.rate / mapping_.pixelsPerSecond();
    QPolygonF line;
    if (framesPerPixel < 1.5) {
        const auto first = static_cast<int>(std::clamp(std::floor(frameAt(left)) - 1, 0.0, last));
        const auto end = static_cast<int>(std::clamp(std::ceil(frameAt(right)) + 1, 0.0, last));
        for (int frame = first; frame <= end; ++frame) {
            line << QPointF(xOfFrame(fighter, frame),
                            yOf(curve.at(static_cast<std::size_t>(frame))));
        }
    } else {
        for (double x = left; x < right; x += 1) {
            const double from = std::floor(frameAt(x));
            const double to = std::floor(frameAt(x + 1));
            if (to <= 0 || from > last) continue;
            const auto begin = static_cast<std::size_t>(std::clamp(from, 0.0, last));
            const auto end = static_cast<std::size_t>(std::clamp(to, 0.0, last)) + 1;
            const CurveExtent extent = curve.extent(begin, std::max(begin + 1, end));
            line << QPointF(x + 0.5, yOf(extent.low)) << QPointF(x + 0.5, yOf(extent.high));
        }
    }
    painter_.setPen(QPen(colour, force ? 1.4 : 1.0));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(line);
}

void TrackPainter::paintActions(const Track& track, const FighterAnalysis& fighter, int player) {
    const QRectF strip = track.strip();
    const QColor tint = colours_.fighters[player];
    const QFont font = painter_.font();
    painter_.setFont(smallFont(painter_));
    const auto& actions = fighter.segmentation->actions;
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const double from = xOfFrame(fighter.input, actions[i].begin);
        const double to = xOfFrame(fighter.input, actions[i].end);
        if (to < strip.left() || from > strip.right()) continue;
        const double gap = to - from > 5 ? 1 : 0;
        const QRectF block(from, strip.top(), to - from - gap, strip.height());
        painter_.fillRect(block, withAlpha(tint, i % 2 == 0 ? 0.50 : 0.28));
        const double peak = xOfFrame(fighter.input, actions[i].peak);
        if (to - from > 8) {
            QPainterPath notch;
            notch.moveTo(peak - 3, strip.top());
            notch.lineTo(peak + 3, strip.top());
            notch.lineTo(peak, strip.top() + 4);
            notch.closeSubpath();
            painter_.fillPath(notch, withAlpha(colours_.text, 0.8));
        }
        if (to - from > 44) {
            painter_.setPen(colours_.text);
            painter_.drawText(block.adjusted(5, 0, -3, 0), Qt::AlignLeft | Qt::AlignVCenter,
                              QString::number(i + 1));
        }
    }
    painter_.setFont(font);
}

void TrackPainter::paintMinima(const Track& track, const FighterAnalysis& fighter, int player) {
    const auto& minima = fighter.force->minima;
    const double spacing =
        track.plot().width() / std::max<double>(1, static_cast<double>(minima.size()));
    const double visibleShare =
        (mapping_.end - mapping_.begin) * fighter.input.rate / std::max(1, fighter.frameCount());
    const double radius = spacing / std::max(0.001, visibleShare) < 4 ? 1.2 : 2.0;
    painter_.setPen(Qt::NoPen);
    for (const ForceMinimum& minimum : minima) {
        const double x = xOfFrame(fighter.input, minimum.frame);
        if (x < track.plot().left() - 4 || x > track.plot().right() + 4) continue;
        const bool cuts = minimum.prominence >= session_.document().analysis().settings.prominence;
        painter_.setBrush(cuts ? colours_.fighterText[player]
                               : withAlpha(colours_.secondText, 0.6));
        const double r = cuts ? radius : radius * 0.7;
        painter_.drawEllipse(QPointF(x, track.yOfForce(minimum.force)), r, r);
    }
}

void TrackPainter::paintBoundaries(const Track& track, const FighterAnalysis& fighter, int player) {
    const auto& marks = session_.marks(player);
    int visible = 0;
    for (const BoundaryMark& mark : marks) {
        const double x = xOfFrame(fighter.input, mark.frame);
        if (x >= track.plot().left() && x <= track.plot().right()) ++visible;
    }
    // Many boundaries on few pixels would hide the curve.
    const double density =
        std::clamp(track.plot().width() / (8.0 * std::max(1, visible)), 0.35, 1.0);
    for (const BoundaryMark& mark : marks) {
        const double x = xOfFrame(fighter.input, mark.frame);
        if (x < track.plot().left() - 8 || x > track.plot().right() + 8) continue;
        paintBoundary(track, mark, x, density);
        if (mark.minimum && mark.isLive() && mark.suspicion >= 0.15) {
            const auto& minimum = fighter.force->minima[static_cast<std::size_t>(*mark.minimum)];
            const QPointF at(x, track.yOfForce(minimum.force));
            const double half = 2.5 + 4.0 * mark.suspicion;
            QPainterPath diamond;
            diamond.moveTo(at - QPointF(0, half));
            diamond.lineTo(at + QPointF(half, 0));
            diamond.lineTo(at + QPointF(0, half));
            diamond.lineTo(at - QPointF(half, 0));
            diamond.closeSubpath();
            painter_.setPen(QPen(colours_.ground, 1));
            painter_.setBrush(colours_.accent);
            painter_.drawPath(diamond);
        }
    }
}

void TrackPainter::paintBoundary(const Track& track, const BoundaryMark& mark, double x,
                                 double density) {
    const double top = track.row().top() + 3;
    const double bottom = track.strip().bottom();
    const double pixel = std::floor(x) + 0.5;
    // Found by the machine: lighter than what a hand has set.
    const QColor found = withAlpha(colours_.text, 0.42 * density);
    painter_.setBrush(Qt::NoBrush);
    switch (mark.state) {
        case MarkState::Removed: {
            const QColor ghost = withAlpha(colours_.secondText, 0.8);
            painter_.setPen(QPen(ghost, 1, Qt::CustomDashLine));
            QPen pen = painter_.pen();
            pen.setDashPattern({3, 3});
            painter_.setPen(pen);
            painter_.drawLine(QPointF(pixel, top + 8), QPointF(pixel, bottom));
            painter_.setPen(QPen(ghost, 1.4));
            cross(painter_, QPointF(pixel, top + 4), 3);
            return;
        }
        case MarkState::End:
            painter_.setPen(QPen(withAlpha(colours_.secondText, 0.6), 1));
            break;
        case MarkState::Detected:
            painter_.setPen(QPen(found, 1));
            break;
        case MarkState::Moved:
        case MarkState::Added:
            painter_.setPen(QPen(withAlpha(colours_.text, 0.95), 1.6));
            break;
    }
    painter_.drawLine(QPointF(pixel, top), QPointF(pixel, bottom));
    if (mark.state == MarkState::Moved) {
        // Set by hand: a double arrow.
        for (const double side : {-1.0, 1.0}) {
            const QPointF tip(pixel + side * 6, top + 4);
            painter_.drawLine(QPointF(pixel, top + 4), tip);
            painter_.drawLine(tip, tip + QPointF(-side * 2.5, -2.5));
            painter_.drawLine(tip, tip + QPointF(-side * 2.5, 2.5));
        }
    } else if (mark.state == MarkState::Added) {
        painter_.drawLine(QPointF(pixel - 4, top + 4), QPointF(pixel + 4, top + 4));
    }
}

void TrackPainter::paintSelection(const Track& track, const BoundaryRef& boundary) {
    const FighterAnalysis* fighter = session_.fighter(boundary.player);
    if (fighter == nullptr) return;
    const double x = std::floor(xOfFrame(fighter->input, boundary.frame)) + 0.5;
    if (x < track.plot().left() - 1 || x > track.plot().right() + 1) return;
    const double top = track.row().top() + 2;
    const double bottom = track.strip().bottom() + 1;
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setPen(QPen(withAlpha(colours_.accent, 0.95), 1));
    painter_.setBrush(withAlpha(colours_.accent, 0.24));
    painter_.drawRoundedRect(QRectF(x - 4.5, top, 9, bottom - top), 3, 3);
}

void TrackPainter::paintHandle(const QRectF& handle, bool live, bool under) {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setPen(
        QPen(under ? colours_.accent : mixed(colours_.line, colours_.secondText, 0.6), 1));
    painter_.setBrush(under ? mixed(colours_.panel, colours_.accent, 0.25) : colours_.panel);
    painter_.drawRoundedRect(handle, 3, 3);
    painter_.setPen(QPen(colours_.text, 1.5, Qt::SolidLine, Qt::RoundCap));
    const QPointF centre = handle.center();
    if (live) {
        cross(painter_, centre, 3);
    } else {
        painter_.setBrush(Qt::NoBrush);
        painter_.drawLine(centre - QPointF(3.5, 0), centre + QPointF(3.5, 0));
        painter_.drawLine(centre - QPointF(0, 3.5), centre + QPointF(0, 3.5));
    }
}

}  // namespace kumite::studio
