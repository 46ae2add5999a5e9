#include "core/motion/kinematics.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"

namespace kumite {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// rotation · (rotation by `degrees` about a coordinate axis), in place: only two columns change.
void rotateAbout(int axis, double degrees, Eigen::Matrix3d& rotation) {
    if (degrees == 0) return;
    const double angle = degrees * kRadians;
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const Eigen::Vector3d first = rotation.col(u);
    const Eigen::Vector3d second = rotation.col(v);
    rotation.col(u) = c * first + s * second;
    rotation.col(v) = c * second - s * first;
}

/// The joint's place and turn relative to its parent, applied to the parent's world transform.
struct JointFrame {
    Eigen::Matrix3d rotation;
    Eigen::Vector3d position;
};

/// A skeleton's per-joint facts in the form that the inner loop wants.
struct Plan {
    const Skeleton& skeleton;
    std::vector<char> hasFrame;  ///< the joint's rotations act in a frame of their own

    explicit Plan(const Skeleton& s) : skeleton(s) {
        for (const Joint& joint : s.joints)
            hasFrame.push_back(!joint.rotationFrame.isIdentity(0));
    }

    void place(std::size_t index, const double* row, std::vector<JointFrame>& frames) const {
        const Joint& joint = skeleton.joints[index];
        JointFrame& own = frames[index];
        Eigen::Vector3d offset = joint.offset;
        if (joint.parent >= 0) {
            own.rotation = frames[static_cast<std::size_t>(joint.parent)].rotation;
        } else {
            own.rotation.setIdentity();
        }
        const double* values = row + joint.firstChannel;
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            if (!isRotation(joint.channels[c])) offset[axisOf(joint.channels[c])] = values[c];
        }
        if (joint.parent >= 0) {
            own.position =
                frames[static_cast<std::size_t>(joint.parent)].position + own.rotation * offset;
        } else {
            own.position = offset;
        }
        if (hasFrame[index]) own.rotation = own.rotation * joint.rotationFrame;
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            if (isRotation(joint.channels[c])) {
                rotateAbout(axisOf(joint.channels[c]), values[c], own.rotation);
            }
        }
        if (hasFrame[index]) own.rotation = own.rotation * joint.rotationFrame.transpose();
    }
};

}  // namespace

Eigen::Vector3d SpaceConvention::toWorld(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d turned = up == UpAxis::Y ? p : Eigen::Vector3d(p.x(), p.z(), -p.y());
    return metresPerUnit * turned;
}

JointPositions forwardKinematics(const Motion& motion, FrameRange frames,
                                 const SpaceConvention& space, const Progress& progress) {
    const Plan plan(*motion.skeleton);
    const std::size_t joints = motion.skeleton->joints.size();
    JointPositions result;
    result.frameCount = frames.size();
    result.jointCount = static_cast<int>(joints);
    result.xyz.resize(3 * joints * static_cast<std::size_t>(frames.size()));

    std::atomic<int> done{0};
    constexpr int kBlock = 512;
    forBlocks(frames, kBlock, [&](FrameRange block) {
        std::vector<JointFrame> world(joints);
        for (int frame = block.begin; frame < block.end; ++frame) {
            const double* row = motion.frame(frame).data();
            float* out =
                result.xyz.data() + 3 * joints * static_cast<std::size_t>(frame - frames.begin);
            for (std::size_t j = 0; j < joints; ++j) {
                plan.place(j, row, world);
                const Eigen::Vector3d position = space.toWorld(world[j].position);
                for (int axis = 0; axis < 3; ++axis)
                    *out++ = static_cast<float>(position[axis]);
            }
        }
        done += block.size();
        progress.update(static_cast<double>(done) / frames.size());
    });
    return result;
}

Eigen::Matrix3d localRotation(const Joint& joint, std::span<const double> frameChannels) {
    Eigen::Matrix3d rotation = joint.rotationFrame;
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        if (!isRotation(joint.channels[c])) continue;
        rotateAbout(axisOf(joint.channels[c]),
                    frameChannels[static_cast<std::size_t>(joint.firstChannel) + c], rotation);
    }
    return rotation * joint.rotationFrame.transpose();
}

float jointSpeed(const JointPositions& positions, int joint, int frame, double rate) {
    const int before = std::max(0, frame - 1);
    const int after = std::min(positions.frameCount - 1, frame + 1);
    if (after <= before) return 0.0f;
    const float way = (positions.at(after, joint) - positions.at(before, joint)).norm();
    return way * static_cast<float>(rate) / static_cast<float>(after - before);
}

}  // namespace kumite
