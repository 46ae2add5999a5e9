#pragma once

#include <optional>

#include "core/motion/pose.h"

namespace kumite {

/// Where the middle joint of a limb lies that spans from `root` to `end`, in metres.
struct TwoBone {
    Eigen::Vector3d middle;
    Eigen::Vector3d end;
};

/// How far a limb folds and stretches, as shares of the sum of its bones.
struct Stretch {
    double least = 0.33;   ///< about 38° at the joint: calf on thigh
    double most = 0.9985;  ///< a knee or elbow never locks

    bool operator==(const Stretch&) const = default;
};

/// Bends a limb of two bones: its middle lies in the plane of `pole`, on its side. A target too far
/// or too near is brought within what a knee or elbow can do.
TwoBone bend(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
             const Eigen::Vector3d& pole, double upper, double lower, const Stretch& stretch = {});

/// The rotation that takes y to `along` and turns z as near to `ahead` as it can.
Eigen::Matrix3d turnWithY(const Eigen::Vector3d& along, const Eigen::Vector3d& ahead);

/// The rotation that takes x to `along` and turns y as near to `above` as it can.
Eigen::Matrix3d turnWithX(const Eigen::Vector3d& along, const Eigen::Vector3d& above);

/// Rotations about the axes, right-handed, radians.
Eigen::Matrix3d aboutX(double angle);
Eigen::Matrix3d aboutY(double angle);
Eigen::Matrix3d aboutZ(double angle);

/// An arm or a leg of a rig: the joints at its root (shoulder, hip), middle (elbow, knee) and end
/// (wrist, ankle). Joints between them, such as twist joints, ride along.
struct Limb {
    int root = -1;
    int middle = -1;
    int end = -1;
    bool isLeg = false;
};

/// The limb that ends in LeftWrist, RightWrist, LeftAnkle or RightAnkle; nothing where a joint is
/// missing or does not hang below the one before it.
std::optional<Limb> limbOf(const Rig& rig, Role end);

/// What becomes of the hand or foot when its limb is bent.
enum class EndTurn {
    KeepsWorld,  ///< it stays turned as it is in space: a standing foot
    KeepsLocal   ///< it rides along with the forearm or shank
};

/// Turns the limb's root and middle joint so that its end comes to `target` (metres). The plane in
/// which the limb is bent turns only as far as the line from root to end does. A limb that is
/// straight bends as knees (forward) and elbows (backward) do. A limb that `pose` shows straighter
/// or more folded than `stretch` may stay so. `frames` are the joint frames of `pose` as it comes
/// in; afterwards those of the limb and of what hangs on it are out of date. Returns what
/// the end is from the target, metres: zero within reach.
Eigen::Vector3d reach(const Rig& rig, Pose& pose, const JointFrames& frames, const Limb& limb,
                      const Eigen::Vector3d& target, EndTurn endTurn = EndTurn::KeepsWorld,
                      const Stretch& stretch = {});

}  // namespace kumite
