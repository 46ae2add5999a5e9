#pragma once

#include <optional>
#include <vector>

#include "core/project/analysis.h"
#include "core/project/import.h"
#include "studio/app/opening.h"

namespace kumite::studio {

/// What a request would make of recordings, as far as the import dialog shows it.
struct ImportLook {
    ImportedTake imported;
    std::vector<double> floors;  ///< of each fighter, metres in its file's space
    TimeSpan span;               ///< of the take's clock
    /// Between the pelvises over the floor, metres, at even moments of `span`; empty: one fighter.
    std::vector<double> distances;
    /// What both fighters reach in the bout's space, metres.
    Eigen::Vector3d low = Eigen::Vector3d::Zero();
    Eigen::Vector3d high = Eigen::Vector3d::Zero();

    double distanceAt(double seconds) const;
};

/// Throws Error where the request cannot be met. Cancellable. Any thread.
ImportLook lookAt(const TakeRequest& request, const Recordings& recordings,
                  const Progress& progress);

/// Joints of a fighter at a moment of the take's clock: metres in the bout's space.
std::vector<Eigen::Vector3d> poseAt(const ImportLook& look, int player, double seconds);

}  // namespace kumite::studio
