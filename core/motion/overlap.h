#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/motion/kinematics.h"
#include "core/motion/roles.h"

namespace kumite {

/// A limb or trunk as a solid: all points within `radius` of the line from `a` to `b`. Metres.
struct Capsule {
    Eigen::Vector3d a = Eigen::Vector3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    double radius = 0;
};

/// A part of every body: the capsule between two joints, by role.
struct BodySolid {
    Role from;
    Role to;
    double radius;  ///< metres, of a slim adult
};
/// Trunk, arms, legs and feet, and the neck; the skull goes on beyond the head's joint.
std::span<const BodySolid> bodySolids();
inline constexpr double kSkullRadius = 0.09;

/// A body's solids at one frame, from the joints that have roles: trunk, head, arms, legs, feet.
/// Radii are those of a slim adult, so that what touches is not yet overlapping. Joints without a
/// role leave their solids out.
std::vector<Capsule> bodyCapsules(const RoleMap& roles, const JointPositions& positions, int frame);

/// A solid of a body and the joints that it spans.
struct BodyCapsule {
    Capsule solid;
    Role from = Role::Pelvis;
    Role to = Role::Pelvis;  ///< of the skull: Head, like `from`
};
/// The same solids from joint positions in space (metres, by joint). No allocation when `out` is
/// used again.
void bodyCapsules(const RoleMap& roles, std::span<const Eigen::Vector3d> positions,
                  std::vector<BodyCapsule>& out);

/// Where two solids are nearest to each other.
struct Nearness {
    double depth = 0;  ///< sum of the radii less the distance of the lines; above 0: overlapping
    /// From the second's line to the first's, a unit vector; 0 where the lines cross.
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double alongFirst = 0;  ///< share of the way from a to b
    double alongSecond = 0;
};
Nearness nearness(const Capsule& first, const Capsule& second);

/// How deep two bodies are in each other: the largest, over all pairs, of the sum of radii less
/// the distance of the lines. 0 or less: apart. Metres; −infinity for an empty body.
double overlap(const std::vector<Capsule>& first, const std::vector<Capsule>& second);

}  // namespace kumite
