#pragma once

#include <memory>
#include <optional>

#include "core/transition/transition_synthesis.h"

namespace kumite {

/// The motion that an author drives live (paper B, "Dodge example"): frames are taken one by one,
/// commands may come at any time. What is planned but not yet shown can be dropped; what was shown
/// never changes.
class PlaybackBuffer {
public:
    PlaybackBuffer(std::shared_ptr<const FlexibleGraph> graph, TransitionSettings settings = {});

    /// An action at once: the planned rest is dropped, and a transition starts from the pose shown.
    /// The first action of all simply begins. Throws Error (the buffer is then as it was).
    TransitionReport play(MotionPart action, const TransitionRequest& request = {});
    /// An action after all that is planned.
    TransitionReport append(MotionPart action, const TransitionRequest& request = {});

    /// Shows the next frame, its standing feet held where they are; the last one again where
    /// nothing is planned. There must be one.
    const Pose& next();

    bool empty() const { return strip_.frames().empty(); }
    /// Frames planned and not yet shown.
    int planned() const { return strip_.frameCount() - shown_; }
    /// Frames shown so far, held ones not counted.
    long long shownFrames() const { return forgotten_ + shown_; }
    /// Shown frames that are kept and planned ones after them, before feet are cleaned: frame 0 is
    /// number shownFrames() − shown(). For drawing what comes.
    const std::vector<Pose>& frames() const { return strip_.frames(); }
    int shown() const { return shown_; }

private:
    void forget();

    MotionStrip strip_;
    FootLock feet_;
    Pose pose_;                ///< shown last
    int shown_ = 0;            ///< of the strip's frames
    long long forgotten_ = 0;  ///< frames shown and dropped from the strip's beginning
};

}  // namespace kumite
