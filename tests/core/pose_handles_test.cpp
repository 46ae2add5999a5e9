// A pose dragged by its handles: limbs, pins, limits.
#include "core/editing/pose_handles.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/made_strikes.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const Pose& guard() {
    static const Pose pose = test::asExamples(test::madeStrikes(test::StrikeKind::StraightPunch))
                                 .front()
                                 .clip.frames.front();
    return pose;
}

Vector3d at(const Pose& pose, Handle handle) {
    return *handlePoint(*test::madeRig(), pose, handle);
}

TEST(PoseHandles, EveryOneComesWhereItIsDragged) {
    const Rig& rig = *test::madeRig();
    for (const Handle handle : allHandles()) {
        const Vector3d way =
            handle == Handle::Head ? Vector3d(0.04, -0.01, 0.05) : Vector3d(0.06, 0.03, 0.05);
        const Vector3d place = at(guard(), handle) + way;
        const DragResult result = dragged(rig, guard(), handle, place);
        // A spine has one length: chest and head come only near to what is off their sphere.
        const double near = handle == Handle::Chest || handle == Handle::Head ? 0.06 : 1e-3;
        EXPECT_LT(result.missing, near) << handleName(handle);
        EXPECT_NEAR((at(result.pose, handle) - place).norm(), result.missing, 1e-9);
        EXPECT_EQ(handleFromName(handleName(handle)), handle);
        for (const Quaterniond& turn : result.pose.turns)
            EXPECT_NEAR(turn.norm(), 1, 1e-9);
    }
    EXPECT_FALSE(handleFromName("tail"));
}

TEST(PoseHandles, DraggedNowhereAPoseStaysAsItIs) {
    const Rig& rig = *test::madeRig();
    for (const Handle handle : allHandles()) {
        const DragResult result = dragged(rig, guard(), handle, at(guard(), handle));
        EXPECT_LT(result.missing, 1e-6);
        for (std::size_t j = 0; j < guard().turns.size(); ++j)
            EXPECT_LT(result.pose.turns[j].angularDistance(guard().turns[j]), 1e-5)
                << handleName(handle);
    }
    const DragResult wild = dragged(rig, guard(), Handle::LeftHand, Vector3d(std::nan(""), 0, 0));
    EXPECT_EQ(wild.pose.root, guard().root);
}

TEST(PoseHandles, PinnedFeetStandWhileTheHipsMove) {
    const Rig& rig = *test::madeRig();
    JointFrames before, after;
    jointFrames(rig, guard(), before);
    const DragResult result = dragged(rig, guard(), Handle::Hips,
                                      at(guard(), Handle::Hips) + Vector3d(0.05, -0.12, 0.04));
    jointFrames(rig, result.pose, after);
    for (const Role role : {Role::LeftAnkle, Role::RightAnkle, Role::LeftToe}) {
        const auto j = static_cast<std::size_t>(*rig.roles[role]);
        EXPECT_LT((before.positions[j] - after.positions[j]).norm(), 1e-4);
        EXPECT_LT(before.turns[j].angularDistance(after.turns[j]), 1e-6);
    }
    EXPECT_LT(result.slipped, 1e-4);
    // Lifted beyond the legs' length, the feet come along and that is said.
    const DragResult high =
        dragged(rig, guard(), Handle::Hips, at(guard(), Handle::Hips) + Vector3d(0, 0.5, 0));
    EXPECT_GT(high.slipped, 0.2);
    EXPECT_LT(
        dragged(rig, guard(), Handle::Hips, at(guard(), Handle::Hips) + Vector3d(0, 0.5, 0), Pins{})
            .slipped,
        1e-9);
}

TEST(PoseHandles, PinnedHandsStayWhenTheChestBends) {
    const Rig& rig = *test::madeRig();
    Pins pins = feetPinned();
    pins[Handle::RightHand] = true;
    const DragResult result =
        dragged(rig, guard(), Handle::Chest,
                at(guard(), Handle::Chest) + Vector3d(0.08, -0.02, 0.06), pins);
    EXPECT_LT((at(result.pose, Handle::RightHand) - at(guard(), Handle::RightHand)).norm(), 2e-3);
    EXPECT_GT((at(result.pose, Handle::LeftHand) - at(guard(), Handle::LeftHand)).norm(), 0.02);
}

TEST(PoseHandles, AHandFarAwayTakesTheTrunkAlong) {
    const Rig& rig = *test::madeRig();
    const Vector3d far(0.1, 1.1, 0.9);
    const DragResult lean = dragged(rig, guard(), Handle::LeftHand, far);
    Pins stiff = feetPinned();
    stiff[Handle::Chest] = true;
    const DragResult still = dragged(rig, guard(), Handle::LeftHand, far, stiff);
    EXPECT_LT(lean.missing, still.missing - 0.05);
    EXPECT_LT((at(still.pose, Handle::Chest) - at(guard(), Handle::Chest)).norm(), 1e-9);
    EXPECT_GT(dragged(rig, guard(), Handle::LeftHand, {0, 1, 9}).missing, 5);
}

