#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/editing/body_parts.h"
#include "core/motion/kinematics.h"

namespace kumite {

/// Boolean features of a pose (paper C, Table 1, after Müller 2005; extended as method C2 says):
/// relations of joints that do not change with place, heading or size. Left and right of a kind
/// stand beside each other, the right one first, as in the paper.
enum class PoseBit {
    RightFootInFront,  ///< its ankle is ahead of the other along the facing
    LeftFootInFront,   ///< level feet have neither bit
    RightElbowBent,    ///< angle at the elbow below `bent`
    LeftElbowBent,
    RightKneeBent,
    LeftKneeBent,
    RightHandAboveShoulder,
    LeftHandAboveShoulder,
    RightHandInFront,  ///< of the chest: ahead of it and above the middle of the trunk
    LeftHandInFront,
    RightFootRaised,  ///< its ankle above the other
    LeftFootRaised,
    TurnedRight,  ///< the line of the shoulders against that of the hips
    TurnedLeft,
    LeansRight,
    LeansLeft,
    LeansForward,
    Crouched  ///< the pelvis low over the lower ankle
};

inline constexpr int kPoseBitCount = 18;

/// A pose's features, bit k for PoseBit k: a whole library takes four bytes a frame.
using PoseBits = std::uint32_t;
inline constexpr PoseBits kAllPoseBits = (PoseBits(1) << kPoseBitCount) - 1;

constexpr PoseBits maskOf(PoseBit bit) {
    return PoseBits(1) << static_cast<int>(bit);
}
/// The features that speak of one part.
PoseBits maskOf(BodyPart part);
/// "right_foot_in_front".
std::string_view bitName(PoseBit bit);
/// The features of the same pose seen in a mirror.
PoseBits mirrored(PoseBits bits);

struct PoseFeatureSettings {
    double bent = 120;     ///< degrees; an elbow or knee below it is bent
    double raised = 0.15;  ///< metres between the ankles
    double ahead = 0.35;   ///< of the arm's length: how far a hand is in front of the chest
    double turned = 15;    ///< degrees between shoulders and hips
    double lean = 0.2;     ///< horizontal share of pelvis → neck
    double crouch = 0.75;  ///< pelvis' height over the lower ankle in leg lengths

    bool operator==(const PoseFeatureSettings&) const = default;
};

/// Places of a pose's joints by role, metres, y up.
struct RolePoints {
    std::array<Eigen::Vector3f, kRoleCount> at{};
    std::array<bool, kRoleCount> known{};

    void set(Role role, const Eigen::Vector3f& point) {
        at[static_cast<std::size_t>(role)] = point;
        known[static_cast<std::size_t>(role)] = true;
    }
    const Eigen::Vector3f& operator[](Role role) const {
        return at[static_cast<std::size_t>(role)];
    }
    bool has(Role role) const { return known[static_cast<std::size_t>(role)]; }
};

/// Where a pose faces: horizontal unit vector (left hip − right hip) × y; +z where the hips do not
/// tell.
Eigen::Vector3f facingOf(const RolePoints& points);
/// How far the right ankle is ahead of the left along the facing, metres.
float rightFootLead(const RolePoints& points);
/// Angle at `middle` between the directions to both ends, radians: π is stretched.
float jointAngle(const Eigen::Vector3f& end, const Eigen::Vector3f& middle,
                 const Eigen::Vector3f& otherEnd);

/// The features of one pose. A feature whose roles are missing is 0.
PoseBits poseBits(const RolePoints& points, const PoseFeatureSettings& settings = {});
/// The features of every frame, on all cores. Cancellable.
std::vector<PoseBits> poseBits(const JointPositions& positions, const RoleMap& roles,
                               const PoseFeatureSettings& settings = {},
                               const Progress& progress = {});

}  // namespace kumite
