#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/segmentation/corrections.h"
#include "core/segmentation/force_minima.h"

namespace kumite {

/// Where a boundary comes from. Accepted: detected, and a hand said that it is right.
enum class BoundarySource { End, Detected, Accepted, Moved, Added };

/// A frame at which one action ends and the next begins; it belongs to both.
struct Boundary {
    int frame = 0;
    BoundarySource source = BoundarySource::Detected;
    std::optional<int> minimum;  ///< index of the force minimum it stands for, if any

    bool operator==(const Boundary&) const = default;
};

/// What lies between two boundaries. `begin` and `end` are boundary frames (both inclusive: the
/// boundary frame belongs to both neighbours). The peak, the highest force strictly inside (the
/// first of equals; `begin` where nothing is inside), is the action's identity: labels stay with
/// it when boundaries move.
struct Action {
    int begin = 0;
    int end = 0;
    int peak = 0;

    bool operator==(const Action&) const = default;
};

/// A boundary that a hand took away: where it would stand, and the minimum that it stood for.
struct RemovedBoundary {
    int frame = 0;
    std::optional<int> minimum;  ///< index; nothing: a boundary that was added

    bool operator==(const RemovedBoundary&) const = default;
};

/// A fighter's stream cut into actions.
struct Segmentation {
    std::vector<Boundary> boundaries;      ///< in order of time; first and last frame always
    std::vector<Action> actions;           ///< gapless: actions[i].end == actions[i + 1].begin
    std::vector<RemovedBoundary> removed;  ///< what a hand took away and can bring back
    std::vector<Correction> unmatched;     ///< corrections that are without effect now
    /// For each correction, in their order, the index of the minimum that it means: that is
    /// removed, moved, accepted, or that an added boundary stands for.
    std::vector<std::optional<int>> meant;

    bool operator==(const Segmentation&) const = default;
};

/// The action that holds a frame, the later one at a boundary between two; null outside the take.
const Action* actionAt(const Segmentation& segmentation, int frame);

/// Boundaries = first frame, last frame, every minimum whose prominence reaches `threshold` (body
/// weights), and the corrections (method A2). `minima` are all minima of `curve`; `reach` is how
/// far a correction may look for its minimum, in frames. A curve of one frame gives one action
/// that begins and ends there; an empty curve gives nothing.
///
/// A removal, a move or an acceptance means the nearest minimum within reach that no other of its
/// kind means; one that cuts counts as half as far, because noise may be nearer than the minimum
/// that was meant. An added boundary stands for the nearest minimum within reach that cuts and that
/// no hand removed or moved, unless it was added beside another on purpose: so it is not cut twice
/// when a lower threshold finds the minimum. Corrections that mean nothing any more, or whose
/// boundary falls on another one's frame, are listed in `unmatched`.
Segmentation segment(std::span<const double> curve, std::span<const ForceMinimum> minima,
                     double threshold, std::span<const Correction> corrections, double reach);

}  // namespace kumite
