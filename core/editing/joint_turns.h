#pragma once

#include "core/motion/pose.h"

namespace kumite {

/// A turn in space that a joint gets on top of its own: about an axis through the joint.
struct JointTurn {
    int joint = 0;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  ///< unit, in space
    double angle = 0;                                 ///< radians
};

/// Turns a joint, with all that hangs on it, by `turn` in space. `frames` are those of `pose` as it
/// comes in; afterwards those of the joint and of what hangs on it are out of date.
void turnInSpace(const Rig& rig, Pose& pose, const JointFrames& frames, int joint,
                 const Eigen::Quaterniond& turn);
/// Gives a joint a rotation in space; only the frame of its parent in `frames` must be of `pose`.
void setTurnInSpace(const Rig& rig, Pose& pose, const JointFrames& frames, int joint,
                    const Eigen::Quaterniond& turn);

/// The turn about the joint at `pivot` that brings `from` into the direction of `to`, at most
/// `limit` radians of it. With `axis` it turns about that axis only. No turn where a direction is
/// missing.
JointTurn aimingTurn(int joint, const Eigen::Vector3d& pivot, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& to, double limit,
                     const std::optional<Eigen::Vector3d>& axis = {});

/// Yaw of a joint turned by `turn` in space: of the rest pose's forward direction, radians.
double yawOf(const Rig& rig, const Eigen::Quaterniond& turn);

/// The angle in (−π, π].
double wrapped(double angle);

}  // namespace kumite
