#include "core/motion/two_bone.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/motion/blend.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Human {
    Rig rig;
    Pose pose;
    JointFrames frames;

    Human() {
        const auto motion = test::bobbing(1, 60, [](double) { return 0.0; });
        const Fighter fighter = test::makeFighter(motion, 60);
        rig = rigOf(*motion, motion->frames(), fighter.space, fighter.roles);
        pose = clipOf(*motion, motion->frames(), fighter.space, fighter.roles).frames[0];
        jointFrames(rig, pose, frames);
    }

    Vector3d place(int joint) const { return frames.positions[static_cast<std::size_t>(joint)]; }
    Vector3d place(Role role) const { return place(*rig.roles[role]); }
    Quaterniond turn(Role role) const {
        return frames.turns[static_cast<std::size_t>(*rig.roles[role])];
    }

    double reachFor(Role end, const Vector3d& target, EndTurn endTurn = EndTurn::KeepsWorld) {
        const Vector3d left = reach(rig, pose, frames, *limbOf(rig, end), target, endTurn);
        jointFrames(rig, pose, frames);
        EXPECT_LT((place(end) - target - left).norm(), 1e-9);
        return left.norm();
    }
};

TEST(TwoBone, RightTriangleByHand) {
    // Bones 3 and 4 over a span of 5: the middle is 9/5 along and 12/5 off the line.
    const TwoBone bent = bend({0, 0, 0}, {5, 0, 0}, {0, 1, 0}, 3, 4);
    EXPECT_LT((bent.middle - Vector3d(1.8, 2.4, 0)).norm(), 1e-12);
    EXPECT_LT((bent.end - Vector3d(5, 0, 0)).norm(), 1e-12);
    // Out of reach: nearly straight toward it.
    const TwoBone far = bend({0, 0, 0}, {9, 0, 0}, {0, 1, 0}, 3, 4);
    EXPECT_NEAR(far.end.x(), 0.9985 * 7, 1e-12);
}

TEST(Reach, PutsTheEndWhereItIsWanted) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-0.1, 0.1);
    for (const Role end : {Role::LeftWrist, Role::RightWrist, Role::LeftAnkle, Role::RightAnkle}) {
        Human human;
        // Bent to begin with.
        const bool isLeg = limbOf(human.rig, end)->isLeg;
        human.reachFor(end, human.place(end) +
                                (isLeg ? Vector3d(0, 0.2, 0.1)
                                       : Vector3d(end == Role::LeftWrist ? -0.2 : 0.2, 0.1, 0.1)));
        for (int i = 0; i < 30; ++i) {
            Human copy = human;
            const Vector3d target =
                copy.place(end) + Vector3d(number(random), number(random), number(random));
            const Quaterniond before = copy.turn(end);
            EXPECT_LT(copy.reachFor(end, target), 1e-9);
            EXPECT_LT((copy.place(end) - target).norm(), 1e-9);
            EXPECT_LT(copy.turn(end).angularDistance(before), 1e-7);
        }
    }
}

TEST(Reach, AloneTurnsTheLimbAndNothingElse) {
    Human human;
    const Human before = human;
    human.reachFor(Role::LeftAnkle, human.place(Role::LeftAnkle) + Vector3d(0.05, 0.1, 0.1));
    const Limb limb = *limbOf(human.rig, Role::LeftAnkle);
    for (int joint = 0; joint < human.rig.jointCount(); ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        const bool turns = joint == limb.root || joint == limb.middle || joint == limb.end;
        if (turns) continue;
        EXPECT_EQ(human.pose.turns[i].coeffs(), before.pose.turns[i].coeffs());
    }
    EXPECT_EQ(human.pose.root, before.pose.root);
}

TEST(Reach, NothingChangesWhereTheEndAlreadyIs) {
    Human human;
    for (const bool bentBefore : {false, true}) {
        if (bentBefore)
            human.reachFor(Role::RightAnkle,
                           human.place(Role::RightAnkle) + Vector3d(0.1, 0.1, 0.2));
        Human again = human;
        EXPECT_LT(again.reachFor(Role::RightAnkle, again.place(Role::RightAnkle)), 1e-9);
        for (std::size_t i = 0; i < human.pose.turns.size(); ++i)
            EXPECT_LT(again.pose.turns[i].angularDistance(human.pose.turns[i]), 1e-7);
    }
}

