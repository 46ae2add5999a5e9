// What the mouse and the keyboard do on the timeline.

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "studio/timeline/lanes.h"
#include "studio/timeline/timeline_view.h"
#include "studio/timeline/wheel.h"

namespace kumite::studio {

namespace {
constexpr double kBoundaryReach = 5;     // pixels
constexpr double kBoundaryShare = 0.25;  // of a block, at either end
constexpr double kNoteCorner = 10;
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
    double reach = kBoundaryReach;
    // However narrow, most of a block is the action's.
    if (const auto action = blockAt(position)) {
        reach = std::min(reach, kBoundaryShare * blockOf(*action).width());
    }
    const BoundaryMark* mark = nearestMark(session_.marks(player), frame, reach * framesPerPixel);
    return mark ? std::optional(BoundaryRef{player, mark->frame}) : std::nullopt;
}

std::optional<BoundaryRef> TimelineView::handleAt(const QPointF& position) const {
    return hovered_ && handleOf(*hovered_).contains(position) ? hovered_ : std::nullopt;
}

void TimelineView::hover(const QPointF& position) {
    pointer_ = position;
    // The button is wider than the line that it belongs to.
    const auto hit = laneHitAt(position);
    const bool onLane = hit && hit->lane >= 0;
    hovered_ = handleAt(position) ? hovered_ : onLane ? std::nullopt : boundaryAt(position);
    const int player = playerAt(position.y());
    const TimeMapping map = mapping();
    const double seconds = map.timeAt(position.x());
    const bool inside = position.x() >= map.left && position.x() <= map.left + map.width;
    const bool onLoop =
        ruler().contains(position) && loopEndAt(loopRange(session_.transport()), map, position.x());
    setCursor(handleAt(position)   ? Qt::PointingHandCursor
              : hovered_ || onLoop ? Qt::SizeHorCursor
                                   : Qt::ArrowCursor);
    QString told = inside && player >= 0 ? describe(player, seconds) : QString();
    if (hit && !hovered_) {
        told = lanes_->describe(hit->action, hit->lane);
    }
    Q_EMIT session_.hovered(told);
    update();
}

/// What lies under a resting pointer may have become another.
void TimelineView::hoverAgain() {
    if (pointer_ && gesture_ == Gesture::None) hover(*pointer_);
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
    const auto range = loopRange(session_.transport());
    if (const auto end = loopEndAt(range, mapping(), position.x());
        end && ruler().contains(position)) {
        loopEnd_ = *end;
        gesture_ = Gesture::Loop;
        return;
    }
    if (openNote(position) || pressLanes(*event)) return;
    gesture_ = choose(position) ? Gesture::Press : Gesture::Scrub;
}

/// What a click selects, and the playhead goes there. Whether it is a boundary.
bool TimelineView::choose(const QPointF& position) {
    const int player = playerAt(position.y());
    if (player >= 0) session_.setActivePlayer(player);
    if (hovered_) {
        session_.goTo(*hovered_);
        return true;
    }
    if (player >= 0) {
        session_.select(std::nullopt);
        session_.selectAction(blockAt(position));
    }
    scrubTo(position.x());
    return false;
}

void TimelineView::contextMenuEvent(QContextMenuEvent* event) {
    if (gesture_ != Gesture::None || tracks_.empty()) return;
    if (event->reason() == QContextMenuEvent::Mouse) {
        const QPointF position = event->pos();
        hover(position);
        const bool boundary = choose(position);
        Q_EMIT menuWanted(boundary                      ? TimelineSpot::Boundary
                          : playerAt(position.y()) >= 0 ? TimelineSpot::Action
                                                        : TimelineSpot::Ruler,
                          event->globalPos());
        return;
    }
    // By key: on what is selected, else on the action at the playhead.
    if (const auto& selected = session_.selection()) {
        Q_EMIT menuWanted(TimelineSpot::Boundary, mapToGlobal(pointOf(*selected).toPoint()));
    } else if (const auto action = session_.currentAction()) {
        Q_EMIT menuWanted(TimelineSpot::Action, mapToGlobal(blockOf(*action).center().toPoint()));
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
        case Gesture::Lanes:
            dragLanes(position);
            break;
        case Gesture::Pan: {
            const TimeMapping moved = mapping().panned(position.x() - last_.x());
            session_.setVisible({moved.begin, moved.end});
            break;
        }
        case Gesture::Press:
            if (std::abs(position.x() - pressed_.x()) < kDragStart) break;
            if (!startDrag()) break;
            [[fallthrough]];
        case Gesture::Drag:
            // Many window managers keep Alt+drag for themselves.
            dragTo(position.x(), event->modifiers() & (Qt::AltModifier | Qt::ControlModifier));
            break;
        case Gesture::Loop: {
            const auto range = loopRange(session_.transport());
            if (!range) break;
            const TimeSpan moved = withLoopEnd(*range, loopEnd_, mapping().timeAt(position.x()));
            session_.transport().setLoop(moved.begin, moved.end);
            break;
        }
    }
    last_ = position;
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event) {
    if (gesture_ == Gesture::Drag) endDrag(true);
    if (gesture_ == Gesture::Lanes) lanes_->released();
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
    } else if (const auto action = blockAt(position)) {
        session_.loopAction(*action);
    }
}

