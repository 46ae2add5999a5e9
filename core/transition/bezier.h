#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/motion/pose.h"
#include "core/transition/pose_clusters.h"

namespace kumite {

/// The clusters that a transition without a path is led through (paper B, Fig. 7), both ends
/// included: from each one to the nearest of those that are nearer to the target than it is itself
/// (of equals the lower number).
std::vector<int> medoidWalk(const PoseTree& centres, int source, int target);

/// The mean pose: of roots, and of each joint's rotations (the unit quaternion nearest to all of
/// them, sign-aligned sum). At least one pose; all of one rig.
Pose meanPose(std::span<const Pose> poses);

/// A cubic Bézier curve through pose space (paper B, Fig. 8): source, the means of the first and
/// the second half of the visited poses, target. Rotations by de Casteljau's construction with
/// slerp, the root on the curve itself.
struct PoseCurve {
    std::array<Pose, 4> points;

    /// u in [0, 1]; the ends are exactly source and target. All derivatives are continuous between.
    Pose at(double u) const;
};

/// The curve past `visited` poses; an odd one in the middle belongs to both halves. Without any the
/// curve goes straight, at even speed.
PoseCurve curveThrough(const Pose& source, std::span<const Pose> visited, const Pose& target);

}  // namespace kumite
