#include "core/editing/pose_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/editing/joint_turns.h"
#include "core/motion/euler.h"
#include "core/motion/two_bone.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::array<Handle, kHandleCount> kHandles = {
    Handle::LeftHand, Handle::RightHand, Handle::LeftFoot, Handle::RightFoot,
    Handle::Hips,     Handle::Chest,     Handle::Head};
constexpr std::array<std::string_view, kHandleCount> kNames = {
    "left_hand", "right_hand", "left_foot", "right_foot", "hips", "chest", "head"};

std::optional<Role> limbEnd(Handle handle) {
    switch (handle) {
        case Handle::LeftHand:
            return Role::LeftWrist;
        case Handle::RightHand:
            return Role::RightWrist;
        case Handle::LeftFoot:
            return Role::LeftAnkle;
        case Handle::RightFoot:
            return Role::RightAnkle;
        default:
            return std::nullopt;
    }
}

bool isFoot(Handle handle) {
    return handle == Handle::LeftFoot || handle == Handle::RightFoot;
}

/// The first child of a joint that the bone leads to: its direction at rest, unit.
std::optional<Vector3d> boneDirection(const Rig& rig, int joint) {
    for (const Rig::Joint& other : rig.joints) {
        if (other.parent == joint && other.offset.norm() > 1e-6) return other.offset.normalized();
    }
    return std::nullopt;
}

/// turn = swing · twist, twist about the bone.
std::pair<Quaterniond, Quaterniond> swingAndTwist(const Quaterniond& turn, const Vector3d& bone) {
    Quaterniond twist(turn.w(), 0, 0, 0);
    twist.vec() = turn.vec().dot(bone) * bone;
    twist = twist.norm() > 1e-9 ? twist.normalized() : Quaterniond::Identity();
    return {turn * twist.conjugate(), twist};
}

/// The pelvis' descendants up to (without) a joint: what bends to bring it somewhere.
std::vector<int> chainBelow(const Rig& rig, int joint, std::optional<int> from) {
    std::vector<int> chain;
    const int pelvis = rig.roles[Role::Pelvis].value_or(0);
    for (int j = rig.joint(joint).parent; j >= 0 && j != pelvis; j = rig.joint(j).parent) {
        chain.push_back(j);
        if (j == from) break;
    }
    return chain;
}

/// A pose being dragged.
class Drag {
public:
    Drag(const Rig& rig, const Pose& pose, const Pins& pins) : rig_(rig), pose_(pose), pins_(pins) {
        update();
        start_ = frames_;
    }
    const Pose& pose() const { return pose_; }
    Vector3d at(int joint) const { return frames_.positions[static_cast<std::size_t>(joint)]; }

    void limb(Handle handle, const Vector3d& place) {
        const auto limb = limbOf(rig_, *limbEnd(handle));
        if (!limb) return;
        reach(rig_, pose_, frames_, *limb, place,
              isFoot(handle) ? EndTurn::KeepsWorld : EndTurn::KeepsLocal);
        update();
    }
    void shift(const Vector3d& way) {
        pose_.root += way;
        update();
    }
    void set(int joint, const Quaterniond& turn) {
        pose_.turns[static_cast<std::size_t>(joint)] = withinLimit(rig_, joint, turn);
        update();
    }
    /// Bends a chain of joints, the outermost first, until `joint` is at the place (cyclic
    /// coordinate descent); every joint gives a share, so that no one takes it all.
    void bendToward(const std::vector<int>& chain, int joint, const Vector3d& place) {
        constexpr int kRounds = 30;
        constexpr double kMost = 0.15, kMet = 1e-4;  // radians a round, metres
        for (int round = 0; round < kRounds; ++round) {
            for (const int j : chain) {
                const JointTurn turn = aimingTurn(j, at(j), at(joint), place, kMost);
                if (turn.angle == 0) continue;
                turnInSpace(rig_, pose_, frames_, j,
                            Quaterniond(Eigen::AngleAxisd(turn.angle, turn.axis)));
                set(j, pose_.turns[static_cast<std::size_t>(j)]);
            }
            if ((at(joint) - place).norm() < kMet) return;
        }
    }
    /// Puts pinned hands and feet back, feet turned as they were.
    void restore(Handle dragged) {
        for (const Handle handle : kHandles) {
            if (!pins_[handle] || handle == dragged || !limbEnd(handle)) continue;
            const auto joint = handleJoint(rig_, handle);
            if (!joint) continue;
            const auto j = static_cast<std::size_t>(*joint);
            limb(handle, start_.positions[j]);
            if (!isFoot(handle)) continue;
            setTurnInSpace(rig_, pose_, frames_, *joint, start_.turns[j]);
            update();
        }
    }
    double slipped(std::optional<Handle> dragged) const {
        double most = 0;
        for (const Handle handle : kHandles) {
            const auto joint = handleJoint(rig_, handle);
            if (!pins_[handle] || handle == dragged || !joint) continue;
            const auto j = static_cast<std::size_t>(*joint);
            most = std::max(most, (frames_.positions[j] - start_.positions[j]).norm());
        }
        return most;
    }

private:
    void update() { jointFrames(rig_, pose_, frames_); }

