#include "studio/timeline/mark_painter.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

#include "core/project/notes.h"
#include "studio/timeline/level_of_detail.h"
#include "studio/timeline/mark_stamp.h"
#include "studio/timeline/track_painter.h"

namespace kumite::studio {

namespace {

void cross(QPainter& painter, const QPointF& centre, double half) {
    painter.drawLine(centre - QPointF(half, half), centre + QPointF(half, half));
    painter.drawLine(centre - QPointF(half, -half), centre + QPointF(half, -half));
}

/// The part [first, last) of an ordered sequence whose frames lie within the visible ones, with
/// `air` frames on both sides.
template <typename Sequence, typename FrameOf>
auto visiblePart(const Sequence& all, const SampleAxis& axis, const QRectF& plot,
                 const FrameOf& frameOf) {
    constexpr double kAir = 8;  // pixels
    const double from = axis.sampleAt(plot.left() - kAir);
    const double to = axis.sampleAt(plot.right() + kAir);
    const auto first = std::partition_point(all.begin(), all.end(),
                                            [&](const auto& each) { return frameOf(each) < from; });
    const auto last = std::partition_point(first, all.end(),
                                           [&](const auto& each) { return frameOf(each) <= to; });
    return std::pair(first, last);
}

/// What must not vanish under another mark of the same pixel.
double weightOf(const BoundaryMark& mark) {
    switch (mark.state) {
        case MarkState::End:
            return 5;
        case MarkState::Moved:
        case MarkState::Added:
            return 4;
        case MarkState::Removed:
            return 3;
        case MarkState::Accepted:
            return 2;
        case MarkState::Detected:
            break;
    }
    return mark.suspicion;
}

}  // namespace

MarkPainter::MarkPainter(QPainter& painter, const Session& session, const Colours& colours,
                         const TimeMapping& mapping)
    : painter_(painter), session_(session), colours_(colours), mapping_(mapping) {}

void MarkPainter::paintActions(const Track& track, int player) {
    const FighterAnalysis& fighter = *session_.fighter(player);
    const SampleAxis axis = frameAxis(fighter.input, mapping_);
    const QRectF strip = track.strip();
    const QColor tint = colours_.fighters[player];
    const QFont font = painter_.font();
    painter_.setFont(smallFont(painter_));
    const auto& actions = fighter.segmentation->actions;
    MarkStamp notch(5, painter_.device()->devicePixelRatioF(), [this](QPainter& painter) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(withAlpha(colours_.text, 0.8));
        const QPointF corners[] = {{-3, 0}, {3, 0}, {0, 4}};
        painter.drawPolygon(corners, 3);
    });
    const auto fill = [&](const QRectF& block, double alpha) {
        // Whole pixels: crisp, and fast where there are thousands.
        const int left = static_cast<int>(std::lround(block.left()));
        const int right = std::max(left + 1, static_cast<int>(std::lround(block.right())));
        painter_.fillRect(QRect(left, static_cast<int>(block.top()), right - left,
                                static_cast<int>(block.height())),
                          mixed(colours_.ground, tint, alpha));
    };
    auto first = std::partition_point(actions.begin(), actions.end(), [&](const Action& action) {
        return axis.xOf(action.end) < strip.left();
    });
    // Blocks too narrow to be told apart are gathered into one.
    double gathered = 0;
    for (; first != actions.end() && axis.xOf(first->begin) <= strip.right(); ++first) {
        const double from = axis.xOf(first->begin);
        const double width = axis.xOf(first->end) - from;
        if (width + gathered < 2) {
            gathered += width;
            continue;
        }
        if (gathered > 0) {
            fill(QRectF(from - gathered, strip.top(), gathered + width, strip.height()), 0.39);
            gathered = 0;
            continue;
        }
        const auto index = first - actions.begin();
        const QRectF block(from, strip.top(), width - (width > 5 ? 1 : 0), strip.height());
        fill(block, index % 2 == 0 ? 0.50 : 0.28);
        if (width > 8) {
            notch.put(painter_, QPointF(axis.xOf(first->peak), strip.top()));
        }
        if (width > 44) {
            painter_.setPen(colours_.text);
            painter_.drawText(block.adjusted(5, 0, -3, 0), Qt::AlignLeft | Qt::AlignVCenter,
                              QString::number(index));
        }
    }
    for (const ActionNote& note : fighter.input.notes) {
        const Action* action = actionAt(*fighter.segmentation, note.frame);
        if (action == nullptr) continue;
        const double from = axis.xOf(action->begin);
        const double to = axis.xOf(action->end);
        if (to < strip.left() || from > strip.right()) continue;
        paintNoteMark(QRectF(from, strip.top(), to - from, strip.height()));
        // Right of the action's number, left of the folded corner.
        const QString number = QString::number(action - actions.data());
        const double left = from + 5 + painter_.fontMetrics().horizontalAdvance(number) + 8;
        const double room = to - 12 - left;
        if (room < 30) continue;
        const QString text =
            QString::fromStdString(noteOf(fighter.input.notes, *fighter.segmentation, *action));
        painter_.setPen(colours_.text);
        painter_.drawText(
            QRectF(left, strip.top(), room, strip.height()), Qt::AlignLeft | Qt::AlignVCenter,
            painter_.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(room)));
    }
    painter_.setFont(font);
}

