#include "core/motion/pose.h"

#include <atomic>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/motion/euler.h"

namespace kumite {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr int kBlock = 512;
constexpr double kDegrees = 180.0 / std::numbers::pi;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// The file's axes in the common space, without scale.
Matrix3d axesOf(const SpaceConvention& space) {
    const SpaceConvention unit{1.0, space.up};
    Matrix3d axes;
    for (int axis = 0; axis < 3; ++axis)
        axes.col(axis) = unit.toWorld(Vector3d::Unit(axis));
    return axes;
}

/// Where the traveller is at a frame: along the channels of the joints down to it, file units.
Vector3d travellerPosition(const Skeleton& skeleton, std::span<const double> row,
                           const std::vector<int>& chain) {
    Matrix3d turn = Matrix3d::Identity();
    Vector3d position = Vector3d::Zero();
    for (const int index : chain) {
        const Joint& joint = skeleton.joints[at(index)];
        Vector3d offset = joint.offset;
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            if (!isRotation(joint.channels[c]))
                offset[axisOf(joint.channels[c])] = row[at(joint.firstChannel) + c];
        }
        position += turn * offset;
        turn = turn * localRotation(joint, row);
    }
    return position;
}

/// The traveller and the joints above it, joint 0 first.
std::vector<int> chainToTraveller(const Rig& rig) {
    std::vector<int> chain;
    for (int joint = rig.traveller; joint >= 0; joint = rig.joint(joint).parent)
        chain.insert(chain.begin(), joint);
    return chain;
}

/// Angles of the joint's rotation channels, in their order, that come nearest to the rotation
/// `turn` (= product of the channels' rotations); `before` holds the previous frame's.
std::array<double, 3> anglesOf(const Matrix3d& turn, const std::vector<int>& axes,
                               const std::array<double, 3>& before) {
    const auto unwrapped = [](double angle, double previous) {
        return angle + 360.0 * std::round((previous - angle) / 360.0);
    };
    if (axes.size() == 3) return eulerAngles(turn, {axes[0], axes[1], axes[2]}, before);
    std::array<double, 3> angles{};
    if (axes.size() == 1) {
        // The twist about the axis.
        const Quaterniond q(turn);
        angles[0] = unwrapped(2 * std::atan2(q.vec()[axes[0]], q.w()) * kDegrees, before[0]);
    } else if (axes.size() == 2) {
        // R = Ri(a) Rj(b): column j is Ri(a) ej, row i is ei Rj(b).
        const int i = axes[0], j = axes[1], k = 3 - i - j;
        const double sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
        angles[0] = unwrapped(std::atan2(sign * turn(k, j), turn(j, j)) * kDegrees, before[0]);
        angles[1] = unwrapped(std::atan2(sign * turn(i, k), turn(i, i)) * kDegrees, before[1]);
    }
    return angles;
}

/// Writes poses into the channels of a skeleton, frame after frame.
class ChannelWriter {
public:
    ChannelWriter(const Rig& rig, const Skeleton& skeleton, const SpaceConvention& space)
        : rig_(rig),
          skeleton_(skeleton),
          toFile_(axesOf(space).transpose()),
          unitsPerMetre_(1.0 / space.metresPerUnit),
          before_(skeleton.joints.size()),
          turns_(skeleton.joints.size()),
          positions_(skeleton.joints.size()) {
        for (const Joint& joint : skeleton.joints) {
            std::vector<int>& axes = axes_.emplace_back();
            for (const Channel channel : joint.channels) {
                if (isRotation(channel)) axes.push_back(axisOf(channel));
            }
        }
        for (const int joint : chainToTraveller(rig)) {
            if (joint != rig.traveller) isAbove_.push_back(joint);
        }
    }

    void write(const Pose& pose, double* row) {
        jointFrames(rig_, pose, world_);
        for (std::size_t i = 0; i < skeleton_.joints.size(); ++i)
            place(i, row);
    }

private:
    void place(std::size_t index, double* row) {
        const Joint& joint = skeleton_.joints[index];
        const bool isRoot = joint.parent < 0;
        const Matrix3d parentTurn = isRoot ? Matrix3d::Identity() : turns_[at(joint.parent)];
        const Vector3d parentPosition = isRoot ? Vector3d::Zero() : positions_[at(joint.parent)];

        const bool rests =
            std::find(isAbove_.begin(), isAbove_.end(), static_cast<int>(index)) != isAbove_.end();
        const Vector3d wanted = unitsPerMetre_ * (toFile_ * world_.positions[index]);
        const Vector3d local =
            rests ? joint.offset : Vector3d(parentTurn.transpose() * (wanted - parentPosition));
        // Of the rotation what the parents did not show is made up for here.
        const Matrix3d worldTurn =
            toFile_ * world_.turns[index].toRotationMatrix() * toFile_.transpose();
        const Matrix3d turn = joint.rotationFrame.transpose() * parentTurn.transpose() * worldTurn *
                              joint.rotationFrame;
        before_[index] = anglesOf(turn, axes_[index], before_[index]);

        double* values = row + joint.firstChannel;
        Vector3d offset = joint.offset;
        Matrix3d shown = Matrix3d::Identity();
        std::size_t rotation = 0;
        for (std::size_t c = 0; c < joint.channels.size(); ++c) {
            const int axis = axisOf(joint.channels[c]);
            if (isRotation(joint.channels[c])) {
                values[c] = before_[index][rotation++];
                shown = shown * axisRotation(axis, values[c]);
            } else {
                values[c] = local[axis];
                offset[axis] = local[axis];
            }
        }
        positions_[index] = parentPosition + parentTurn * offset;
        turns_[index] = parentTurn * joint.rotationFrame * shown * joint.rotationFrame.transpose();
    }

