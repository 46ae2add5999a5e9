#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/labelling/features.h"

namespace kumite {

/// Local positions of the 17 joints relative to the pelvis with its heading taken off: 51 numbers,
/// metres (paper A, section 4.1).
inline constexpr int kPoseNumbers = 3 * static_cast<int>(kFeatureRoles.size());
using LocalPose = Eigen::Matrix<double, kPoseNumbers, 1>;

/// What the interaction looks at of one fighter of a take, over its frames. Refers to its parts.
struct FighterTrack {
    const JointPositions* positions = nullptr;  ///< metres, y up, the file's space
    int pelvis = 0;
    std::array<int, kFeatureRoles.size()> joints{};  ///< see featureJoints
    std::span<const double> heading;                 ///< radians, unwrapped, the file's space
    std::span<const Eigen::Vector3d> com;            ///< metres, the file's space
    double rate = 0;                                 ///< Hz
    double offset = 0;                               ///< seconds on the take's clock of frame 0
    /// Where the file's origin stands in the bout's space, and how it is turned (radians).
    double x = 0;
    double z = 0;
    double yaw = 0;

    int frameCount() const { return positions->frameCount; }
    LocalPose pose(int frame) const;
    /// A point of the file's space on the bout's floor: x and z, metres.
    Eigen::Vector2d ground(const Eigen::Vector3d& point) const;
    Eigen::Vector2d root(int frame) const;
    Eigen::Vector2d comOnGround(int frame) const;
    /// The frame nearest to a moment of the take's clock; clamped.
    int frameAt(double seconds) const;
};

/// Count, sum and squares of poses. Moments of parts add up to those of the whole.
struct PoseMoments {
    double count = 0;
    LocalPose sum = LocalPose::Zero();
    Eigen::Matrix<double, kPoseNumbers, kPoseNumbers> squares =
        Eigen::Matrix<double, kPoseNumbers, kPoseNumbers>::Zero();

    void add(const PoseMoments& other);
};
/// Of a range of frames, on all cores; the result does not depend on their number. Cancellable.
PoseMoments poseMoments(const FighterTrack& track, FrameRange frames,
                        const Progress& progress = {});

/// Principal components of local poses.
struct PoseSpace {
    LocalPose mean = LocalPose::Zero();
    /// Unit vectors by falling variance; of each, the largest element is positive.
    Eigen::Matrix<double, kPoseNumbers, kPoseNumbers> axes =
        Eigen::Matrix<double, kPoseNumbers, kPoseNumbers>::Identity();
    LocalPose variances = LocalPose::Zero();  ///< square metres

    /// Share of the variance in the first k coordinates; 0 where nothing varies.
    double covered(int k) const;
};
/// Of no poses at all: no variance, the coordinates themselves.
PoseSpace poseSpace(const PoseMoments& moments);

}  // namespace kumite
