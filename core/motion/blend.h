#pragma once

#include <span>

#include "core/motion/pose.h"

namespace kumite {

/// A turn about y and a shift on the floor: p becomes Ry(yaw) · p + (x, 0, z). Metres, radians,
/// positive yaw turns +z toward +x.
struct GroundTransform {
    double yaw = 0;
    double x = 0;
    double z = 0;

    Eigen::Vector3d operator*(const Eigen::Vector3d& point) const;
    /// First `inner`, then this one.
    GroundTransform operator*(const GroundTransform& inner) const;
    GroundTransform inverse() const;
    Eigen::Quaterniond turn() const;
};

/// The transform that brings the points `from` as near to the points `to` as it can: least sum of
/// weighted squared distances, in closed form (Kovar, Gleicher, Pighin 2002, section 3.1). Equal
/// weights if none are given; the turn is 0 where the points do not tell it.
GroundTransform groundAlignment(std::span<const Eigen::Vector3d> from,
                                std::span<const Eigen::Vector3d> to,
                                std::span<const double> weights = {});

/// The transform that brings pose `from` to the place and heading (of joint 0's turn about y) of
/// pose `to`: `moved(from, …)` stands where `to` stands and faces where it faces.
GroundTransform groundAlignment(const Rig& rig, const Pose& from, const Pose& to);

/// `a` at weight 0, `b` at 1: rotations by slerp the short way, the root on a straight line.
Pose blend(const Pose& a, const Pose& b, double weight);

/// The pose turned about the space's y axis and shifted on the floor.
Pose moved(const Pose& pose, const GroundTransform& transform);
Clip moved(Clip clip, const GroundTransform& transform);

/// The pose at a time after the first frame, in seconds; blended between frames, clamped to the
/// clip's ends. The clip must have a frame.
Pose poseAt(const Clip& clip, double seconds);
/// The same motion at another rate, as long as before to within a frame.
Clip resampled(const Clip& clip, double rate);

/// How a rig's left and right belong together: what `mirrored` needs, made once per rig.
struct Mirror {
    std::vector<int> partner;  ///< per joint the one on the other side, itself in the middle
    /// The rig's sideways direction at rest: local axes are mirrored along it.
    Eigen::Vector3d sideways = Eigen::Vector3d::UnitX();
    /// Largest difference between an offset and the mirror image of its partner's, metres: how far
    /// a mirrored pose can be from the mirror image.
    double asymmetry = 0;
};
/// Partners by roles first, then by what hangs on partners (fingers, End Sites): names whose left
/// and right are exchanged, else the order. Joints without partner stand for themselves.
Mirror mirrorOf(const Rig& rig);
/// The pose seen in the mirror x = 0, right for left.
Pose mirrored(const Mirror& mirror, const Pose& pose);
Pose mirrored(const Rig& rig, const Pose& pose);

}  // namespace kumite
