#include "core/labelling/features.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/motion/feet.h"

namespace kumite {
namespace {

/// Whose place a joint takes where the skeleton has none.
Role parentOf(Role role) {
    switch (role) {
        case Role::Head:
            return Role::Neck;
        case Role::Neck:
        case Role::LeftClavicle:
        case Role::RightClavicle:
            return Role::Chest;
        case Role::Chest:
            return Role::Spine;
        case Role::LeftShoulder:
            return Role::LeftClavicle;
        case Role::RightShoulder:
            return Role::RightClavicle;
        case Role::LeftElbow:
            return Role::LeftShoulder;
        case Role::RightElbow:
            return Role::RightShoulder;
        case Role::LeftWrist:
            return Role::LeftElbow;
        case Role::RightWrist:
            return Role::RightElbow;
        case Role::LeftKnee:
            return Role::LeftHip;
        case Role::RightKnee:
            return Role::RightHip;
        case Role::LeftAnkle:
            return Role::LeftKnee;
        case Role::RightAnkle:
            return Role::RightKnee;
        case Role::LeftToe:
            return Role::LeftAnkle;
        case Role::RightToe:
            return Role::RightAnkle;
        default:
            return Role::Pelvis;
    }
}

int jointFor(Role role, const Skeleton& skeleton, const RoleMap& roles, std::string& missing) {
    if (const auto joint = roles[role]) return *joint;
    if (role == Role::LeftToe || role == Role::RightToe) {
        if (const auto foot = footPoint(skeleton, roles, role == Role::LeftToe)) return *foot;
    }
    missing += (missing.empty() ? "" : ", ") + std::string(roleName(role));
    for (role = parentOf(role); !roles.has(role); role = parentOf(role)) {
        assert(role != Role::Pelvis);
    }
    return *roles[role];
}

/// Where in a row the numbers of a mirrored pose come from: left and right stand side by side.
int mirrorOf(std::size_t joint) {
    const Role other = mirrored(kFeatureRoles[joint]);
    return static_cast<int>(std::find(kFeatureRoles.begin(), kFeatureRoles.end(), other) -
                            kFeatureRoles.begin());
}

}  // namespace

Eigen::Vector3d withoutYaw(const Eigen::Vector3d& v, double yaw) {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {c * v.x() - s * v.z(), v.y(), s * v.x() + c * v.z()};
}

std::array<int, kFeatureRoles.size()> featureJoints(const Skeleton& skeleton, const RoleMap& roles,
                                                    Findings* findings) {
    if (!roles.has(Role::Pelvis)) {
        throw Error("No joint has the role pelvis: actions cannot be compared.");
    }
    std::string missing;
    std::array<int, kFeatureRoles.size()> joints{};
    for (std::size_t i = 0; i < joints.size(); ++i)
        joints[i] = jointFor(kFeatureRoles[i], skeleton, roles, missing);
    if (!missing.empty() && findings) {
        findings->push_back(
            warning("For labelling, these joints take their parents' place: " + missing + "."));
    }
    return joints;
}

std::vector<double> sampleAction(const PoseStream& stream, int begin, int end, int poses) {
    std::vector<double> numbers;
    numbers.reserve(static_cast<std::size_t>(poses * (3 + 3 * stream.jointCount)));
    Eigen::Vector3d lastRoot = Eigen::Vector3d::Zero();
    double lastYaw = 0;
    for (int pose = 0; pose < poses; ++pose) {
        const double time = begin + static_cast<double>(pose) * (end - begin) / (poses - 1);
        const int before = std::min(static_cast<int>(time), end);
        const int after = std::min(before + 1, end);
        const double share = time - before;
        const auto between = [&](const auto& at) -> Eigen::Vector3d {
            return (1 - share) * at(before) + share * at(after);
        };
        const Eigen::Vector3d root = between(stream.root);
        const double yaw = (1 - share) * stream.yaw[static_cast<std::size_t>(before)] +
                           share * stream.yaw[static_cast<std::size_t>(after)];
        if (pose == 0) {
            numbers.insert(numbers.end(), {0.0, 0.0, 0.0});
        } else {
            const Eigen::Vector3d step = withoutYaw(root - lastRoot, lastYaw);
            numbers.insert(numbers.end(), {step.x(), step.z(),
                                           std::remainder(yaw - lastYaw, 2 * std::numbers::pi)});
        }
        for (int joint = 0; joint < stream.jointCount; ++joint) {
            const Eigen::Vector3d local = withoutYaw(
                between([&](int frame) { return stream.joint(frame, joint); }) - root, yaw);
            numbers.insert(numbers.end(), {local.x(), local.y(), local.z()});
        }
        lastRoot = root;
        lastYaw = yaw;
    }
    return numbers;
}

FeatureMatrix actionFeatures(const Skeleton& skeleton, const RoleMap& roles,
                             const JointPositions& positions, std::span<const double> yaw,
                             std::span<const Action> actions, Findings* findings) {
    const auto joints = featureJoints(skeleton, roles, findings);
    const int pelvis = *roles[Role::Pelvis];
    PoseStream stream;
    stream.jointCount = static_cast<int>(joints.size());
    stream.yaw = yaw;
    stream.root = [&](int frame) -> Eigen::Vector3d {
        return positions.at(frame, pelvis).cast<double>();
    };
    stream.joint = [&](int frame, int joint) -> Eigen::Vector3d {
        return positions.at(frame, joints[static_cast<std::size_t>(joint)]).cast<double>();
    };
    FeatureMatrix features(static_cast<Eigen::Index>(actions.size()), kFeatureCount);
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const std::vector<double> row = sampleAction(stream, actions[i].begin, actions[i].end);
        features.row(static_cast<Eigen::Index>(i)) =
            Eigen::Map<const Eigen::RowVectorXd>(row.data(), kFeatureCount).cast<float>();
    }
    return features;
}

void mirrorFeatures(std::span<const float> row, std::span<float> out) {
    assert(row.size() == kFeatureCount && out.size() == kFeatureCount);
    for (std::size_t pose = 0; pose < kPosesPerAction; ++pose) {
        const float* from = row.data() + pose * kNumbersPerPose;
        float* to = out.data() + pose * kNumbersPerPose;
        to[0] = -from[0];
        to[1] = from[1];
        to[2] = -from[2];
        for (std::size_t joint = 0; joint < kFeatureRoles.size(); ++joint) {
            const float* source = from + 3 + 3 * mirrorOf(joint);
            float* target = to + 3 + 3 * joint;
            target[0] = -source[0];
            target[1] = source[1];
            target[2] = source[2];
        }
    }
}

}  // namespace kumite
