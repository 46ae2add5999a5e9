// What the mouse and the keyboard do on the timeline.

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "studio/timeline/timeline_view.h"

namespace kumite::studio {

namespace {
constexpr double kBoundaryReach = 5;  // pixels
constexpr double kSnapReach = 6;
constexpr double kDragStart = 4;
}  // namespace

int TimelineView::playerAt(double y) const {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        if (y >= tracks_[i].row().top() && y < tracks_[i].row().bottom()) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

const BoundaryMark* TimelineView::markOf(const BoundaryRef& boundary) const {
    return nearestMark(session_.marks(boundary.player), boundary.frame, 0.5);
}

std::optional<BoundaryRef> TimelineView::boundaryAt(const QPointF& position) const {
    const int player = playerAt(position.y());
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) return std::nullopt;
    const TimeMapping map = mapping();
    const double framesPerPixel = fighter->input.rate / map.pixelsPerSecond();
    const double frame = (map.timeAt(position.x()) - fighter->input.offset) * fighter->input.rate;
    const BoundaryMark* mark =
        nearestMark(session_.marks(player), frame, kBoundaryReach * framesPerPixel);
    return mark ? std::optional(BoundaryRef{player, mark->frame}) : std::nullopt;
}

std::optional<BoundaryRef> TimelineView::handleAt(const QPointF& position) const {
    return hovered_ && handleOf(*hovered_).contains(position) ? hovered_ : std::nullopt;
}

void TimelineView::hover(const QPointF& position) {
    pointer_ = position;
    // The button is wider than the line that it belongs to.
    hovered_ = handleAt(position) ? hovered_ : boundaryAt(position);
    const int player = playerAt(position.y());
    const TimeMapping map = mapping();
    const double seconds = map.timeAt(position.x());
    const bool inside = position.x() >= map.left && position.x() <= map.left + map.width;
    setCursor(handleAt(position) ? Qt::PointingHandCursor
              : hovered_         ? Qt::SizeHorCursor
                                 : Qt::ArrowCursor);
    Q_EMIT session_.hovered(inside && player >= 0 ? describe(player, seconds) : QString());
    update();
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    pressed_ = last_ = position;
    if (event->button() == Qt::MiddleButton) {
        gesture_ = Gesture::Pan;
        setCursor(Qt::ClosedHandCursor);
        return;
    }
    if (event->button() != Qt::LeftButton) return;
    hover(position);
    if (const auto handle = handleAt(position)) {
        session_.setActivePlayer(handle->player);
        session_.toggleBoundary(*handle);
        return;
    }
    const int player = playerAt(position.y());
    if (player >= 0) session_.setActivePlayer(player);
    if (hovered_) {
        session_.goTo(*hovered_);
        gesture_ = Gesture::Press;
    } else {
        if (player >= 0) session_.select(std::nullopt);
        gesture_ = Gesture::Scrub;
        scrubTo(position.x());
    }
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    switch (gesture_) {
        case Gesture::None:
            hover(position);
            break;
        case Gesture::Scrub:
            scrubTo(position.x());
            break;
        case Gesture::Pan: {
            const TimeMapping moved = mapping().panned(position.x() - last_.x());
            session_.setVisible({moved.begin, moved.end});
            break;
        }
        case Gesture::Press:
            if (std::abs(position.x() - pressed_.x()) < kDragStart) break;
            if (const auto& selected = session_.selection();
                selected && markOf(*selected) != nullptr && markOf(*selected)->isLive()) {
                gesture_ = Gesture::Drag;
                dragged_ = Dragged{*selected, selected->frame};
            } else {
                gesture_ = Gesture::None;
            }
            [[fallthrough]];
        case Gesture::Drag:
            if (dragged_) dragTo(position.x(), event->modifiers() & Qt::AltModifier);
            break;
    }
    last_ = position;
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event) {
    if (gesture_ == Gesture::Drag) endDrag(true);
    gesture_ = Gesture::None;
    hover(event->position());
}

void TimelineView::mouseDoubleClickEvent(QMouseEvent* event) {
    const QPointF position = event->position();
    const int player = playerAt(position.y());
    if (event->button() != Qt::LeftButton || player < 0) return;
    if (handleAt(position)) {
        // Two fast clicks on the button are two clicks.
        mousePressEvent(event);
    } else if (const auto boundary = boundaryAt(position)) {
        session_.toggleBoundary(*boundary);
    } else if (tracks_[static_cast<std::size_t>(player)].strip().contains(position)) {
        loopActionAt(player, mapping().timeAt(position.x()));
    }
}

void TimelineView::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    const double delta = turned.y() != 0 ? turned.y() : turned.x();
    const TimeMapping changed =
        event->modifiers() & Qt::ControlModifier
            ? mapping().zoomedAbout(event->position().x(), std::pow(1.002, delta))
            : mapping().panned(0.8 * delta);
    session_.setVisible({changed.begin, changed.end});
    event->accept();
}

