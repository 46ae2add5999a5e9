#include "core/editing/pose_features.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/base/parallel.h"

namespace kumite {
namespace {

using Eigen::Vector3f;

constexpr std::array<std::string_view, kPoseBitCount> kNames = {"right_foot_in_front",
                                                                "left_foot_in_front",
                                                                "right_elbow_bent",
                                                                "left_elbow_bent",
                                                                "right_knee_bent",
                                                                "left_knee_bent",
                                                                "right_hand_above_shoulder",
                                                                "left_hand_above_shoulder",
                                                                "right_hand_in_front",
                                                                "left_hand_in_front",
                                                                "right_foot_raised",
                                                                "left_foot_raised",
                                                                "turned_right",
                                                                "turned_left",
                                                                "leans_right",
                                                                "leans_left",
                                                                "leans_forward",
                                                                "crouched"};

/// Bits that stand alone in the middle of the body; all others come in pairs (right, left).
constexpr PoseBits kMiddle = maskOf(PoseBit::LeansForward) | maskOf(PoseBit::Crouched);

constexpr float radians(double degrees) {
    return static_cast<float>(degrees * std::numbers::pi / 180);
}

/// One side's roles.
struct Side {
    Role shoulder, elbow, wrist, hip, knee, ankle;
};
constexpr Side kRight = {Role::RightShoulder, Role::RightElbow, Role::RightWrist,
                         Role::RightHip,      Role::RightKnee,  Role::RightAnkle};
constexpr Side kLeft = {Role::LeftShoulder, Role::LeftElbow, Role::LeftWrist,
                        Role::LeftHip,      Role::LeftKnee,  Role::LeftAnkle};

/// Thresholds in the form that the inner loop compares with, and the pose that it looks at.
struct Look {
    const RolePoints& p;
    const PoseFeatureSettings& settings;
    float bentCosine;
    Vector3f facing;
    PoseBits bits = 0;

    void set(PoseBit bit, bool value) { bits |= value ? maskOf(bit) : 0; }

    bool bent(Role end, Role middle, Role other) const {
        if (!p.has(end) || !p.has(middle) || !p.has(other)) return false;
        const Vector3f a = p[end] - p[middle], b = p[other] - p[middle];
        return a.dot(b) > bentCosine * a.norm() * b.norm();
    }

    void arm(const Side& side, PoseBit elbowBent, PoseBit above, PoseBit inFront) {
        set(elbowBent, bent(side.shoulder, side.elbow, side.wrist));
        if (!p.has(side.shoulder) || !p.has(side.wrist)) return;
        set(above, p[side.wrist].y() > p[side.shoulder].y());
        if (!p.has(side.elbow) || !p.has(Role::Chest) || !p.has(Role::Pelvis)) return;
        const float length =
            (p[side.shoulder] - p[side.elbow]).norm() + (p[side.elbow] - p[side.wrist]).norm();
        const float ahead = (p[side.wrist] - p[Role::Chest]).dot(facing);
        const float middle = 0.5f * (p[Role::Pelvis].y() + p[side.shoulder].y());
        set(inFront,
            ahead > static_cast<float>(settings.ahead) * length && p[side.wrist].y() > middle);
    }

    void legs() {
        set(PoseBit::RightKneeBent, bent(kRight.hip, kRight.knee, kRight.ankle));
        set(PoseBit::LeftKneeBent, bent(kLeft.hip, kLeft.knee, kLeft.ankle));
        if (!p.has(kRight.ankle) || !p.has(kLeft.ankle)) return;
        const Vector3f lead = p[kRight.ankle] - p[kLeft.ankle];
        set(PoseBit::RightFootInFront, lead.dot(facing) > 0);
        set(PoseBit::LeftFootInFront, lead.dot(facing) < 0);
        set(PoseBit::RightFootRaised, lead.y() > static_cast<float>(settings.raised));
        set(PoseBit::LeftFootRaised, -lead.y() > static_cast<float>(settings.raised));
        if (!p.has(Role::Pelvis)) return;
        float leg = 0;
        for (const Side& side : {kRight, kLeft}) {
            if (!p.has(side.hip) || !p.has(side.knee)) return;
            leg += 0.5f *
                   ((p[side.hip] - p[side.knee]).norm() + (p[side.knee] - p[side.ankle]).norm());
        }
        const float low = std::min(p[kRight.ankle].y(), p[kLeft.ankle].y());
        set(PoseBit::Crouched,
            p[Role::Pelvis].y() - low < static_cast<float>(settings.crouch) * leg);
    }