void TimelineView::wheelEvent(QWheelEvent* event) {
    const TimeMapping changed = afterWheel(mapping(), *event);
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
        session_.selectAction(std::nullopt);
    }
}

void TimelineView::scrubTo(double x) {
    session_.transport().setPlayhead(mapping().timeAt(x));
    update();
}

std::optional<ActionRef> TimelineView::blockAt(const QPointF& position) const {
    const int player = playerAt(position.y());
    const FighterAnalysis* fighter = session_.fighter(player);
    if (fighter == nullptr) return std::nullopt;
    if (!tracks_[static_cast<std::size_t>(player)].strip().contains(position)) return std::nullopt;
    return session_.actionAt(player, frameAtTime(fighter->input, mapping().timeAt(position.x())));
}

std::optional<TimelineView::LaneHit> TimelineView::laneHitAt(const QPointF& position) const {
    const int player = playerAt(position.y());
    const FighterAnalysis* fighter = session_.fighter(player);
    if (lanes_ == nullptr || fighter == nullptr) return std::nullopt;
    const Track& track = tracks_[static_cast<std::size_t>(player)];
    const bool onLanes = track.lanes().area.contains(position);
    if (!onLanes && !track.strip().contains(position)) return std::nullopt;
    const auto action =
        session_.actionAt(player, frameAtTime(fighter->input, mapping().timeAt(position.x())));
    if (!action) return std::nullopt;
    return LaneHit{*action, track.lanes().laneAt(position.y(), lanes_->laneCount())};
}

/// A press on an action or one of its lanes, away from boundaries, is the lanes'.
bool TimelineView::pressLanes(const QMouseEvent& event) {
    const auto hit = laneHitAt(event.position());
    if (!hit || (hovered_ && hit->lane < 0)) return false;
    gesture_ = Gesture::Lanes;
    laneDragged_ = hit->action;
    if (lanes_->pressed(hit->action, hit->lane, event.modifiers())) scrubTo(event.position().x());
    return true;
}

/// A press on the folded corner of an action with a note opens the note.
bool TimelineView::openNote(const QPointF& position) {
    const auto action = blockAt(position);
    if (!action || session_.noteOf(*action).isEmpty()) return false;
    const QRectF block = blockOf(*action);
    if (!QRectF(block.right() - kNoteCorner, block.top(), kNoteCorner, kNoteCorner)
             .contains(position))
        return false;
    session_.setActivePlayer(action->player);
    session_.selectAction(action);
    editNote();
    return true;
}

void TimelineView::dragLanes(const QPointF& position) {
    const auto hit = laneHitAt(position);
    if (!hit || hit->action == laneDragged_) return;
    laneDragged_ = hit->action;
    lanes_->dragged(hit->action);
}

bool TimelineView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && gesture_ == Gesture::Drag &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        // What is dragged is left before any tool that Esc would leave, too.
        event->accept();
        return true;
    }
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto action = blockAt(help->pos());
    QToolTip::showText(help->globalPos(), action ? session_.noteOf(*action) : QString(), this);
    return true;
}

}  // namespace kumite::studio
