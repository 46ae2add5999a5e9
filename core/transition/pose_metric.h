#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/motion/pose.h"
#include "core/transition/metric_points.h"

namespace kumite {

/// What counts in the distance of two poses (method B, after Lee et al. 2002).
struct PoseMetricSettings {
    /// Weight of the rotation and the angular velocity of the joint with each role.
    std::array<double, kRoleCount> weights = defaultWeights();
    double velocityTime = 0.1;  ///< ν, seconds: how much 1 rad/s counts against 1 rad
    double heightWeight = 1;    ///< per metre of the root's height

    /// 1 for pelvis, spine, chest, shoulders, elbows, hips and knees, 0.3 for neck, wrists and
    /// ankles, 0 for others.
    static std::array<double, kRoleCount> defaultWeights();
    bool operator==(const PoseMetricSettings&) const = default;
};

/// Poses of one rig as points whose distance (see metricDistance) is
///     D = √( Σ w² θ² + ν² Σ w² |ω − ω'|² + (h − h')² )
/// θ the angle between two rotations of a joint, ω its angular velocity in its own axes, h the
/// root's height. The pelvis' rotation is that in space without its turn about the vertical;
/// place and heading do not count.
class PoseMetric {
public:
    explicit PoseMetric(const Rig& rig, const PoseMetricSettings& settings = {});

    const MetricShape& shape() const { return shape_; }

    /// The point of `frame`, `shape().width()` numbers; velocities are central differences,
    /// one-sided at the ends, 0 if there is one frame. `rate` in Hz.
    void point(std::span<const Pose> frames, int frame, double rate, double* out) const;
    /// Appends the points of all frames.
    void points(std::span<const Pose> frames, double rate, MetricPoints& out) const;
    /// Makes a point that of the same pose in a motion played backward.
    void reverse(double* point) const;

private:
    struct Joint {
        int index;
        double velocityScale;
    };
    Eigen::Quaterniond pelvisTurn(const Pose& pose) const;

    std::vector<int> pelvisChain_;  ///< joint 0 down to the pelvis
    bool hasPelvis_ = false;
    std::vector<Joint> joints_;  ///< with a weight; the pelvis first, if it counts
    double heightWeight_;
    MetricShape shape_;
};

}  // namespace kumite