TEST(Reach, StraightLimbsBendTheirNaturalWay) {
    Human human;
    human.pose = moved(human.pose, {0.9, 0, 0});
    jointFrames(human.rig, human.pose, human.frames);
    const Vector3d ahead = GroundTransform{0.9, 0, 0} * Vector3d::UnitZ();
    Human knee = human;
    knee.reachFor(Role::LeftAnkle, knee.place(Role::LeftAnkle) + Vector3d(0, 0.2, 0));
    EXPECT_GT((knee.place(Role::LeftKnee) - human.place(Role::LeftKnee)).dot(ahead), 0.2);
    Human elbow = human;
    const Vector3d inward = elbow.place(Role::LeftShoulder) - elbow.place(Role::LeftWrist);
    elbow.reachFor(Role::LeftWrist, elbow.place(Role::LeftWrist) + 0.4 * inward);
    EXPECT_LT((elbow.place(Role::LeftElbow) - human.place(Role::LeftElbow)).dot(ahead), -0.15);
}

TEST(Reach, AnOverstretchedKneeBendsForward) {
    Human human;
    const auto knee = static_cast<std::size_t>(*human.rig.roles[Role::LeftKnee]);
    // 2° the wrong way: the foot goes forward.
    human.pose.turns[knee] = Eigen::AngleAxisd(-2 * M_PI / 180, Vector3d::UnitX());
    jointFrames(human.rig, human.pose, human.frames);
    const Vector3d ankle = human.place(Role::LeftAnkle), hip = human.place(Role::LeftHip);
    double before = 0;
    for (const double share : {0.0, 0.001, 0.005, 0.02, 0.1}) {
        Human bent = human;
        bent.reachFor(Role::LeftAnkle, ankle + share * (hip - ankle));
        const Vector3d line =
            (bent.place(Role::LeftAnkle) - bent.place(Role::LeftHip)).normalized();
        const Vector3d off = bent.place(Role::LeftKnee) - bent.place(Role::LeftHip);
        const double ahead = (off - off.dot(line) * line).z();
        if (share >= 0.005) {
            EXPECT_GT(ahead, 0.02);
        }
        EXPECT_GT(ahead, before - 0.02);
        before = ahead;
    }
}

TEST(Reach, StopsAtTheLimits) {
    Human human;
    human.reachFor(Role::LeftAnkle, human.place(Role::LeftAnkle) + Vector3d(0, 0.1, 0));
    const Vector3d hip = human.place(Role::LeftHip);
    Human far = human;
    const double left = far.reachFor(Role::LeftAnkle, hip + Vector3d(0, -2, 0));
    EXPECT_NEAR(left, 2 - 0.9985 * 0.84, 1e-9);
    Human near = human;
    EXPECT_NEAR(near.reachFor(Role::LeftAnkle, hip + Vector3d(0, -0.1, 0)), 0.33 * 0.84 - 0.1,
                1e-9);
}

TEST(Reach, AHandMayRideAlong) {
    Human human;
    const auto wrist = static_cast<std::size_t>(*human.rig.roles[Role::LeftWrist]);
    const Quaterniond before = human.pose.turns[wrist];
    human.reachFor(Role::LeftWrist, human.place(Role::LeftWrist) + Vector3d(-0.2, 0, 0.2),
                   EndTurn::KeepsLocal);
    EXPECT_EQ(human.pose.turns[wrist].coeffs(), before.coeffs());
}

TEST(Limb, NeedsItsJoints) {
    Human human;
    EXPECT_FALSE(limbOf(human.rig, Role::Head));
    human.rig.roles.clear(Role::LeftKnee);
    EXPECT_FALSE(limbOf(human.rig, Role::LeftAnkle));
    EXPECT_TRUE(limbOf(human.rig, Role::RightAnkle));
    human.rig.roles.set(Role::RightKnee, *human.rig.roles[Role::LeftElbow]);
    EXPECT_FALSE(limbOf(human.rig, Role::RightAnkle));
}

}  // namespace
}  // namespace kumite
