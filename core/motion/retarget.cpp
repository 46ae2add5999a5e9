#include "core/motion/retarget.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/motion/feet.h"
#include "core/motion/two_bone.h"

namespace kumite {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// A rig at rest, as retargeting looks at it.
struct Resting {
    const Rig& rig;
    std::vector<Vector3d> positions;
    Vector3d left;     ///< sideways, unit
    Vector3d forward;  ///< unit, square to left
    Vector3d up;       ///< along the trunk, unit, square to both

    explicit Resting(const Rig& r) : rig(r), positions(restPositions(r)), forward(r.forward) {
        left = Vector3d::UnitY().cross(forward);
        if (const auto hips = between(Role::RightHip, Role::LeftHip)) left = *hips;
        left = (left - left.dot(forward) * forward).normalized();
        up = forward.cross(left);
    }

    /// Unit direction from one role's joint to another's; nothing where they are one or missing.
    std::optional<Vector3d> between(Role from, Role to) const {
        if (!rig.roles.has(from) || !rig.roles.has(to)) return std::nullopt;
        const Vector3d way = positions[at(*rig.roles[to])] - positions[at(*rig.roles[from])];
        if (way.norm() < 1e-6) return std::nullopt;
        return way.normalized();
    }

    Matrix3d body() const {
        Matrix3d axes;
        axes << left, up, forward;
        return axes;
    }

    /// The rig rests standing: its legs point down.
    bool stands() const {
        for (const auto& [hip, ankle] : {std::pair{Role::LeftHip, Role::LeftAnkle},
                                         std::pair{Role::RightHip, Role::RightAnkle}}) {
            const auto leg = between(hip, ankle);
            if (!leg || leg->dot(up) > -0.9 || up.y() < 0.9) return false;
        }
        return true;
    }
};

/// The bone that tells how a limb's joint rests: the next joint of the limb.
std::optional<Role> nextInLimb(Role role) {
    using enum Role;
    switch (role) {
        case LeftShoulder:
            return LeftElbow;
        case LeftElbow:
            return LeftWrist;
        case RightShoulder:
            return RightElbow;
        case RightElbow:
            return RightWrist;
        case LeftHip:
            return LeftKnee;
        case LeftKnee:
            return LeftAnkle;
        case LeftAnkle:
            return LeftToe;
        case RightHip:
            return RightKnee;
        case RightKnee:
            return RightAnkle;
        case RightAnkle:
            return RightToe;
        default:
            return std::nullopt;
    }
}

/// The role whose bone aligns a joint: the hand rests as the forearm does, the toes as the foot.
Role alignedBy(Role role) {
    using enum Role;
    switch (role) {
        case LeftWrist:
            return LeftElbow;
        case RightWrist:
            return RightElbow;
        case LeftToe:
            return LeftAnkle;
        case RightToe:
            return RightAnkle;
        default:
            return role;
    }
}

bool isArm(Role role) {
    using enum Role;
    return role == LeftShoulder || role == LeftElbow || role == RightShoulder || role == RightElbow;
}

bool isFoot(Role role) {
    return role == Role::LeftAnkle || role == Role::RightAnkle;
}

/// Axes of a bone: along it, and sideways (legs, feet) or forward (arms) as far as square to it,
/// which bending at hips, knees and ankles or lifting the arms sideways leaves alone.
Matrix3d axesOf(const Vector3d& bone, bool arm, const Resting& resting) {
    Vector3d second = arm ? resting.forward : resting.left;
    if (std::abs(second.dot(bone)) > 0.95) second = arm ? resting.up : resting.forward;
    return turnWithX(bone, second);
}

/// The turn that takes the target's resting part of the body to how the source's rests.
Quaterniond alignment(Role role, const Resting& source, const Resting& target) {
    const Quaterniond whole(Matrix3d(source.body() * target.body().transpose()));
    const Role bone = alignedBy(role);
    const auto next = nextInLimb(bone);
    if (!next || (isFoot(bone) && source.stands() && target.stands())) return whole;
    const auto from = source.between(bone, *next);
    const auto to = target.between(bone, *next);
    if (!from || !to) return whole;
    return Quaterniond(Matrix3d(axesOf(*from, isArm(bone), source) *
                                axesOf(*to, isArm(bone), target).transpose()))
        .normalized();
}

double boneLength(const Resting& resting, std::initializer_list<Role> roles) {
    double length = 0;
    for (auto role = roles.begin(); role + 1 != roles.end(); ++role) {
        if (!resting.rig.roles.has(role[0]) || !resting.rig.roles.has(role[1])) return 0;
        length += (resting.positions[at(*resting.rig.roles[role[1]])] -
                   resting.positions[at(*resting.rig.roles[role[0]])])
                      .norm();
    }
    return length;
}

std::string namesOf(const std::vector<Role>& roles) {
    std::string text;
    for (const Role role : roles)
        text += (text.empty() ? "" : ", ") + std::string(roleName(role));
    return text;
}

Findings lossesOf(const Resting& source, const Resting& target, double scale) {
    Findings losses;
    std::vector<Role> onlySource, onlyTarget;
    for (const Role role : allRoles()) {
        const bool has = source.rig.roles.has(role), gets = target.rig.roles.has(role);
        if (has && !gets) onlySource.push_back(role);
        if (!has && gets) onlyTarget.push_back(role);
    }
    if (!onlySource.empty()) {
        losses.push_back(warning("The target has no " + namesOf(onlySource) +
                                 ": their turns go to the joints below them."));
    }
    if (!onlyTarget.empty()) {
        losses.push_back(note("The source has no " + namesOf(onlyTarget) +
                              ": they keep their rest relative to their parent."));
    }
    if (std::abs(scale - 1) > 0.005) {
        losses.push_back(
            note(fmt::format("Ways are scaled by {} for the legs' lengths.", fixed(scale, 3))));
    }
    using enum Role;
    const double arms = boneLength(source, {LeftShoulder, LeftElbow, LeftWrist});
    const double reach = boneLength(target, {LeftShoulder, LeftElbow, LeftWrist});
    if (arms > 0 && reach > 0 && std::abs(reach / (arms * scale) - 1) > 0.03) {
        losses.push_back(
            note(fmt::format("Relative to the legs the target's arms are {} % {}: hands "
                             "do not reach the same places.",
                             fixed(100 * std::abs(reach / (arms * scale) - 1), 0),
                             reach > arms * scale ? "longer" : "shorter")));
    }
    return losses;
}

/// Joints whose middle is carried along: both hips, or the pelvis, or joint 0.
std::vector<int> carried(const Rig& rig, bool byHips) {
    if (byHips) return {*rig.roles[Role::LeftHip], *rig.roles[Role::RightHip]};
    return {rig.roles[Role::Pelvis].value_or(0)};
}

Vector3d middleOf(const std::vector<int>& joints, const JointFrames& frames) {
    Vector3d sum = Vector3d::Zero();
    for (const int joint : joints)
        sum += frames.positions[at(joint)];
    return sum / static_cast<double>(joints.size());
}

bool haveHips(const Rig& rig) {
    return rig.roles.has(Role::LeftHip) && rig.roles.has(Role::RightHip);
}

std::optional<double> floorOf(const Clip& clip) {
    const JointPositions positions = positionsOf(clip);
    std::optional<double> floor;
    for (const bool left : {true, false}) {
        const auto point = footPoint(*clip.rig, left);
        if (!point) continue;
        const double height = restHeight(positions, *point);
        floor = floor ? std::min(*floor, height) : height;
    }
    return floor;
}

}  // namespace