    const Rig& rig_;
    Pose pose_;
    Pins pins_;
    JointFrames start_, frames_;
};

/// Degrees of swing and twist per role; left and right are alike.
std::optional<std::pair<double, double>> degreesOf(Role role) {
    switch (role) {
        case Role::Spine:
            return {{40, 40}};
        case Role::Chest:
            return {{55, 55}};
        case Role::Neck:
            return {{55, 70}};
        case Role::Head:
            return {{50, 60}};
        case Role::LeftClavicle:
        case Role::RightClavicle:
            return {{35, 30}};
        case Role::LeftShoulder:
        case Role::RightShoulder:
            return {{165, 120}};
        case Role::LeftElbow:
        case Role::RightElbow:
            return {{155, 110}};
        case Role::LeftWrist:
        case Role::RightWrist:
            return {{85, 90}};
        case Role::LeftHip:
        case Role::RightHip:
            return {{150, 80}};
        case Role::LeftKnee:
        case Role::RightKnee:
            return {{160, 45}};
        case Role::LeftAnkle:
        case Role::RightAnkle:
            return {{75, 55}};
        case Role::LeftToe:
        case Role::RightToe:
            return {{70, 30}};
        case Role::Pelvis:
            break;
    }
    return std::nullopt;
}

}  // namespace

const std::array<Handle, kHandleCount>& allHandles() {
    return kHandles;
}

std::string_view handleName(Handle handle) {
    return kNames[static_cast<std::size_t>(handle)];
}

std::optional<Handle> handleFromName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return kHandles[static_cast<std::size_t>(found - kNames.begin())];
}

std::optional<int> handleJoint(const Rig& rig, Handle handle) {
    switch (handle) {
        case Handle::Hips:
            return rig.roles[Role::Pelvis];
        case Handle::Chest:
            return rig.roles[Role::Neck];
        case Handle::Head: {
            const auto head = rig.roles[Role::Head];
            if (!head) return head;
            return endSiteOf(rig, *head).value_or(*head);
        }
        default:
            return rig.roles[*limbEnd(handle)];
    }
}

std::optional<Vector3d> handlePoint(const Rig& rig, const Pose& pose, Handle handle) {
    const auto joint = handleJoint(rig, handle);
    if (!joint) return std::nullopt;
    JointFrames frames;
    jointFrames(rig, pose, frames);
    return frames.positions[static_cast<std::size_t>(*joint)];
}

DragResult dragged(const Rig& rig, const Pose& pose, Handle handle, const Vector3d& place,
                   const Pins& pins) {
    const auto joint = handleJoint(rig, handle);
    if (!joint || !place.allFinite()) return {pose, 0, 0};
    Drag drag(rig, pose, pins);
    const bool isHand = handle == Handle::LeftHand || handle == Handle::RightHand;
    constexpr double kMet = 1e-3;
    switch (handle) {
        case Handle::Hips:
            drag.shift(place - drag.at(*joint));
            break;
        case Handle::Chest:
            drag.bendToward(chainBelow(rig, *joint, {}), *joint, place);
            break;
        case Handle::Head:
            drag.bendToward(chainBelow(rig, *joint, rig.roles[Role::Neck]), *joint, place);
            break;
        default:
            drag.limb(handle, place);
    }
    if (isHand && !pins[Handle::Chest] && (drag.at(*joint) - place).norm() > kMet) {
        // The trunk leans and the limb follows.
        const auto shoulder =
            rig.roles[handle == Handle::LeftHand ? Role::LeftShoulder : Role::RightShoulder];
        const auto chest = rig.roles[Role::Chest];
        if (shoulder && chest) {
            std::vector<int> chain = chainBelow(rig, *chest, {});
            chain.insert(chain.begin(), *chest);
            drag.bendToward(chain, *shoulder, drag.at(*shoulder) + place - drag.at(*joint));
            drag.limb(handle, place);
        }
    }
    drag.restore(handle);
    return {drag.pose(), (drag.at(*joint) - place).norm(), drag.slipped(handle)};
}

