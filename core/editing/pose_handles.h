#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/motion/pose.h"

namespace kumite {

/// What a pose is dragged by.
enum class Handle { LeftHand, RightHand, LeftFoot, RightFoot, Hips, Chest, Head };
inline constexpr int kHandleCount = 7;
const std::array<Handle, kHandleCount>& allHandles();
/// "left_hand".
std::string_view handleName(Handle handle);
std::optional<Handle> handleFromName(std::string_view name);

/// Where a handle is: wrist, ankle, pelvis, the chest's upper end (the neck), the head's top (its
/// End Site, else the head joint). Nothing where the rig has no such joint.
std::optional<int> handleJoint(const Rig& rig, Handle handle);
std::optional<Eigen::Vector3d> handlePoint(const Rig& rig, const Pose& pose, Handle handle);

/// Handles that stay where they are while another is dragged. Nailed feet are what a figure that
/// stands wants.
struct Pins {
    std::array<bool, kHandleCount> pinned{};
    bool& operator[](Handle handle) { return pinned[static_cast<std::size_t>(handle)]; }
    bool operator[](Handle handle) const { return pinned[static_cast<std::size_t>(handle)]; }
    bool operator==(const Pins&) const = default;
};
inline Pins feetPinned() {
    Pins pins;
    pins[Handle::LeftFoot] = pins[Handle::RightFoot] = true;
    return pins;
}

/// A pose with one handle drawn to a place (metres), as near as limbs and joint limits allow:
///   hands and feet by their limb, then, unless the chest is pinned, a hand by leaning the trunk;
///   the hips by moving the root; chest and head by bending the spine, the neck.
/// Pinned handles are put back by their limbs. Handles that the rig lacks change nothing.
struct DragResult {
    Pose pose;
    double missing = 0;  ///< metres from the dragged handle to the place
    double slipped = 0;  ///< farthest that a pinned handle is from where it was, metres
};
DragResult dragged(const Rig& rig, const Pose& pose, Handle handle, const Eigen::Vector3d& place,
                   const Pins& pins = feetPinned());

/// How far a joint may go from the rest pose: its bone's direction, and the turn about its bone.
struct JointLimit {
    double swing = 0;  ///< radians
    double twist = 0;
    bool operator==(const JointLimit&) const = default;
};
/// The limits of what has a role, wide enough for kicks and punches; nothing for the pelvis and for
/// joints without a role. They count from the rest pose of the skeleton, whatever that is.
std::optional<JointLimit> jointLimit(const Rig& rig, int joint);
/// A local rotation brought within the joint's limits.
Eigen::Quaterniond withinLimit(const Rig& rig, int joint, const Eigen::Quaterniond& turn);
/// The whole pose.
Pose withinLimits(const Rig& rig, Pose pose);

/// How far a local rotation is from the rest pose; nothing for joints without a limit.
std::optional<JointLimit> jointBend(const Rig& rig, int joint, const Eigen::Quaterniond& turn);

/// A local rotation as keys.json has it: degrees about x, y and z, R = Rz · Rx · Ry; of the two
/// ways to say it the one nearest to `before`.
Eigen::Vector3d jointAngles(const Eigen::Quaterniond& turn,
                            const Eigen::Vector3d& before = Eigen::Vector3d::Zero());
Eigen::Quaterniond turnOfAngles(const Eigen::Vector3d& degrees);

/// A pose with one joint turned by hand: its local rotation set, within its limit; pinned handles
/// put back.
DragResult withJointTurn(const Rig& rig, const Pose& pose, int joint,
                         const Eigen::Quaterniond& turn, const Pins& pins = feetPinned());

}  // namespace kumite
