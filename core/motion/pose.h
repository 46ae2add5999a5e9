#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/progress.h"
#include "core/motion/rig.h"

namespace kumite {

/// A rig's stance at one moment, in the common space.
struct Pose {
    /// Position of joint 0 (and of the rig's traveller), metres.
    Eigen::Vector3d root = Eigen::Vector3d::Zero();
    /// Rotation of every joint relative to its parent (joint 0: to the space), unit; End Sites
    /// have the identity. All the identity is the rest pose.
    std::vector<Eigen::Quaterniond> turns;
};

/// Poses of one rig at `rate` Hz.
struct Clip {
    std::shared_ptr<const Rig> rig;
    double rate = 0;
    std::vector<Pose> frames;

    int frameCount() const { return static_cast<int>(frames.size()); }
    /// From the first frame to the last, seconds.
    double seconds() const { return frames.empty() ? 0 : (frameCount() - 1) / rate; }
};

/// World position and rotation of every joint. Kept by the caller, so that a stream of poses
/// allocates once.
struct JointFrames {
    std::vector<Eigen::Vector3d> positions;  ///< metres
    std::vector<Eigen::Quaterniond> turns;
};

/// `frames` of a motion as poses of its own rig (see `rigOf` and `rigLosses`). `rate` in Hz; what
/// the motion's frame time means, if not given. Neighbouring rotations lie on the same side of the
/// quaternions' sphere. Cancellable.
Clip clipOf(const Motion& motion, FrameRange frames, const SpaceConvention& space,
            const RoleMap& roles, std::optional<double> rate = {}, const Progress& progress = {});

/// The same on a rig that is already there (of this skeleton): clips that are to be joined share
/// one.
Clip clipOf(const Motion& motion, FrameRange frames, const SpaceConvention& space,
            std::shared_ptr<const Rig> rig, std::optional<double> rate = {},
            const Progress& progress = {});

/// A clip as channels of the skeleton `like` (same joints as the rig) in the space `space`.
/// Angles follow the previous frame's without jumps of full turns. Joints with position channels
/// are put where the rig has them; the joints above the traveller stay at their offset. A rotation
/// that a joint's channels cannot show (a knee of one axis) is brought to the nearest they can.
/// Throws Error if the joints differ.
Motion motionOf(const Clip& clip, std::shared_ptr<const Skeleton> like,
                const SpaceConvention& space, const Progress& progress = {});

/// Forward kinematics of one pose; no allocation when `out` is used again.
void jointFrames(const Rig& rig, const Pose& pose, JointFrames& out);
/// Forward kinematics of a clip, frame by frame.
JointPositions positionsOf(const Clip& clip);

/// Yaw of a pose: the horizontal part of the pelvis' turn applied to the rest pose's forward
/// direction, atan2(x, z), radians in (−π, π]; nothing where it is nearly vertical (method A2b).
std::optional<double> headingOf(const Rig& rig, const Pose& pose);

}  // namespace kumite
