// Bodies that stay out of each other, and feet that step over where actions join.
#include "core/synthesis/separation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/role_mapping.h"
#include "core/synthesis/join_steps.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

std::shared_ptr<const Rig> humanRig() {
    const auto motion = test::bobbing(2, 60, [](double) { return 0.0; });
    return std::make_shared<const Rig>(
        rigOf(*motion, motion->frames(), {0.01, UpAxis::Y}, mapRoles(*motion->skeleton).roles));
}

/// Standing on the floor with the arms out, facing +z.
Pose standing(const Rig& rig, double x, double z) {
    Pose pose;
    pose.root = {x, test::kHumanRootHeight / 100, z};
    pose.turns.assign(static_cast<std::size_t>(rig.jointCount()), Eigen::Quaterniond::Identity());
    return pose;
}

/// Two humans, one of whom may walk into the other.
struct Two {
    std::shared_ptr<const Rig> rig = humanRig();
    Separation separation{{rig, rig}, 60};
    std::array<Pose, 2> poses;
    std::array<JointFrames, 2> joints;

    void show(const Pose& a, const Pose& b, Separation::Stands stands = {}) {
        poses = {a, b};
        separation.foresee({&poses[0], &poses[1]}, {&poses[0], &poses[1]}, stands);
        for (const int p : {0, 1}) {
            poses[static_cast<std::size_t>(p)].root += separation.push(p);
            jointFrames(*rig, poses[static_cast<std::size_t>(p)],
                        joints[static_cast<std::size_t>(p)]);
        }
        separation.part({&poses[0], &poses[1]}, {&joints[0], &joints[1]}, stands);
    }
    double deepest() {
        std::vector<BodyCapsule> a, b;
        bodyCapsules(rig->roles, joints[0].positions, a);
        bodyCapsules(rig->roles, joints[1].positions, b);
        double most = -10;
        for (const BodyCapsule& p : a) {
            for (const BodyCapsule& q : b)
                most = std::max(most, nearness(p.solid, q.solid).depth);
        }
        return most;
    }
};

TEST(Separation, LeavesBodiesAloneThatDoNotTouch) {
    Two two;
    const Pose a = standing(*two.rig, 0, 0);
    const Pose b = standing(*two.rig, 0, 1.2);
    two.show(a, b);
    EXPECT_LT(two.deepest(), 0);
    for (const std::size_t p : {0, 1}) {
        const Pose& before = p == 0 ? a : b;
        EXPECT_EQ(two.poses[p].root, before.root);
        for (std::size_t j = 0; j < before.turns.size(); ++j)
            EXPECT_EQ(two.poses[p].turns[j].coeffs(), before.turns[j].coeffs());
    }
}

TEST(Separation, PushesTrunksApartWithoutAJump) {
    Two two;
    // Side by side and turned so that arms are out of the way: trunks 10 cm in each other.
    const Pose a = standing(*two.rig, 0, 0);
    const Pose b = standing(*two.rig, 0, 0.14);
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    double fastest = 0;
    for (int i = 0; i < 60; ++i) {
        two.show(a, b);
        fastest = std::max(fastest, (two.separation.push(0) - last).norm() * 60);
        last = two.separation.push(0);
    }
    EXPECT_LT(two.separation.push(0).z(), -0.03);
    EXPECT_NEAR((two.separation.push(0) + two.separation.push(1)).norm(), 0, 1e-12)
        << "both give way alike";
    EXPECT_EQ(two.separation.push(0).y(), 0);
    EXPECT_LT(fastest, 3);
    const Pose away = standing(*two.rig, 0, 3);
    for (int i = 0; i < 120; ++i)
        two.show(a, away);
    EXPECT_LT(two.separation.push(0).norm(), 0.001) << "goes again";
}

