#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/motion/body_model.h"
#include "core/motion/kinematics.h"
#include "core/motion/roles.h"

namespace kumite {

/// The path of the body's centre of mass, c(t) = Σ mᵢ rᵢ(t) / Σ mᵢ (method A1).
struct CentreOfMass {
    std::vector<Eigen::Vector3d> position;  ///< metres, y up, one per frame
    double massCoverage = 0;                ///< share of the body's mass that the skeleton carries
    std::vector<std::string> missingSegments;
};

/// Segments whose roles the skeleton lacks are left out, the rest renormalised. Without a single
/// segment (not a body) `position` is empty and massCoverage is 0.
CentreOfMass centreOfMass(const BodyModel& model, const Skeleton& skeleton, const RoleMap& roles,
                          const JointPositions& positions);

}  // namespace kumite
