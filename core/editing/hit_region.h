#pragma once

#include "core/base/progress.h"
#include "core/editing/hit.h"

namespace kumite {

/// The box of targets that partial blending reaches (paper C, Fig. 3): the samples' box, every face
/// moved outward in steps of `step` metres, at most `most`, as long as more than half of nine
/// probes on it hit within the tolerance.
Box extendedBox(const StrikeSpace& space, const HitSettings& settings = {}, double step = 0.05,
                double most = 0.3, const Progress& progress = {});

/// How much of a box is hit within the tolerance: by blends of whole examples (the natural region)
/// and with partial blending (the extended one), counted in cells of about `size` metres a side.
struct Coverage {
    int cells = 0;     ///< that the box is divided into
    int natural = 0;   ///< cells whose middle a whole blend hits
    int extended = 0;  ///< cells whose middle either way hits
    double cell = 0;   ///< m³

    double naturalVolume() const { return natural * cell; }    ///< m³
    double extendedVolume() const { return extended * cell; }  ///< m³
};
/// On all cores. Cancellable.
Coverage coverageOf(const StrikeSpace& space, const Box& box, double size,
                    const HitSettings& settings = {}, const Progress& progress = {});

}  // namespace kumite
