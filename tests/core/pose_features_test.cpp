// Boolean features of poses, their mirror images, and the parts of a body.
#include "core/editing/pose_features.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/support/builders.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

using Eigen::Vector3f;

constexpr float kDegrees = static_cast<float>(180 / std::numbers::pi);

/// Somebody who stands upright, facing +z, arms hanging.
RolePoints standing() {
    RolePoints p;
    p.set(Role::Pelvis, {0, 0.95f, 0});
    p.set(Role::Chest, {0, 1.25f, 0});
    p.set(Role::Neck, {0, 1.5f, 0});
    for (const float side : {1.0f, -1.0f}) {
        const bool left = side > 0;
        p.set(left ? Role::LeftHip : Role::RightHip, {side * 0.09f, 0.92f, 0});
        p.set(left ? Role::LeftKnee : Role::RightKnee, {side * 0.1f, 0.5f, 0.01f});
        p.set(left ? Role::LeftAnkle : Role::RightAnkle, {side * 0.1f, 0.09f, 0});
        p.set(left ? Role::LeftShoulder : Role::RightShoulder, {side * 0.2f, 1.45f, 0});
        p.set(left ? Role::LeftElbow : Role::RightElbow, {side * 0.22f, 1.17f, 0});
        p.set(left ? Role::LeftWrist : Role::RightWrist, {side * 0.22f, 0.92f, 0.02f});
    }
    return p;
}

RolePoints seenInMirror(const RolePoints& points) {
    RolePoints other;
    for (const Role role : allRoles()) {
        if (!points.has(role)) continue;
        other.set(mirrored(role), points[role].cwiseProduct(Vector3f(-1, 1, 1)));
    }
    return other;
}

bool has(const RolePoints& points, PoseBit bit) {
    return poseBits(points) & maskOf(bit);
}

TEST(PoseFeatures, KnownAnswers) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer("boolean_features");
    PoseFeatureSettings settings;
    settings.bent = known["input"]["bend_deg"];
    ASSERT_GT(known["poses"].size(), 5u);
    for (const auto& pose : known["poses"]) {
        RolePoints points;
        for (const auto& [name, at] : pose["roles"].items())
            points.set(*roleFromName(name), {at[0].get<float>(), at[1], at[2]});
        const auto& expected = pose["expected"];
        const PoseBits bits = poseBits(points, settings);
        const std::string what = pose["what"];
        const auto bit = [&](PoseBit b) { return (bits & maskOf(b)) ? 1 : 0; };
        EXPECT_EQ(bit(PoseBit::RightFootInFront), expected["F1"].get<int>()) << what;
        EXPECT_EQ(bit(PoseBit::LeftFootInFront), expected["F2"].get<int>()) << what;
        EXPECT_EQ(bit(PoseBit::RightElbowBent), expected["F3"].get<int>()) << what;
        EXPECT_EQ(bit(PoseBit::LeftElbowBent), expected["F4"].get<int>()) << what;
        // Positions are floats: half a micrometre.
        EXPECT_NEAR(rightFootLead(points), expected["right_ahead_m"].get<double>(), 2e-6) << what;
        EXPECT_NEAR(kDegrees * jointAngle(points[Role::RightShoulder], points[Role::RightElbow],
                                          points[Role::RightWrist]),
                    expected["right_elbow_deg"].get<double>(), 1e-3)
            << what;
        EXPECT_NEAR(kDegrees * jointAngle(points[Role::LeftShoulder], points[Role::LeftElbow],
                                          points[Role::LeftWrist]),
                    expected["left_elbow_deg"].get<double>(), 1e-3)
            << what;
    }
}

TEST(PoseFeatures, EachOfThemOnAPoseMadeForIt) {
    EXPECT_EQ(poseBits(standing()), 0u);
    RolePoints p = standing();
    p.set(Role::RightWrist, {-0.22f, 1.5f, 0.1f});
    EXPECT_TRUE(has(p, PoseBit::RightHandAboveShoulder));
    EXPECT_FALSE(has(p, PoseBit::LeftHandAboveShoulder));
    EXPECT_FALSE(has(p, PoseBit::RightHandInFront));
    p.set(Role::RightWrist, {-0.1f, 1.3f, 0.35f});
    EXPECT_TRUE(has(p, PoseBit::RightHandInFront));
    EXPECT_TRUE(has(p, PoseBit::RightElbowBent));
    p.set(Role::RightWrist, {-0.1f, 1.0f, 0.35f});
    EXPECT_FALSE(has(p, PoseBit::RightHandInFront)) << "too low";

    p = standing();
    p.set(Role::LeftAnkle, {0.1f, 0.4f, -0.3f});
    EXPECT_TRUE(has(p, PoseBit::LeftFootRaised));
    EXPECT_TRUE(has(p, PoseBit::LeftKneeBent));
    EXPECT_TRUE(has(p, PoseBit::RightFootInFront));
    EXPECT_FALSE(has(p, PoseBit::RightFootRaised));

    p = standing();
    p.set(Role::LeftShoulder, {0.18f, 1.45f, -0.08f});
    p.set(Role::RightShoulder, {-0.18f, 1.45f, 0.08f});
    EXPECT_TRUE(has(p, PoseBit::TurnedLeft));
    EXPECT_FALSE(has(p, PoseBit::TurnedRight));

    p = standing();
    p.set(Role::Neck, {0.2f, 1.45f, 0.2f});
    EXPECT_TRUE(has(p, PoseBit::LeansLeft));
    EXPECT_TRUE(has(p, PoseBit::LeansForward));
    EXPECT_FALSE(has(p, PoseBit::LeansRight));

    p = standing();
    p.set(Role::Pelvis, {0, 0.6f, 0});
    EXPECT_TRUE(has(p, PoseBit::Crouched));
}

