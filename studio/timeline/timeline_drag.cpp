// A boundary that is dragged on the timeline.

#include <algorithm>
#include <cmath>

#include "studio/timeline/timeline_view.h"

namespace kumite::studio {

bool TimelineView::startDrag() {
    const auto& selected = session_.selection();
    const BoundaryMark* mark = selected ? markOf(*selected) : nullptr;
    if (mark == nullptr || !mark->isLive()) {
        gesture_ = Gesture::None;
        return false;
    }
    gesture_ = Gesture::Drag;
    dragged_ = Dragged{*selected, selected->frame, snapTargets(selected->player), {}};
    return true;
}

std::vector<SnapTarget> TimelineView::snapTargets(int player) const {
    std::vector<SnapTarget> targets;
    const FighterAnalysis& fighter = *session_.fighter(player);
    if (fighter.force) {
        for (const ForceMinimum& minimum : fighter.force->minima)
            targets.push_back({SnapKind::Minimum, minimum.frame});
    }
    if (fighter.body) {
        for (const auto* foot : {&fighter.body->contacts.left, &fighter.body->contacts.right}) {
            for (std::size_t frame = 1; frame < foot->size(); ++frame) {
                if ((*foot)[frame] == (*foot)[frame - 1]) continue;
                targets.push_back({SnapKind::Contact, static_cast<int>(frame)});
            }
        }
    }
    for (int other = 0; other < session_.playerCount(); ++other) {
        if (other == player) continue;
        for (const BoundaryMark& mark : session_.marks(other)) {
            if (!mark.isLive()) continue;
            const double seconds = session_.timeOf({other, mark.frame});
            targets.push_back({SnapKind::OtherFighter, frameAtTime(fighter.input, seconds)});
        }
    }
    targets.push_back(
        {SnapKind::Playhead, frameAtTime(fighter.input, session_.transport().playhead())});
    return targets;
}

void TimelineView::dragTo(double x, bool free) {
    constexpr double kSnapReach = 6;  // pixels
    const BoundaryRef& boundary = dragged_->boundary;
    const FighterAnalysis* fighter = session_.fighter(boundary.player);
    if (fighter == nullptr) return;
    const double rate = fighter->input.rate;
    const double wanted = (mapping().timeAt(x) - fighter->input.offset) * rate;
    const DragLimits limits =
        dragLimits(session_.marks(boundary.player), boundary.frame, fighter->frameCount());
    const auto target = free ? std::nullopt
                             : nearestTarget(dragged_->targets, wanted,
                                             kSnapReach * rate / mapping().pixelsPerSecond());
    const int frame = target ? target->frame : static_cast<int>(std::lround(wanted));
    dragged_->frame = std::clamp(frame, limits.low, std::max(limits.low, limits.high));
    dragged_->snap =
        target && target->frame == dragged_->frame ? std::optional(target->kind) : std::nullopt;
    session_.transport().setPreview(session_.timeOf({boundary.player, dragged_->frame}));
    Q_EMIT session_.hovered(
        tr("Release to move the boundary here, Esc to leave it, Ctrl or Alt to place it freely."));
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
    hover(last_);
}

}  // namespace kumite::studio