TEST(Separation, AHandStopsAtTheOtherBody) {
    Two two;
    // The left arm points along +x. The other one, turned so that its arms are out of the way,
    // comes nearer until the wrist is in its trunk.
    const Pose a = standing(*two.rig, 0, 0);
    JointFrames rest;
    jointFrames(*two.rig, a, rest);
    const auto wrist = static_cast<std::size_t>(*two.rig->roles[Role::LeftWrist]);
    double before = 0;
    for (int i = 0; i < 40; ++i) {
        Pose b = standing(*two.rig, rest.positions[wrist].x() + 0.20 - 0.003 * i, 0);
        b.turns[0] = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY());
        two.show(a, b);
        JointFrames other;
        jointFrames(*two.rig, b, other);
        std::vector<BodyCapsule> p, q;
        bodyCapsules(two.rig->roles, rest.positions, p);
        bodyCapsules(two.rig->roles, other.positions, q);
        before = -1;
        for (const BodyCapsule& one : p) {
            for (const BodyCapsule& another : q)
                before = std::max(before, nearness(one.solid, another.solid).depth);
        }
        EXPECT_LT(two.deepest(), 0.03) << i << ": " << before;
    }
    EXPECT_GT(before, 0.05) << "there was something to do";
    EXPECT_GT((two.joints[0].positions[wrist] - rest.positions[wrist]).norm(), 0.02);
}

// ---- join steps --------------------------------------------------------------------------------

Eigen::Vector3d footOf(const Rig& rig, const Pose& pose, bool left) {
    JointFrames joints;
    jointFrames(rig, pose, joints);
    return joints.positions[static_cast<std::size_t>(*footPoint(rig, left))];
}

constexpr double kRate = 60;

/// A foot at a join to a pose in which it stands from the frame `landing` on; before, it is in the
/// air.
FootAtJoin footAt(const Rig& rig, const Pose& shown, const Pose& next, bool left, bool stands,
                  int landing) {
    FootAtJoin foot;
    foot.place = footOf(rig, shown, left);
    foot.stands = stands;
    foot.next.assign(static_cast<std::size_t>(JoinSteps::lookAhead() * kRate),
                     footOf(rig, next, left));
    foot.landing = landing;
    foot.lift = static_cast<int>(foot.next.size());
    return foot;
}

std::array<FootAtJoin, 2> standingFeet(const Rig& rig, const Pose& shown, const Pose& next) {
    return {footAt(rig, shown, next, true, true, 0), footAt(rig, shown, next, false, true, 0)};
}

/// Crouching, so that a leg can lift and reach.
Pose crouching(const Rig& rig) {
    Pose pose = standing(rig, 0, 0);
    for (const auto& [role, angle] : {std::pair{Role::LeftHip, -0.6},
                                      {Role::RightHip, -0.6},
                                      {Role::LeftKnee, 1.0},
                                      {Role::RightKnee, 1.0}}) {
        pose.turns[static_cast<std::size_t>(*rig.roles[role])] =
            Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX());
    }
    return pose;
}

TEST(JoinSteps, AFootThatStandsInBothIsHeld) {
    const auto rig = humanRig();
    const Pose shown = standing(*rig, 0, 0);
    const Pose next = standing(*rig, 0.1, 0);
    const JoinSteps steps(*rig, next, standingFeet(*rig, shown, next), kRate, 0.2);
    EXPECT_FALSE(steps.guides(0) || steps.guides(1));
    Pose pose = shown;
    Standing stands = {true, true};
    steps.apply(*rig, pose, next, stands, 0.1);
    EXPECT_EQ(stands, (Standing{true, true}));
    EXPECT_NEAR((footOf(*rig, pose, true) - footOf(*rig, shown, true)).norm(), 0, 1e-12);
}