TEST(PoseHandles, JointsKeepTheirLimits) {
    const Rig& rig = *test::madeRig();
    std::mt19937 random(9);
    std::normal_distribution<double> draw;
    for (int j = 0; j < rig.jointCount(); ++j) {
        const auto limit = jointLimit(rig, j);
        for (int i = 0; i < 50; ++i) {
            const Quaterniond turn =
                Quaterniond(draw(random), draw(random), draw(random), draw(random)).normalized();
            const Quaterniond within = withinLimit(rig, j, turn);
            EXPECT_NEAR(within.norm(), 1, 1e-9);
            EXPECT_LT(withinLimit(rig, j, within).angularDistance(within), 1e-6)
                << "once is enough";
            const double most = limit ? limit->swing + limit->twist + 1e-6 : 1e-12;
            EXPECT_LT(within.angularDistance(limit ? Quaterniond::Identity() : turn), most);
        }
        EXPECT_LT(
            withinLimit(rig, j, Quaterniond::Identity()).angularDistance(Quaterniond::Identity()),
            1e-12);
    }
    EXPECT_FALSE(jointLimit(rig, *rig.roles[Role::Pelvis]));
    // Kicks and punches of the made sets stay as they are.
    for (const test::StrikeKind kind : test::kStrikeKinds) {
        for (const auto& strike : test::madeStrikes(kind)) {
            const Pose& pose = strike.clip.frames[static_cast<std::size_t>(strike.hit)];
            const Pose within = withinLimits(rig, pose);
            for (std::size_t j = 0; j < pose.turns.size(); ++j)
                EXPECT_LT(within.turns[j].angularDistance(pose.turns[j]), 1e-6)
                    << strike.name << " " << rig.joints[j].name;
        }
    }
}

TEST(PoseHandles, AJointsTurnInNumbers) {
    const Rig& rig = *test::madeRig();
    const int elbow = *rig.roles[Role::LeftElbow];
    for (const Vector3d& degrees :
         {Vector3d(10, -20, 30), Vector3d(-80, 170, 5), Vector3d(0, 0, 0)})
        EXPECT_LT((jointAngles(turnOfAngles(degrees)) - degrees).norm(), 1e-6);
    EXPECT_LT(
        (jointAngles(turnOfAngles({10, 20, 200}), {0, 0, 190}) - Vector3d(10, 20, 200)).norm(),
        1e-6)
        << "the nearest way to say it";
    const Quaterniond over(Eigen::AngleAxisd(3.1, Vector3d::UnitY()));
    const auto limit = jointLimit(rig, elbow);
    const auto bend = jointBend(rig, elbow, withinLimit(rig, elbow, over));
    ASSERT_TRUE(bend && limit);
    EXPECT_LE(bend->swing, limit->swing + 1e-9);
    EXPECT_LE(bend->twist, limit->twist + 1e-9);
    EXPECT_FALSE(jointBend(rig, *rig.roles[Role::Pelvis], over));
}

TEST(PoseHandles, AJointTurnedByHand) {
    const Rig& rig = *test::madeRig();
    const int elbow = *rig.roles[Role::LeftElbow];
    const Quaterniond bent(Eigen::AngleAxisd(-1.2, Vector3d::UnitY()));
    const DragResult result = withJointTurn(rig, guard(), elbow, bent);
    EXPECT_LT(result.pose.turns[static_cast<std::size_t>(elbow)].angularDistance(bent), 1e-9);
    EXPECT_LT(result.slipped, 1e-6);
    const Quaterniond over(Eigen::AngleAxisd(3.1, Vector3d::UnitY()));
    const DragResult limited = withJointTurn(rig, guard(), elbow, over);
    EXPECT_LT(limited.pose.turns[static_cast<std::size_t>(elbow)].angularDistance(
                  Quaterniond::Identity()),
              155.1 * std::numbers::pi / 180);
    // The hips turned by hand leave the feet where they stand.
    const int hips = *rig.roles[Role::Pelvis];
    const DragResult turned =
        withJointTurn(rig, guard(), hips, Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitY())));
    EXPECT_LT(turned.slipped, 1e-3);
    // A chest takes both hands along, pinned or not; the feet stay.
    Pins pins = feetPinned();
    pins[Handle::LeftHand] = pins[Handle::RightHand] = true;
    const int chest = *rig.roles[Role::Chest];
    const DragResult twisted = withJointTurn(
        rig, guard(), chest, Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitY())), pins);
    const DragResult free =
        withJointTurn(rig, guard(), chest, Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitY())));
    for (const Handle hand : {Handle::LeftHand, Handle::RightHand}) {
        const Vector3d there = *handlePoint(rig, twisted.pose, hand);
        EXPECT_LT((there - *handlePoint(rig, free.pose, hand)).norm(), 1e-9);
        EXPECT_GT((there - *handlePoint(rig, guard(), hand)).norm(), 0.02);
    }
}

TEST(PoseHandles, WhatARigLacksChangesNothing) {
    Rig rig = *test::madeRig();
    rig.roles.clear(Role::LeftWrist);
    rig.roles.clear(Role::Neck);
    for (const Handle handle : {Handle::LeftHand, Handle::Chest}) {
        EXPECT_FALSE(handlePoint(rig, guard(), handle));
        const DragResult result = dragged(rig, guard(), handle, {0, 0, 0});
        EXPECT_EQ(result.pose.root, guard().root);
    }
}

}  // namespace
}  // namespace kumite