    const Rig& rig_;
    const Skeleton& skeleton_;
    Matrix3d toFile_;
    double unitsPerMetre_;
    std::vector<std::array<double, 3>> before_;
    std::vector<Matrix3d> turns_;      ///< in the file's axes, as the channels show them
    std::vector<Vector3d> positions_;  ///< file units, as the channels show them
    std::vector<std::vector<int>> axes_;
    std::vector<int> isAbove_;  ///< joints above the traveller
    JointFrames world_;
};

}  // namespace

Clip clipOf(const Motion& motion, FrameRange frames, const SpaceConvention& space,
            const RoleMap& roles, std::optional<double> rate, const Progress& progress) {
    return clipOf(motion, frames, space,
                  std::make_shared<const Rig>(rigOf(motion, frames, space, roles)), rate, progress);
}

Clip clipOf(const Motion& motion, FrameRange frames, const SpaceConvention& space,
            std::shared_ptr<const Rig> rig, std::optional<double> rate, const Progress& progress) {
    const Skeleton& skeleton = *motion.skeleton;
    if (rig->joints.size() != skeleton.joints.size())
        throw Error("A clip's rig does not have the joints of its motion.");
    Clip clip;
    clip.rate = rate.value_or(rateOf(motion.frameTime));
    clip.frames.resize(at(frames.size()));
    const std::vector<int> chain = chainToTraveller(*rig);
    const Quaterniond axes(axesOf(space));
    std::atomic<int> done{0};
    forBlocks(frames, kBlock, [&](FrameRange block) {
        for (int frame = block.begin; frame < block.end; ++frame) {
            const auto row = motion.frame(frame);
            Pose& pose = clip.frames[at(frame - frames.begin)];
            pose.root = space.toWorld(travellerPosition(skeleton, row, chain));
            pose.turns.reserve(skeleton.joints.size());
            for (const Joint& joint : skeleton.joints) {
                pose.turns.push_back(joint.channels.empty()
                                         ? Quaterniond::Identity()
                                         : axes * Quaterniond(localRotation(joint, row)) *
                                               axes.conjugate());
            }
        }
        done += block.size();
        progress.update(static_cast<double>(done) / frames.size());
    });
    for (std::size_t i = 1; i < clip.frames.size(); ++i) {
        for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
            Quaterniond& turn = clip.frames[i].turns[j];
            if (turn.dot(clip.frames[i - 1].turns[j]) < 0) turn.coeffs() = -turn.coeffs();
        }
    }
    clip.rig = std::move(rig);
    return clip;
}

Motion motionOf(const Clip& clip, std::shared_ptr<const Skeleton> like,
                const SpaceConvention& space, const Progress& progress) {
    const Rig& rig = *clip.rig;
    bool same = rig.joints.size() == like->joints.size();
    for (std::size_t i = 0; same && i < rig.joints.size(); ++i)
        same = rig.joints[i].parent == like->joints[i].parent;
    if (!same) {
        throw Error(fmt::format(
            "A clip of {} joints cannot be written with the {} joints of another skeleton: "
            "retarget it first.",
            rig.joints.size(), like->joints.size()));
    }
    Motion motion;
    motion.frameTime = 1.0 / clip.rate;
    motion.frameCount = clip.frameCount();
    const auto width = at(like->channelCount);
    motion.channels.resize(width * clip.frames.size());
    ChannelWriter writer(rig, *like, space);
    for (std::size_t i = 0; i < clip.frames.size(); ++i) {
        writer.write(clip.frames[i], motion.channels.data() + i * width);
        if (i % kBlock == 0)
            progress.update(static_cast<double>(i) / static_cast<double>(clip.frames.size()));
    }
    motion.skeleton = std::move(like);
    return motion;
}

void jointFrames(const Rig& rig, const Pose& pose, JointFrames& out) {
    const std::size_t joints = rig.joints.size();
    out.positions.resize(joints);
    out.turns.resize(joints);
    out.positions[0] = pose.root;
    out.turns[0] = pose.turns[0];
    for (std::size_t i = 1; i < joints; ++i) {
        const Rig::Joint& joint = rig.joints[i];
        const Quaterniond& parent = out.turns[at(joint.parent)];
        out.positions[i] = out.positions[at(joint.parent)] + parent * joint.offset;
        out.turns[i] = parent * pose.turns[i];
    }
}

JointPositions positionsOf(const Clip& clip) {
    JointPositions result;
    const std::size_t joints = clip.rig->joints.size();
    result.frameCount = clip.frameCount();
    result.jointCount = static_cast<int>(joints);
    result.xyz.resize(3 * joints * clip.frames.size());
    forBlocks({0, clip.frameCount()}, kBlock, [&](FrameRange block) {
        JointFrames world;
        for (int frame = block.begin; frame < block.end; ++frame) {
            jointFrames(*clip.rig, clip.frames[at(frame)], world);
            float* out = result.xyz.data() + 3 * joints * at(frame);
            for (const Vector3d& position : world.positions) {
                for (int axis = 0; axis < 3; ++axis)
                    *out++ = static_cast<float>(position[axis]);
            }
        }
    });
    return result;
}

std::optional<double> headingOf(const Rig& rig, const Pose& pose) {
    constexpr double kVertical = 0.2;  // as in heading.h
    Vector3d facing = rig.forward;
    for (int joint = rig.roles[Role::Pelvis].value_or(0); joint >= 0;
         joint = rig.joint(joint).parent)
        facing = pose.turns[at(joint)] * facing;
    if (std::hypot(facing.x(), facing.z()) < kVertical) return std::nullopt;
    return std::atan2(facing.x(), facing.z());
}

}  // namespace kumite