    void trunk() {
        const Vector3f left = Vector3f::UnitY().cross(facing);
        if (p.has(Role::LeftShoulder) && p.has(Role::RightShoulder)) {
            Vector3f line = p[Role::LeftShoulder] - p[Role::RightShoulder];
            line.y() = 0;
            // Turned to the left: the left shoulder has gone back.
            const float limit = std::sin(radians(settings.turned)) * line.norm();
            set(PoseBit::TurnedLeft, -line.dot(facing) > limit);
            set(PoseBit::TurnedRight, line.dot(facing) > limit);
        }
        if (!p.has(Role::Pelvis) || !p.has(Role::Neck)) return;
        const Vector3f up = p[Role::Neck] - p[Role::Pelvis];
        const float limit = static_cast<float>(settings.lean) * up.norm();
        set(PoseBit::LeansForward, up.dot(facing) > limit);
        set(PoseBit::LeansLeft, up.dot(left) > limit);
        set(PoseBit::LeansRight, -up.dot(left) > limit);
    }
};

}  // namespace

PoseBits maskOf(BodyPart part) {
    using enum PoseBit;
    switch (part) {
        case BodyPart::RightArm:
            return maskOf(RightElbowBent) | maskOf(RightHandAboveShoulder) |
                   maskOf(RightHandInFront);
        case BodyPart::RightLeg:
            return maskOf(RightFootInFront) | maskOf(RightKneeBent) | maskOf(RightFootRaised);
        case BodyPart::LeftArm:
        case BodyPart::LeftLeg:
            return mirrored(maskOf(mirrored(part)));
        case BodyPart::Trunk:
            break;
    }
    return maskOf(TurnedRight) | maskOf(TurnedLeft) | maskOf(LeansRight) | maskOf(LeansLeft) |
           kMiddle;
}

std::string_view bitName(PoseBit bit) {
    return kNames[static_cast<std::size_t>(bit)];
}

PoseBits mirrored(PoseBits bits) {
    constexpr PoseBits kRights = 0x55555555u;
    const PoseBits pairs = bits & ~kMiddle;
    return ((pairs & kRights) << 1) | ((pairs >> 1) & kRights) | (bits & kMiddle);
}

Eigen::Vector3f facingOf(const RolePoints& points) {
    if (!points.has(Role::LeftHip) || !points.has(Role::RightHip)) return Vector3f::UnitZ();
    Vector3f across = points[Role::LeftHip] - points[Role::RightHip];
    across.y() = 0;
    if (across.norm() < 1e-6f) return Vector3f::UnitZ();
    return across.cross(Vector3f::UnitY()).normalized();
}

float rightFootLead(const RolePoints& points) {
    return (points[Role::RightAnkle] - points[Role::LeftAnkle]).dot(facingOf(points));
}

float jointAngle(const Vector3f& end, const Vector3f& middle, const Vector3f& otherEnd) {
    const Vector3f a = end - middle, b = otherEnd - middle;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

PoseBits poseBits(const RolePoints& points, const PoseFeatureSettings& settings) {
    Look look{points, settings, std::cos(radians(settings.bent)), facingOf(points)};
    look.arm(kRight, PoseBit::RightElbowBent, PoseBit::RightHandAboveShoulder,
             PoseBit::RightHandInFront);
    look.arm(kLeft, PoseBit::LeftElbowBent, PoseBit::LeftHandAboveShoulder,
             PoseBit::LeftHandInFront);
    look.legs();
    look.trunk();
    return look.bits;
}

std::vector<PoseBits> poseBits(const JointPositions& positions, const RoleMap& roles,
                               const PoseFeatureSettings& settings, const Progress& progress) {
    std::vector<PoseBits> bits(static_cast<std::size_t>(positions.frameCount));
    std::atomic<int> done{0};
    constexpr int kBlock = 4096;
    forBlocks({0, positions.frameCount}, kBlock, [&](FrameRange block) {
        RolePoints points;
        for (int frame = block.begin; frame < block.end; ++frame) {
            for (const Role role : allRoles()) {
                if (roles[role]) points.set(role, positions.at(frame, *roles[role]));
            }
            bits[static_cast<std::size_t>(frame)] = poseBits(points, settings);
        }
        done += block.size();
        progress.update(static_cast<double>(done) / positions.frameCount);
    });
    return bits;
}

}  // namespace kumite