std::optional<JointLimit> jointLimit(const Rig& rig, int joint) {
    for (const Role role : allRoles()) {
        if (rig.roles[role] != joint) continue;
        const auto degrees = degreesOf(role);
        if (!degrees) return std::nullopt;
        constexpr double kRadians = std::numbers::pi / 180;
        return JointLimit{kRadians * degrees->first, kRadians * degrees->second};
    }
    return std::nullopt;
}

Quaterniond withinLimit(const Rig& rig, int joint, const Quaterniond& turn) {
    const auto limit = jointLimit(rig, joint);
    const auto bone = boneDirection(rig, joint);
    if (!limit || !bone) return turn;
    const auto [swing, twist] = swingAndTwist(turn, *bone);
    const auto limited = [](const Quaterniond& q, double most) {
        Eigen::AngleAxisd a(q.w() < 0 ? Quaterniond(-q.coeffs()) : q);
        a.angle() = std::min(a.angle(), most);
        return Quaterniond(a);
    };
    return (limited(swing, limit->swing) * limited(twist, limit->twist)).normalized();
}

std::optional<JointLimit> jointBend(const Rig& rig, int joint, const Quaterniond& turn) {
    const auto bone = boneDirection(rig, joint);
    if (!jointLimit(rig, joint) || !bone) return std::nullopt;
    const auto [swing, twist] = swingAndTwist(turn, *bone);
    const Quaterniond rest = Quaterniond::Identity();
    return JointLimit{swing.angularDistance(rest), twist.angularDistance(rest)};
}

Vector3d jointAngles(const Quaterniond& turn, const Vector3d& before) {
    const auto angles =
        eulerAngles(turn.toRotationMatrix(), {2, 0, 1}, {before.z(), before.x(), before.y()});
    return {angles[1], angles[2], angles[0]};
}

Quaterniond turnOfAngles(const Vector3d& degrees) {
    constexpr double kRadians = std::numbers::pi / 180;
    const auto about = [&](int axis) {
        return Quaterniond(Eigen::AngleAxisd(std::remainder(degrees[axis], 360.0) * kRadians,
                                             Vector3d::Unit(axis)));
    };
    return about(2) * about(0) * about(1);
}

Pose withinLimits(const Rig& rig, Pose pose) {
    for (int j = 0; j < rig.jointCount(); ++j) {
        Quaterniond& turn = pose.turns[static_cast<std::size_t>(j)];
        turn = withinLimit(rig, j, turn);
    }
    return pose;
}

DragResult withJointTurn(const Rig& rig, const Pose& pose, int joint, const Quaterniond& turn,
                         const Pins& pins) {
    const auto carries = [&](int ancestor, int of) {
        for (int j = of; j >= 0; j = rig.joint(j).parent) {
            if (j == ancestor) return true;
        }
        return false;
    };
    // What the turned joint carries goes with it; the other pinned handles stay. A turn of the
    // whole body carries nothing.
    Pins staying = pins;
    if (!carries(joint, rig.roles[Role::Pelvis].value_or(0))) {
        for (const Handle handle : kHandles) {
            if (limbEnd(handle) && carries(joint, handleJoint(rig, handle).value_or(-1)))
                staying[handle] = false;
        }
    }
    Drag drag(rig, pose, staying);
    drag.set(joint, turn.normalized());
    drag.restore(Handle::Hips);
    return {drag.pose(), 0, drag.slipped({})};
}

}  // namespace kumite
