#pragma once

#include <QString>

#include <optional>
#include <span>
#include <vector>

#include "studio/app/boundary_marks.h"

namespace kumite::studio {

/// What a dragged boundary is drawn to. Of two as near, the one that stands first here.
enum class SnapKind { Minimum, Contact, OtherFighter, Playhead };

/// "minimum", "boundary of the other", …
QString snapText(SnapKind kind);

struct SnapTarget {
    SnapKind kind = SnapKind::Minimum;
    int frame = 0;

    bool operator==(const SnapTarget&) const = default;
};

/// The target nearest to a frame within `reach` frames.
std::optional<SnapTarget> nearestTarget(std::span<const SnapTarget> targets, double frame,
                                        double reach);

/// The frames that a boundary may be dragged to: strictly between its live neighbours.
struct DragLimits {
    int low = 0;
    int high = 0;
};
DragLimits dragLimits(const std::vector<BoundaryMark>& marks, int frame, int frameCount);

}  // namespace kumite::studio
