#pragma once

#include <vector>

#include "core/motion/kinematics.h"
#include "core/motion/roles.h"

namespace kumite {

/// The direction that a body faces at rest, a unit vector in the file's axes (method A2b):
/// (left hip − right hip) × up. Up is the space's y; where a skeleton rests lying, it is the axis
/// nearest to hips → neck. +z (of the space) where the roles do not tell.
Eigen::Vector3d restForward(const Skeleton& skeleton, const RoleMap& roles,
                            const SpaceConvention& space);

/// The same from joint positions at rest, in the axes and with the up (y) of those.
Eigen::Vector3d restForward(const std::vector<Eigen::Vector3d>& rest, const RoleMap& roles);

/// Heading (yaw) at each of `frames`: the horizontal part of the pelvis' rotation applied to the
/// rest pose's forward direction, atan2(x, z), 0 facing +z, radians, in the file's space: a
/// fighter's placement adds its own yaw. Interpolated where that direction is nearly vertical,
/// unwrapped: neighbouring frames differ by less than π.
std::vector<double> headings(const Motion& motion, FrameRange frames, const SpaceConvention& space,
                             const RoleMap& roles);

}  // namespace kumite