Retargeting::Retargeting(std::shared_ptr<const Rig> sourceRig, std::shared_ptr<const Rig> targetRig)
    : source_(std::move(sourceRig)),
      target_(std::move(targetRig)),
      links_(target_->joints.size()),
      resting_(target_->joints.size(), Quaterniond::Identity()) {
    const Resting source(*source_), target(*target_);
    const double ofSource = legLength(*source_), ofTarget = legLength(*target_);
    if (ofSource > 0 && ofTarget > 0) scale_ = ofTarget / ofSource;
    losses_ = lossesOf(source, target, scale_);

    // The common rest pose in space, joint by joint; what has no role rests as its parent.
    // Of the roles that a joint has, the last counts (the chest carries the shoulders), but the
    // pelvis carries the legs.
    std::vector<std::optional<Role>> roleOf(links_.size());
    for (const Role role : allRoles()) {
        const auto joint = target_->roles[role];
        if (joint && source_->roles.has(role) && roleOf[at(*joint)] != Role::Pelvis)
            roleOf[at(*joint)] = role;
    }
    const Quaterniond whole(Matrix3d(source.body() * target.body().transpose()));
    std::vector<Quaterniond> common(links_.size(), whole);
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const Rig::Joint& joint = target_->joints[i];
        if (joint.parent >= 0) common[i] = common[at(joint.parent)];
        if (roleOf[i]) {
            links_[i].source = *source_->roles[*roleOf[i]];
            common[i] = alignment(*roleOf[i], source, target);
        } else if (!joint.isEndSite) {
            for (int other = 0; other < source_->jointCount(); ++other) {
                const Rig::Joint& candidate = source_->joint(other);
                if (candidate.name == joint.name && !candidate.isEndSite) links_[i].source = other;
            }
        }
        links_[i].rest = common[i];
        if (joint.parent >= 0) resting_[i] = common[at(joint.parent)].conjugate() * common[i];
    }
}

Pose Retargeting::apply(const Pose& pose, const Vector3d& origin) const {
    JointFrames from, to;
    jointFrames(*source_, pose, from);
    Pose result;
    result.turns = resting_;
    std::vector<Quaterniond> world(links_.size());
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const int parent = target_->joints[i].parent;
        const Quaterniond above = parent >= 0 ? world[at(parent)] : Quaterniond::Identity();
        if (links_[i].source >= 0) {
            world[i] = from.turns[at(links_[i].source)] * links_[i].rest;
            result.turns[i] = (above.conjugate() * world[i]).normalized();
        } else {
            world[i] = above * resting_[i];
        }
    }
    const bool byHips = haveHips(*source_) && haveHips(*target_);
    const Vector3d wanted = origin + scale_ * (middleOf(carried(*source_, byHips), from) - origin);
    jointFrames(*target_, result, to);
    result.root = wanted - middleOf(carried(*target_, byHips), to);
    return result;
}

Clip retargeted(const Clip& clip, std::shared_ptr<const Rig> target, Findings* losses) {
    const Retargeting retargeting(clip.rig, target);
    if (losses) *losses = retargeting.losses();
    Clip result{std::move(target), clip.rate, {}};
    if (clip.frames.empty()) return result;
    const auto floor = floorOf(clip);
    Vector3d origin = clip.frames.front().root;
    origin.y() = floor.value_or(0);
    result.frames.reserve(clip.frames.size());
    for (const Pose& pose : clip.frames)
        result.frames.push_back(retargeting.apply(pose, origin));
    const auto reached = floorOf(result);
    if (floor && reached) {
        for (Pose& pose : result.frames)
            pose.root.y() += *floor - *reached;
    }
    return result;
}

}  // namespace kumite