TEST(JoinSteps, AFootThatHasToGoIsLiftedAndStandsWhenItIsThere) {
    const auto rig = humanRig();
    const Pose shown = crouching(*rig);
    Pose next = shown;
    next.root.x() += 0.25;
    const auto feet = standingFeet(*rig, shown, next);
    const JoinSteps steps(*rig, next, feet, kRate, 0.2);
    ASSERT_TRUE(steps.guides(0));
    double highest = 0, end = 0;
    for (int frame = 1; !steps.over(frame / kRate); ++frame) {
        // The body is there at once: what is looked at are the feet.
        Pose pose = next;
        Standing stands = {true, true};
        steps.apply(*rig, pose, next, stands, frame / kRate);
        const Eigen::Vector3d foot = footOf(*rig, pose, true) - feet[0].place;
        highest = std::max(highest, foot.y());
        if (!stands[0]) end = frame / kRate;
        if (stands[0] && end > 0) {
            EXPECT_NEAR(foot.x(), 0.25, 1e-3) << "it has arrived";
            EXPECT_NEAR(foot.y(), 0, 1e-3);
        }
        if (foot.y() < 0.02) {
            const double left = std::min(foot.x(), 0.25 - foot.x());
            EXPECT_LT(left, 0.005) << "over only while it is up, frame " << frame;
        }
    }
    EXPECT_NEAR(highest, 0.09, 0.01);
    EXPECT_GT(end, 0.2);
}

TEST(JoinSteps, OfTwoFeetThatHaveToGoOneWaits) {
    const auto rig = humanRig();
    const Pose shown = crouching(*rig);
    Pose next = shown;
    next.root.x() += 0.4;
    const JoinSteps steps(*rig, next, standingFeet(*rig, shown, next), kRate, 0.2);
    Pose pose = shown;
    Standing stands = {true, true};
    steps.apply(*rig, pose, next, stands, 0.1);
    EXPECT_NE(stands[0], stands[1]);
}

TEST(JoinSteps, AFlyingFootComesDownWhereTheNextMotionStands) {
    const auto rig = humanRig();
    const Pose next = crouching(*rig);
    auto feet = standingFeet(*rig, next, next);
    feet[0].stands = false;
    feet[0].place += Eigen::Vector3d(0.1, 0.1, 0);
    feet[0].velocity = Eigen::Vector3d(1.5, 0, 0);
    const JoinSteps steps(*rig, next, feet, kRate, 0.2);
    ASSERT_TRUE(steps.guides(0));
    const Eigen::Vector3d there = feet[0].next.front();
    Eigen::Vector3d before = feet[0].place;
    for (int frame = 1; !steps.over(frame / kRate); ++frame) {
        Pose pose = next;
        Standing stands = {true, true};
        steps.apply(*rig, pose, next, stands, frame / kRate);
        const Eigen::Vector3d foot = footOf(*rig, pose, true);
        const double speed = kRate * std::hypot(foot.x() - before.x(), foot.z() - before.z());
        if (frame == 1) {
            EXPECT_NEAR(speed, 1.5, 0.3) << "it flies on";
        }
        if (foot.y() - there.y() < 0.02) {
            EXPECT_LT(speed, 0.3) << "frame " << frame;
        }
        if (stands[0]) {
            EXPECT_NEAR((foot - there).norm(), 0, 1e-3);
        }
        before = foot;
    }
}

TEST(JoinSteps, AKneeDoesNotFoldThroughItself) {
    const auto rig = humanRig();
    const Pose shown = standing(*rig, 0, 0);
    for (const double side : {1.0, -1.0}) {
        Pose next = shown;
        const auto knee = static_cast<std::size_t>(*rig->roles[Role::RightKnee]);
        next.turns[knee] = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX());
        next.turns[knee].coeffs() *= side;
        const JoinSteps steps(*rig, next, standingFeet(*rig, next, next), kRate, 0.2);
        for (const double angle : {0.2, 2.0, 2.6, 3.0, 3.4}) {
            Pose pose = shown;
            pose.turns[knee] = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX());
            pose.turns[knee].coeffs() *= side;
            Standing stands = {true, true};
            steps.apply(*rig, pose, next, stands, 0.1);
            const double shownAngle =
                2 * std::atan2(side * pose.turns[knee].x(), side * pose.turns[knee].w());
            EXPECT_NEAR(shownAngle, std::min(angle, 2.65), 1e-9);
        }
    }
}

}  // namespace
}  // namespace kumite