void TimelineView::leaveEvent(QEvent*) {
    pointer_.reset();
    hovered_.reset();
    Q_EMIT session_.hovered({});
    update();
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) {
        QWidget::keyPressEvent(event);
    } else if (gesture_ == Gesture::Drag) {
        endDrag(false);
    } else {
        session_.select(std::nullopt);
    }
}

void TimelineView::scrubTo(double x) {
    session_.transport().setPlayhead(mapping().timeAt(x));
    update();
}

int TimelineView::snapped(int player, double frame) const {
    const FighterAnalysis* fighter = session_.fighter(player);
    const double reach = kSnapReach * fighter->input.rate / mapping().pixelsPerSecond();
    double best = frame;
    double bestDistance = reach;
    const auto offer = [&](double candidate) {
        if (std::abs(candidate - frame) > bestDistance) return;
        bestDistance = std::abs(candidate - frame);
        best = candidate;
    };
    for (const ForceMinimum& minimum : fighter->force->minima)
        offer(minimum.frame);
    offer(frameAtTime(fighter->input, session_.transport().playhead()));
    const int other = 1 - player;
    for (const BoundaryMark& mark : session_.marks(other)) {
        if (mark.isLive()) offer(frameAtTime(fighter->input, session_.timeOf({other, mark.frame})));
    }
    return static_cast<int>(std::lround(best));
}

void TimelineView::dragTo(double x, bool free) {
    const BoundaryRef& boundary = dragged_->boundary;
    const FighterAnalysis* fighter = session_.fighter(boundary.player);
    const double wanted = (mapping().timeAt(x) - fighter->input.offset) * fighter->input.rate;
    int low = 1;
    int high = fighter->frameCount() - 2;
    for (const BoundaryMark& mark : session_.marks(boundary.player)) {
        if (!mark.isLive()) continue;
        if (mark.frame < boundary.frame) low = mark.frame + 1;
        if (mark.frame > boundary.frame) {
            high = mark.frame - 1;
            break;
        }
    }
    const int frame =
        free ? static_cast<int>(std::lround(wanted)) : snapped(boundary.player, wanted);
    dragged_->frame = std::clamp(frame, low, std::max(low, high));
    const double seconds = session_.timeOf({boundary.player, dragged_->frame});
    session_.transport().setPreview(seconds);
    Q_EMIT session_.hovered(
        tr("Release to move the boundary here, Esc to leave it, Alt to place "
           "it freely."));
    update();
}

void TimelineView::endDrag(bool commit) {
    const Dragged done = *dragged_;
    dragged_.reset();
    gesture_ = Gesture::None;
    session_.transport().setPreview(std::nullopt);
    if (commit && done.frame != done.boundary.frame) {
        session_.moveBoundary(done.boundary, done.frame);
    }
    update();
}

void TimelineView::loopActionAt(int player, double seconds) {
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) return;
    const int frame = frameAtTime(fighter->input, seconds);
    for (const Action& action : fighter->segmentation->actions) {
        if (frame < action.begin || frame >= action.end) continue;
        const double begin = timeOfFrame(fighter->input, action.begin);
        const double end = timeOfFrame(fighter->input, action.end);
        const double air = 0.5 * (end - begin);
        session_.transport().setLoop(begin, end);
        session_.transport().setLooping(true);
        session_.transport().setPlayhead(begin);
        session_.setVisible({begin - air, end + air});
        return;
    }
}

}  // namespace kumite::studio
