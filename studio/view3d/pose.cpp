#include "studio/view3d/pose.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/feet.h"

namespace kumite::studio {

namespace {

double floorOf(const FighterAnalysis& fighter) {
    return fighter.body ? fighter.body->floor : 0.0;
}

int clampedFrame(const FighterAnalysis& fighter, int frame) {
    return std::clamp(frame, 0, std::max(0, fighter.frameCount() - 1));
}

/// The horizontal direction in which a body faces; +z where it has no shoulders or hips.
Eigen::Vector3d facing(const FighterAnalysis& fighter, int frame) {
    for (const auto& [left, right] : {std::pair(Role::LeftShoulder, Role::RightShoulder),
                                      std::pair(Role::LeftHip, Role::RightHip)}) {
        const auto l = fighter.input.roles[left];
        const auto r = fighter.input.roles[right];
        if (!l || !r) continue;
        Eigen::Vector3d across = jointAt(fighter, frame, *l) - jointAt(fighter, frame, *r);
        across.y() = 0;
        if (across.norm() > 1e-3) return across.normalized().cross(Eigen::Vector3d::UnitY());
    }
    return Eigen::Vector3d::UnitZ();
}

}  // namespace

Eigen::Vector3d jointAt(const FighterAnalysis& fighter, int frame, int joint) {
    return placed(fighter.input, floorOf(fighter),
                  fighter.motion->positions.at(frame, joint).cast<double>());
}

std::vector<Eigen::Vector3f> jointsAt(const FighterAnalysis& fighter, int frame) {
    std::vector<Eigen::Vector3f> joints;
    const JointPositions& positions = fighter.motion->positions;
    if (positions.frameCount == 0) return joints;
    joints.reserve(static_cast<std::size_t>(positions.jointCount));
    for (int joint = 0; joint < positions.jointCount; ++joint)
        joints.emplace_back(jointAt(fighter, frame, joint).cast<float>());
    return joints;
}

FigurePose poseAt(const FighterAnalysis& fighter, int frame, const Overlays& overlays) {
    FigurePose pose;
    pose.joints = jointsAt(fighter, frame);
    const auto index = static_cast<std::size_t>(frame);
    if (fighter.body && index < fighter.body->com.position.size()) {
        const Eigen::Vector3d& com = fighter.body->com.position[index];
        const double floor = floorOf(fighter);
        const Eigen::Vector3d at = placed(fighter.input, floor, com);
        pose.centreOfMass = at.cast<float>();
        if (fighter.force && index < fighter.force->force.force.size()) {
            const Eigen::Vector3d& force = fighter.force->force.force[index];
            pose.force = (placed(fighter.input, floor, com + force) - at).cast<float>();
        }
    }
    if (overlays.contacts && fighter.body) {
        const RoleMap& roles = fighter.input.roles;
        for (const bool left : {true, false}) {
            const auto& contacts =
                left ? fighter.body->contacts.left : fighter.body->contacts.right;
            const auto toe = footPoint(*fighter.input.motion->skeleton, roles, left);
            if (!toe || index >= contacts.size() || contacts[index] == 0) continue;
            const int heel = roles[left ? Role::LeftAnkle : Role::RightAnkle].value_or(*toe);
            pose.footContacts.push_back({pose.joints[static_cast<std::size_t>(heel)],
                                         pose.joints[static_cast<std::size_t>(*toe)]});
        }
    }
    if (overlays.trails) {
        pose.trails = trailsAt(fighter, frame, overlays.trailBefore, overlays.trailAfter);
    }
    return pose;
}

Eigen::Vector3d centreAt(const FighterAnalysis& fighter, int frame) {
    const auto index = static_cast<std::size_t>(frame);
    if (fighter.body && index < fighter.body->com.position.size()) {
        return placed(fighter.input, fighter.body->floor, fighter.body->com.position[index]);
    }
    return jointAt(fighter, frame, 0);
}

std::vector<Trail> trailsAt(const FighterAnalysis& fighter, int frame, int before, int after) {
    const RoleMap& roles = fighter.input.roles;
    const Skeleton& skeleton = *fighter.input.motion->skeleton;
    const int first = clampedFrame(fighter, frame - before);
    const int last = clampedFrame(fighter, frame + after);
    std::vector<Trail> trails;
    for (const auto& joint :
         {roles[Role::LeftWrist], roles[Role::RightWrist], footPoint(skeleton, roles, true),
          footPoint(skeleton, roles, false)}) {
        if (!joint) continue;
        Trail trail{{}, frame - first};
        for (int at = first; at <= last; ++at)
            trail.path.emplace_back(jointAt(fighter, at, *joint).cast<float>());
        trails.push_back(std::move(trail));
    }
    return trails;
}

void addPath(Box& box, const FighterAnalysis& fighter) {
    const JointPositions& positions = fighter.motion->positions;
    const int step = std::max(1, positions.frameCount / 500);
    for (int frame = 0; frame < positions.frameCount; frame += step) {
        for (int joint = 0; joint < positions.jointCount && !fighter.force; ++joint) {
            box.add(jointAt(fighter, frame, joint));
        }
        if (!fighter.force) continue;
        const Eigen::Vector3d root = jointAt(fighter, frame, 0);
        box.add({root.x() - 0.35, 0.0, root.z() - 0.35});
        box.add({root.x() + 0.35, 1.75, root.z() + 0.35});
    }
}

std::optional<Eigen::Vector3d> followedPoint(const Fighters& fighters, double seconds) {
    constexpr double kHalf = 0.5;  // seconds to either side
    constexpr int kSamples = 15;   // to either side
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0;
    for (const FighterAnalysis* fighter : fighters) {
        if (fighter == nullptr || fighter->frameCount() == 0) continue;
        for (int i = -kSamples; i <= kSamples; ++i) {
            const double share = static_cast<double>(i) / (kSamples + 1);
            const double weight = 1 + std::cos(std::numbers::pi * share);
            sum +=
                weight * centreAt(*fighter, frameAtTime(fighter->input, seconds + kHalf * share));
            weights += weight;
        }
    }
    if (weights == 0) return std::nullopt;
    return sum / weights;
}

std::optional<Viewpoint> overShoulder(const Fighters& fighters, int player, double seconds) {
    const FighterAnalysis* who = fighters[static_cast<std::size_t>(player)];
    const FighterAnalysis* other = fighters[static_cast<std::size_t>(1 - player)];
    if (who == nullptr || who->frameCount() == 0) return std::nullopt;
    const int frame = frameAtTime(who->input, seconds);
    const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    const auto joint = who->input.roles[Role::RightShoulder];
    const Eigen::Vector3d shoulder =
        joint ? jointAt(*who, frame, *joint) : Eigen::Vector3d(centreAt(*who, frame) + 0.4 * up);
    Eigen::Vector3d ahead = facing(*who, frame);
    Eigen::Vector3d target = shoulder + 2.0 * ahead;
    if (other != nullptr && other->frameCount() > 0) {
        target = centreAt(*other, frameAtTime(other->input, seconds)) + 0.2 * up;
        Eigen::Vector3d toward = target - centreAt(*who, frame);
        toward.y() = 0;
        if (toward.norm() > 0.05) ahead = toward.normalized();
    }
    const Eigen::Vector3d right = ahead.cross(up);
    return Viewpoint{shoulder - 1.5 * ahead + 0.35 * right + 0.45 * up, target};
}

}  // namespace kumite::studio