/// A folded corner, as on a page.
void MarkPainter::paintNoteMark(const QRectF& block) {
    const double right = std::max(block.right() - 1, block.left() + 3);
    const QPointF corner[] = {
        {right - 8, block.top()}, {right, block.top()}, {right, block.top() + 8}};
    painter_.setPen(QPen(colours_.ground, 1));
    painter_.setBrush(colours_.text);
    painter_.drawPolygon(corner, 3);
}

void MarkPainter::paintMinima(const Track& track, int player) {
    const FighterAnalysis& fighter = *session_.fighter(player);
    const SampleAxis axis = frameAxis(fighter.input, mapping_);
    const auto [first, last] =
        visiblePart(fighter.force->minima, axis, track.plot(),
                    [](const ForceMinimum& minimum) { return minimum.frame; });
    const double spacing =
        track.plot().width() / std::max<double>(1.0, static_cast<double>(last - first));
    // Dots that touch say nothing that the curve does not say.
    if (spacing < 2.5) return;
    const double radius = spacing < 6 ? 1.2 : 2.0;
    const double threshold = session_.document().analysis().settings.prominence;
    const auto dot = [&](double r, const QColor& colour) {
        return MarkStamp(r, painter_.device()->devicePixelRatioF(), [r, colour](QPainter& painter) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawEllipse(QPointF(), r, r);
        });
    };
    MarkStamp cutting = dot(radius, colours_.fighterText[player]);
    MarkStamp shallow = dot(0.7 * radius, withAlpha(colours_.secondText, 0.6));
    for (auto minimum = first; minimum != last; ++minimum) {
        MarkStamp& stamp = minimum->prominence >= threshold ? cutting : shallow;
        stamp.put(painter_, QPointF(axis.xOf(minimum->frame), track.yOfForce(minimum->force)));
    }
}

void MarkPainter::paintBoundaries(const Track& track, int player) {
    const FighterAnalysis& fighter = *session_.fighter(player);
    const SampleAxis axis = frameAxis(fighter.input, mapping_);
    const auto [first, last] = visiblePart(session_.marks(player), axis, track.plot(),
                                           [](const BoundaryMark& mark) { return mark.frame; });
    const std::vector<BoundaryMark> visible(first, last);
    std::vector<double> xs, weights;
    for (const BoundaryMark& mark : visible) {
        xs.push_back(axis.xOf(mark.frame));
        weights.push_back(weightOf(mark));
    }
    // Many boundaries on few pixels would hide the curve.
    const double many = std::max<double>(1.0, static_cast<double>(visible.size()));
    const double density = std::clamp(track.plot().width() / (8.0 * many), 0.2, 1.0);
    for (const std::size_t i : heaviestPerCell(xs, weights, density < 0.5 ? 2 : 1)) {
        paintBoundary(track, visible[i], xs[i], density);
    }
}

void MarkPainter::paintSuspects(const Track& track, int player) {
    const FighterAnalysis& fighter = *session_.fighter(player);
    const auto& minima = fighter.force->minima;
    const SampleAxis axis = frameAxis(fighter.input, mapping_);
    const auto [first, last] = visiblePart(session_.marks(player), axis, track.plot(),
                                           [](const BoundaryMark& mark) { return mark.frame; });
    std::vector<const BoundaryMark*> suspects;
    std::vector<double> places, weights;
    for (auto mark = first; mark != last; ++mark) {
        if (!mark->isSuspect()) continue;
        suspects.push_back(&*mark);
        places.push_back(axis.xOf(mark->frame));
        weights.push_back(mark->suspicion);
    }
    // As big as the suspicion, in steps that cannot be told apart.
    constexpr int kSizes = 17;
    std::vector<MarkStamp> diamonds;
    for (int size = 0; size < kSizes; ++size) {
        const double half = 2.5 + 0.25 * size;
        diamonds.emplace_back(
            half + 1, painter_.device()->devicePixelRatioF(), [half, this](QPainter& painter) {
                painter.setPen(QPen(colours_.ground, 1));
                painter.setBrush(colours_.accent);
                const QPointF corners[] = {{0, -half}, {half, 0}, {0, half}, {-half, 0}};
                painter.drawPolygon(corners, 4);
            });
    }
    for (const std::size_t kept : heaviestPerCell(places, weights, 8)) {
        const BoundaryMark& mark = *suspects[kept];
        const auto& minimum = minima[static_cast<std::size_t>(*mark.minimum)];
        const auto size = static_cast<std::size_t>(
            std::lround(std::clamp<double>(mark.suspicion, 0, 1) * (kSizes - 1)));
        diamonds[size].put(painter_, QPointF(places[kept], track.yOfForce(minimum.force)));
    }
}

