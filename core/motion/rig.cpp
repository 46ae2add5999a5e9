#include "core/motion/rig.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/motion/heading.h"

namespace kumite {
namespace {

using Eigen::Vector3d;

/// How a joint's position channels behave over some frames, file units.
struct JointWay {
    bool hasChannels = false;
    Vector3d mean = Vector3d::Zero();  ///< of the offset with the channels in it
    double strays = 0;                 ///< largest distance from the mean
};

Vector3d offsetAt(const Joint& joint, std::span<const double> row) {
    Vector3d offset = joint.offset;
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        if (isRotation(joint.channels[c])) continue;
        offset[axisOf(joint.channels[c])] = row[static_cast<std::size_t>(joint.firstChannel) + c];
    }
    return offset;
}

JointWay wayOf(const Motion& motion, FrameRange frames, const Joint& joint) {
    JointWay way;
    way.mean = joint.offset;
    way.hasChannels = std::any_of(joint.channels.begin(), joint.channels.end(),
                                  [](Channel channel) { return !isRotation(channel); });
    if (!way.hasChannels || frames.empty()) return way;
    // Deviations from the first frame are summed, so that what is constant stays exactly so.
    const Vector3d first = offsetAt(joint, motion.frame(frames.begin));
    Vector3d sum = Vector3d::Zero();
    for (int frame = frames.begin; frame < frames.end; ++frame)
        sum += offsetAt(joint, motion.frame(frame)) - first;
    way.mean = first + sum / frames.size();
    for (int frame = frames.begin; frame < frames.end; ++frame) {
        way.strays = std::max(way.strays, (offsetAt(joint, motion.frame(frame)) - way.mean).norm());
    }
    return way;
}

constexpr double kVaries = 1e-5;  // metres: less is rounding of the file's numbers

/// The lowest joint, from the root down to the pelvis, whose position varies; 0 if none does.
int travellerOf(const Motion& motion, FrameRange frames, double metresPerUnit,
                const RoleMap& roles) {
    const auto& joints = motion.skeleton->joints;
    for (int joint = roles[Role::Pelvis].value_or(0); joint > 0;
         joint = joints[static_cast<std::size_t>(joint)].parent) {
        const JointWay way = wayOf(motion, frames, joints[static_cast<std::size_t>(joint)]);
        if (way.strays * metresPerUnit > kVaries) return joint;
    }
    return 0;
}

bool isAtOrAbove(const std::vector<Joint>& joints, int joint, int below) {
    while (below > joint)
        below = joints[static_cast<std::size_t>(below)].parent;
    return below == joint;
}

}  // namespace

Rig rigOf(const Motion& motion, FrameRange frames, const SpaceConvention& space,
          const RoleMap& roles) {
    const auto& joints = motion.skeleton->joints;
    Rig rig;
    rig.roles = roles;
    rig.traveller = travellerOf(motion, frames, space.metresPerUnit, roles);
    rig.joints.reserve(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Joint& joint = joints[i];
        Vector3d offset = Vector3d::Zero();
        if (!isAtOrAbove(joints, static_cast<int>(i), rig.traveller)) {
            offset = space.toWorld(wayOf(motion, frames, joint).mean);
        }
        rig.joints.push_back({joint.name, joint.parent, offset, joint.isEndSite});
    }
    rig.forward = restForward(restPositions(rig), roles);
    return rig;
}

Findings rigLosses(const Motion& motion, FrameRange frames, const SpaceConvention& space,
                   const RoleMap& roles) {
    const auto& joints = motion.skeleton->joints;
    const int traveller = travellerOf(motion, frames, space.metresPerUnit, roles);
    Findings findings;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (static_cast<int>(i) == traveller) continue;
        const double strays = space.metresPerUnit * wayOf(motion, frames, joints[i]).strays;
        if (strays <= kVaries) continue;
        findings.push_back(
            isAtOrAbove(joints, static_cast<int>(i), traveller)
                ? note(fmt::format("{} moves by up to {} cm of its own, which is not kept: {} "
                                   "carries the body.",
                                   joints[i].name, fixed(100 * strays, 2),
                                   joints[static_cast<std::size_t>(traveller)].name))
                : warning(fmt::format("The bone to {} changes by up to {} cm; its mean is kept.",
                                      joints[i].name, fixed(100 * strays, 2))));
    }
    return findings;
}

std::shared_ptr<const Skeleton> skeletonOf(const Rig& rig) {
    auto skeleton = std::make_shared<Skeleton>();
    for (const Rig::Joint& from : rig.joints) {
        Joint joint;
        joint.name = from.name;
        joint.parent = from.parent;
        joint.offset = from.offset;
        joint.isEndSite = from.isEndSite;
        joint.firstChannel = skeleton->channelCount;
        if (joint.parent < 0) {
            joint.channels = {Channel::Xposition, Channel::Yposition, Channel::Zposition};
        }
        if (!joint.isEndSite) {
            for (const Channel channel :
                 {Channel::Zrotation, Channel::Xrotation, Channel::Yrotation})
                joint.channels.push_back(channel);
        }
        skeleton->channelCount += static_cast<int>(joint.channels.size());
        skeleton->joints.push_back(std::move(joint));
    }
    skeleton->validate();
    return skeleton;
}

std::optional<int> endSiteOf(const Rig& rig, int joint) {
    for (int i = joint + 1; i < rig.jointCount(); ++i) {
        if (rig.joint(i).parent == joint && rig.joint(i).isEndSite) return i;
    }
    return std::nullopt;
}

std::optional<int> footPoint(const Rig& rig, bool left) {
    const auto side = [left](Role role) { return left ? role : mirrored(role); };
    if (const auto toe = rig.roles[side(Role::LeftToe)]) return toe;
    const auto ankle = rig.roles[side(Role::LeftAnkle)];
    if (!ankle) return std::nullopt;
    const auto end = endSiteOf(rig, *ankle);
    return end ? end : ankle;
}

double legLength(const Rig& rig) {
    const std::vector<Vector3d> rest = restPositions(rig);
    const auto bone = [&](Role from, Role to) {
        return (rest[static_cast<std::size_t>(*rig.roles[from])] -
                rest[static_cast<std::size_t>(*rig.roles[to])])
            .norm();
    };
    double sum = 0;
    int legs = 0;
    for (const bool left : {true, false}) {
        const auto side = [left](Role role) { return left ? role : mirrored(role); };
        const Role hip = side(Role::LeftHip), knee = side(Role::LeftKnee),
                   ankle = side(Role::LeftAnkle);
        if (!rig.roles.has(hip) || !rig.roles.has(knee) || !rig.roles.has(ankle)) continue;
        sum += bone(hip, knee) + bone(knee, ankle);
        ++legs;
    }
    return legs > 0 ? sum / legs : 0;
}

std::vector<Vector3d> restPositions(const Rig& rig) {
    std::vector<Vector3d> positions(rig.joints.size(), Vector3d::Zero());
    for (std::size_t i = 1; i < rig.joints.size(); ++i) {
        positions[i] =
            positions[static_cast<std::size_t>(rig.joints[i].parent)] + rig.joints[i].offset;
    }
    return positions;
}

}  // namespace kumite
