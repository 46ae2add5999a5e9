#include "core/transition/playback.h"

#include <algorithm>
#include <cassert>

namespace kumite {
namespace {

constexpr int kRemembered = 64;  ///< shown frames that are kept: joins look at their speed
constexpr int kForgetAt = 1024;  ///< shown frames at which older ones are dropped

}  // namespace

PlaybackBuffer::PlaybackBuffer(std::shared_ptr<const FlexibleGraph> graph,
                               TransitionSettings settings)
    : strip_(graph, settings),
      feet_(graph->library->rig, graph->library->rate, graph->library->feet) {}

TransitionReport PlaybackBuffer::play(MotionPart action, const TransitionRequest& request) {
    forget();
    if (shown_ > 0) return strip_.lead(action, request, shown_, shown_).report;
    if (action.empty()) throw Error("The action has no frame.");
    strip_.begin(action);
    return {};
}

TransitionReport PlaybackBuffer::append(MotionPart action, const TransitionRequest& request) {
    if (empty()) return play(action, request);
    forget();
    return strip_.lead(action, request, shown_).report;
}

const Pose& PlaybackBuffer::next() {
    assert(!empty());
    if (planned() == 0) return pose_;
    const auto ahead = static_cast<std::size_t>(std::min(planned(), feet_.useful()));
    const auto at = static_cast<std::size_t>(shown_++);
    pose_ = feet_.show(std::span<const Pose>(strip_.frames()).subspan(at, ahead),
                       std::span<const Standing>(strip_.standing()).subspan(at, ahead));
    return pose_;
}

void PlaybackBuffer::forget() {
    if (shown_ < kForgetAt) return;
    const int dropped = shown_ - kRemembered;
    strip_.dropFirst(dropped);
    shown_ -= dropped;
    forgotten_ += dropped;
}

}  // namespace kumite