void MarkPainter::paintComparison(const Track& track, int player) {
    const auto& comparison = session_.comparison();
    if (!comparison || player >= static_cast<int>(comparison->players.size())) return;
    const BoundaryComparison& difference = comparison->players[static_cast<std::size_t>(player)];
    const SampleAxis axis = frameAxis(session_.fighter(player)->input, mapping_);
    const QRectF plot = track.plot();
    const auto paint = [&](const std::vector<int>& frames, bool onlyA) {
        const auto [first, last] = visiblePart(frames, axis, plot, [](int frame) { return frame; });
        double drawn = -1e9;
        for (auto frame = first; frame != last; ++frame) {
            const double x = std::floor(axis.xOf(*frame)) + 0.5;
            if (x - drawn < 2) continue;
            drawn = x;
            if (onlyA) {
                // A, as it stands, has it; B would not.
                painter_.drawEllipse(QPointF(x, plot.bottom() - 4), 2.5, 2.5);
            } else {
                painter_.drawLine(QPointF(x, plot.center().y()), QPointF(x, plot.bottom()));
                painter_.drawLine(QPointF(x - 3, plot.bottom()), QPointF(x + 3, plot.bottom()));
            }
        }
    };
    painter_.setBrush(colours_.ground);
    painter_.setPen(QPen(colours_.text, 1));
    paint(difference.onlyA, true);
    painter_.setPen(QPen(withAlpha(colours_.text, 0.6), 1, Qt::DotLine));
    paint(difference.onlyB, false);
}

void MarkPainter::paintBoundary(const Track& track, const BoundaryMark& mark, double x,
                                double density) {
    const double top = track.row().top() + 3;
    const double bottom = track.strip().bottom();
    const double pixel = std::floor(x) + 0.5;
    // Found by the machine: lighter than what a hand has set.
    const QColor found = mixed(colours_.ground, colours_.text, 0.42 * density);
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
            painter_.fillRect(QRect(static_cast<int>(std::floor(x)), static_cast<int>(top), 1,
                                    static_cast<int>(bottom - top)),
                              found);
            return;
        case MarkState::Accepted:
            painter_.setPen(QPen(withAlpha(colours_.text, 0.8), 1));
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
    } else if (mark.state == MarkState::Accepted && density > 0.6) {
        // Looked at and found right: a tick.
        painter_.drawLine(QPointF(pixel + 2, top + 4), QPointF(pixel + 4, top + 6));
        painter_.drawLine(QPointF(pixel + 4, top + 6), QPointF(pixel + 8, top + 1));
    } else if (mark.state == MarkState::Added) {
        painter_.drawLine(QPointF(pixel - 4, top + 4), QPointF(pixel + 4, top + 4));
    }
}

void MarkPainter::paintSelection(const Track& track, const ActionRef& action) {
    if (session_.actionOf(action) == nullptr) return;
    const TimeSpan span = session_.spanOf(action);
    const double left = std::max(mapping_.xOf(span.begin), track.strip().left());
    const double right = std::min(mapping_.xOf(span.end), track.strip().right());
    if (right < left) return;
    const double top = track.plot().top();
    painter_.setRenderHint(QPainter::Antialiasing, false);
    painter_.fillRect(QRectF(left, top, right - left, track.strip().top() - top),
                      withAlpha(colours_.accent, 0.10));
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setPen(QPen(colours_.accent, 1.5));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(QRectF(left, track.strip().top(), right - left, track.strip().height()));
    const QRectF lanes = track.lanes().area;
    if (!lanes.isEmpty())
        painter_.drawRect(QRectF(left, lanes.top(), right - left, lanes.height()));
}

void MarkPainter::paintSelection(const Track& track, const BoundaryRef& boundary) {
    const FighterAnalysis* fighter = session_.fighter(boundary.player);
    if (fighter == nullptr) return;
    const double x = std::floor(mapping_.xOf(session_.timeOf(boundary))) + 0.5;
    if (x < track.plot().left() - 1 || x > track.plot().right() + 1) return;
    const double top = track.row().top() + 2;
    const double bottom = track.strip().bottom() + 1;
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setPen(QPen(withAlpha(colours_.accent, 0.95), 1));
    painter_.setBrush(withAlpha(colours_.accent, 0.24));
    painter_.drawRoundedRect(QRectF(x - 4.5, top, 9, bottom - top), 3, 3);
}

void MarkPainter::paintHandle(const QRectF& handle, bool live, bool under) {
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
