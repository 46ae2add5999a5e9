#pragma once

#include <span>
#include <vector>

#include "core/motion/pose.h"

namespace kumite {

/// How fast joints turn and how suddenly: one value per frame and joint that has a role, of the
/// joint's turn relative to its parent.
struct JointMotion {
    std::vector<float> velocity;      ///< rad/s
    std::vector<float> acceleration;  ///< rad/s²
};

inline constexpr double kAfterJoin = 0.2;  ///< seconds behind a join that count as at it

/// A clip's joint motion, parted at its joins: what lies from the frame before a join until
/// `after` seconds behind it, and the rest.
struct JoinMotion {
    JointMotion atJoins;
    JointMotion inside;
};

/// `joins` are frames of the clip at which one action ends and the next begins. The velocity of
/// frame f is that of the turn from f to f + 1; its acceleration the change of velocity over f.
JoinMotion measureJoins(const Clip& clip, std::span<const int> joins, double after = kAfterJoin);

/// The value below which the share `p` of the values lies, linear between ranks; 0 of none.
double percentile(std::vector<float> values, double p);

/// The 99th percentiles that joins are held against.
struct JointMotionBar {
    double velocity = 0;      ///< rad/s
    double acceleration = 0;  ///< rad/s²
};
JointMotionBar barOf(const JointMotion& motion);

}  // namespace kumite
