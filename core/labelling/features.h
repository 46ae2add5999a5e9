#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/finding.h"
#include "core/motion/kinematics.h"
#include "core/motion/roles.h"
#include "core/segmentation/segmentation.h"

namespace kumite {

/// The 17 joints of the paper's pose beside the pelvis, in the order of the feature vector.
/// Left and right stand side by side.
inline constexpr std::array<Role, 17> kFeatureRoles = {
    Role::Spine,     Role::Neck,       Role::Head,      Role::LeftShoulder, Role::RightShoulder,
    Role::LeftElbow, Role::RightElbow, Role::LeftWrist, Role::RightWrist,   Role::LeftHip,
    Role::RightHip,  Role::LeftKnee,   Role::RightKnee, Role::LeftAnkle,    Role::RightAnkle,
    Role::LeftToe,   Role::RightToe};

inline constexpr int kPosesPerAction = 10;
inline constexpr int kNumbersPerPose = 3 + 3 * static_cast<int>(kFeatureRoles.size());
inline constexpr int kFeatureCount = kPosesPerAction * kNumbersPerPose;  // 540

/// The joint of each feature role. A toe that is missing is the ankle's End Site; another missing
/// joint takes its parent's place and is reported in `findings`. No pelvis: Error.
std::array<int, kFeatureRoles.size()> featureJoints(const Skeleton& skeleton, const RoleMap& roles,
                                                    Findings* findings = nullptr);

/// A vector with a heading taken off: what the body that has it sees, x to its left, z ahead.
Eigen::Vector3d withoutYaw(const Eigen::Vector3d& v, double yaw);

/// A stream of poses to sample: the root's and the joints' positions at whole frames (metres, y
/// up) and the heading per frame (radians, unwrapped).
struct PoseStream {
    std::function<Eigen::Vector3d(int frame)> root;
    std::function<Eigen::Vector3d(int frame, int joint)> joint;
    int jointCount = 0;
    std::span<const double> yaw;
};

/// The feature numbers of an action over the boundary frames [begin, end], both included (method
/// A4): `poses` samples equally spaced in time, interpolated between frames. Each sample: root
/// translation x, z and yaw since the last sample, in the last sample's yaw frame (0 for the
/// first), then the joints relative to the root with the root's yaw taken off.
std::vector<double> sampleAction(const PoseStream& stream, int begin, int end,
                                 int poses = kPosesPerAction);

/// One row of 540 numbers per action; they do not depend on where on the floor the fighter stands
/// and which way it faces.
using FeatureMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Feature rows of a fighter's actions. `yaw` as headings() gives it; joints as featureJoints.
FeatureMatrix actionFeatures(const Skeleton& skeleton, const RoleMap& roles,
                             const JointPositions& positions, std::span<const double> yaw,
                             std::span<const Action> actions, Findings* findings = nullptr);

/// A row as a mirror shows it: roles swapped, x, sideways translation and yaw reversed. A
/// permutation with signs, so distances between two mirrored rows are those between the rows.
void mirrorFeatures(std::span<const float> row, std::span<float> mirrored);

}  // namespace kumite
