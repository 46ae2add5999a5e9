#pragma once

#include <optional>
#include <vector>

#include "core/project/analysis.h"

namespace kumite::studio {

/// What a boundary on the timeline is. Removed ones are shown as ghosts that can be restored.
enum class MarkState { End, Detected, Accepted, Moved, Added, Removed };

/// A boundary of one fighter, kept or removed, as the views show it.
struct BoundaryMark {
    int frame = 0;
    MarkState state = MarkState::Detected;
    std::optional<int> minimum;  ///< index of the force minimum that it stands for
    double suspicion = 0;        ///< of that minimum, 0…1

    bool isLive() const { return state != MarkState::Removed; }
    /// A minimum that nobody has judged yet.
    bool isOpen() const { return state == MarkState::Detected; }
    /// An open one that is worth a look.
    bool isSuspect() const { return isOpen() && suspicion >= kSuspect; }
    bool isEditable() const { return state != MarkState::End; }
};

/// All boundaries of a fighter in order of time; at one frame the live one stands first.
std::vector<BoundaryMark> boundaryMarks(const FighterAnalysis& fighter);

/// The mark nearest to a frame within `reach` frames, live ones before ghosts at equal distance;
/// null if none. Ends are found only if `ends` says so.
const BoundaryMark* nearestMark(const std::vector<BoundaryMark>& marks, double frame, double reach,
                                bool ends = false);

}  // namespace kumite::studio