TEST(PoseFeatures, DoNotDependOnPlaceAndHeading) {
    RolePoints p = standing();
    p.set(Role::LeftAnkle, {0.1f, 0.4f, -0.3f});
    p.set(Role::RightWrist, {-0.1f, 1.3f, 0.35f});
    p.set(Role::Neck, {0.15f, 1.45f, 0.2f});
    const PoseBits bits = poseBits(p);
    EXPECT_NE(bits, 0u);
    for (const float yaw : {0.4f, 1.9f, 3.0f, -2.2f}) {
        RolePoints turned;
        for (const Role role : allRoles()) {
            if (!p.has(role)) continue;
            turned.set(role,
                       Eigen::AngleAxisf(yaw, Vector3f::UnitY()) * p[role] + Vector3f(3, 0, -2));
        }
        EXPECT_EQ(poseBits(turned), bits) << yaw;
    }
}

TEST(PoseFeatures, AMirroredPoseHasMirroredBits) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> stray(-0.35f, 0.35f);
    PoseBits seen = 0;
    for (int i = 0; i < 500; ++i) {
        RolePoints p = standing();
        for (const Role role : allRoles()) {
            if (p.has(role))
                p.set(role, p[role] + Vector3f(stray(random), stray(random), stray(random)));
        }
        const PoseBits bits = poseBits(p);
        seen |= bits;
        EXPECT_EQ(poseBits(seenInMirror(p)), mirrored(bits)) << i;
        EXPECT_EQ(mirrored(mirrored(bits)), bits);
    }
    EXPECT_EQ(seen, kAllPoseBits) << "every feature took part";
}

TEST(PoseFeatures, WhatIsMissingSaysNothing) {
    EXPECT_EQ(poseBits(RolePoints{}), 0u);
    RolePoints feet;
    feet.set(Role::LeftAnkle, {0, 0, 1});
    feet.set(Role::RightAnkle, {0, 0, 0});
    EXPECT_EQ(poseBits(feet), maskOf(PoseBit::LeftFootInFront));
}

TEST(PoseFeatures, PartsShareThemOutWithoutRest) {
    PoseBits all = 0;
    for (const BodyPart part : allParts()) {
        EXPECT_EQ(all & maskOf(part), 0u) << partName(part);
        EXPECT_EQ(mirrored(maskOf(part)), maskOf(mirrored(part))) << partName(part);
        EXPECT_EQ(partFromName(partName(part)), part);
        all |= maskOf(part);
    }
    EXPECT_EQ(all, kAllPoseBits);
    EXPECT_FALSE(partFromName("tail"));
}

TEST(PoseFeatures, OfARecordingFrameByFrame) {
    KUMITE_NEEDS_DATA();
    const auto motion =
        readRecording(*test::dataFolder() / "cmu_karate" / "martial_04.bvh").motions.front();
    const RoleMap roles = mapRoles(*motion->skeleton).roles;
    const JointPositions positions =
        forwardKinematics(*motion, {1, motion->frameCount}, {0.01, UpAxis::Y});
    const auto bits = poseBits(positions, roles);
    ASSERT_EQ(bits.size(), static_cast<std::size_t>(positions.frameCount));
    const auto share = [&](PoseBit bit) {
        int count = 0;
        for (const PoseBits b : bits)
            count += (b & maskOf(bit)) != 0;
        return static_cast<double>(count) / static_cast<double>(bits.size());
    };
    // Left kick first, then two to the right; hands in a guard for most of it.
    EXPECT_GT(share(PoseBit::LeftFootRaised), 0.03);
    EXPECT_GT(share(PoseBit::RightFootRaised), share(PoseBit::LeftFootRaised));
    EXPECT_LT(share(PoseBit::RightFootRaised), 0.5);
    EXPECT_GT(share(PoseBit::LeftElbowBent), 0.4);
}

TEST(BodyParts, OfATree) {
    const auto skeleton = test::makeHuman();
    std::vector<int> parents;
    for (const Joint& joint : skeleton->joints)
        parents.push_back(joint.parent);
    const RoleMap roles = mapRoles(*skeleton).roles;
    const auto parts = partsOfJoints(parents, roles);
    EXPECT_FALSE(parts[static_cast<std::size_t>(*roles[Role::Pelvis])]);
    const auto partOf = [&](Role role) { return *parts[static_cast<std::size_t>(*roles[role])]; };
    EXPECT_EQ(partOf(Role::LeftElbow), BodyPart::LeftArm);
    EXPECT_EQ(partOf(Role::RightWrist), BodyPart::RightArm);
    EXPECT_EQ(partOf(Role::LeftHip), BodyPart::LeftLeg);
    EXPECT_EQ(partOf(Role::RightToe), BodyPart::RightLeg);
    EXPECT_EQ(partOf(Role::Chest), BodyPart::Trunk);
    EXPECT_EQ(partOf(Role::Head), BodyPart::Trunk);
    for (std::size_t j = 1; j < parts.size(); ++j)
        EXPECT_TRUE(parts[j]) << skeleton->joints[j].name << " belongs somewhere";
    EXPECT_EQ(junctionOf(parts, BodyPart::LeftLeg), roles[Role::LeftHip]);
    EXPECT_FALSE(junctionOf({}, BodyPart::LeftLeg));
}

}  // namespace
}  // namespace kumite
