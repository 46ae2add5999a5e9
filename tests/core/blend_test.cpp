#include "core/motion/blend.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/recording.h"
#include "core/motion/survey.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

std::shared_ptr<const Rig> humanRig() {
    const auto motion = test::bobbing(1, 60, [](double) { return 0.0; });
    const Fighter fighter = test::makeFighter(motion, 60);
    return std::make_shared<const Rig>(
        rigOf(*motion, motion->frames(), fighter.space, fighter.roles));
}

Pose randomPose(const Rig& rig, std::mt19937& random) {
    std::normal_distribution<double> normal;
    Pose pose;
    pose.root = {normal(random), normal(random), normal(random)};
    for (int i = 0; i < rig.jointCount(); ++i) {
        Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
        pose.turns.push_back(rig.joint(i).isEndSite ? Quaterniond::Identity() : turn.normalized());
    }
    return pose;
}

double distance(const Pose& a, const Pose& b) {
    double worst = (a.root - b.root).norm();
    for (std::size_t i = 0; i < a.turns.size(); ++i)
        worst = std::max(worst, a.turns[i].angularDistance(b.turns[i]));
    return worst;
}

TEST(GroundTransform, TurnsZTowardXAndComposes) {
    const GroundTransform quarter{M_PI / 2, 1, 2};
    EXPECT_LT((quarter * Vector3d(0, 5, 3) - Vector3d(4, 5, 2)).norm(), 1e-12);
    EXPECT_LT((quarter.turn() * Vector3d(0, 0, 1) - Vector3d(1, 0, 0)).norm(), 1e-12);
    const GroundTransform other{-0.7, 0.3, -4};
    const Vector3d p(0.2, 0.4, 0.6);
    EXPECT_LT((quarter * other * p - quarter * (other * p)).norm(), 1e-12);
    EXPECT_LT(((other.inverse() * other) * p - p).norm(), 1e-12);
}

TEST(GroundAlignment, FindsTheTransformThatWasApplied) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-2, 2);
    for (int round = 0; round < 50; ++round) {
        const GroundTransform made{number(random), number(random), number(random)};
        std::vector<Vector3d> from, to;
        for (int i = 0; i < 7; ++i) {
            from.emplace_back(number(random), number(random), number(random));
            to.push_back(made * from.back());
        }
        const GroundTransform found = groundAlignment(from, to);
        EXPECT_NEAR(std::remainder(found.yaw - made.yaw, 2 * M_PI), 0, 1e-9);
        EXPECT_NEAR(found.x, made.x, 1e-9);
        EXPECT_NEAR(found.z, made.z, 1e-9);
    }
}

TEST(GroundAlignment, IsTheLeastSumOfSquares) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> number(-2, 2), weight(0.1, 1);
    std::vector<Vector3d> from, to;
    std::vector<double> weights;
    for (int i = 0; i < 9; ++i) {
        from.emplace_back(number(random), 0, number(random));
        to.emplace_back(number(random), 0, number(random));
        weights.push_back(weight(random));
    }
    const auto cost = [&](const GroundTransform& transform) {
        double sum = 0;
        for (std::size_t i = 0; i < from.size(); ++i)
            sum += weights[i] * (to[i] - transform * from[i]).squaredNorm();
        return sum;
    };
    const GroundTransform best = groundAlignment(from, to, weights);
    for (const double step : {-0.01, 0.01}) {
        EXPECT_LT(cost(best), cost({best.yaw + step, best.x, best.z}));
        EXPECT_LT(cost(best), cost({best.yaw, best.x + step, best.z}));
        EXPECT_LT(cost(best), cost({best.yaw, best.x, best.z + step}));
    }
}

TEST(GroundAlignment, OfOnePointOnlyShifts) {
    const std::vector<Vector3d> from = {{1, 2, 3}}, to = {{4, 0, 5}};
    const GroundTransform found = groundAlignment(from, to);
    EXPECT_EQ(found.yaw, 0);
    EXPECT_DOUBLE_EQ(found.x, 3);
    EXPECT_DOUBLE_EQ(found.z, 2);
    EXPECT_THROW(groundAlignment(from, std::vector<Vector3d>{}), Error);
    EXPECT_THROW(groundAlignment(from, to, std::vector<double>{0.0}), Error);
}

TEST(GroundAlignment, OfPosesMakesThemFaceOneWay) {
    const auto rig = humanRig();
    std::mt19937 random(8);
    const Pose a = randomPose(*rig, random), b = randomPose(*rig, random);
    const Pose there = moved(a, groundAlignment(*rig, a, b));
    EXPECT_NEAR(there.root.x(), b.root.x(), 1e-12);
    EXPECT_NEAR(there.root.z(), b.root.z(), 1e-12);
    EXPECT_EQ(there.root.y(), a.root.y());
    EXPECT_NEAR(*headingOf(*rig, there), *headingOf(*rig, b), 1e-9);
}

TEST(Moved, IsRigid) {
    const auto rig = humanRig();
    std::mt19937 random(9);
    const Pose pose = randomPose(*rig, random);
    const GroundTransform transform{1.1, -2, 0.5};
    JointFrames before, after;
    jointFrames(*rig, pose, before);
    jointFrames(*rig, moved(pose, transform), after);
    for (std::size_t i = 0; i < before.positions.size(); ++i)
        EXPECT_LT((after.positions[i] - transform * before.positions[i]).norm(), 1e-12);
}

TEST(Blend, EndsAreThePosesAndTheMiddleIsHalfWayTheShortWay) {
    const auto rig = humanRig();
    std::mt19937 random(10);
    const Pose a = randomPose(*rig, random);
    Pose b = randomPose(*rig, random);
    EXPECT_LT(distance(blend(a, b, 0), a), 1e-7);
    EXPECT_LT(distance(blend(a, b, 1), b), 1e-7);
    for (Quaterniond& turn : b.turns)
        turn.coeffs() = -turn.coeffs();  // the same pose
    const Pose middle = blend(a, b, 0.5);
    for (std::size_t i = 0; i < a.turns.size(); ++i) {
        const double half = 0.5 * a.turns[i].angularDistance(b.turns[i]);
        EXPECT_NEAR(middle.turns[i].angularDistance(a.turns[i]), half, 1e-7);
        EXPECT_NEAR(middle.turns[i].angularDistance(b.turns[i]), half, 1e-7);
    }
}

Clip risingClip(int frames, double rate) {
    Clip clip{humanRig(), rate, {}};
    for (int i = 0; i < frames; ++i) {
        Pose pose;
        pose.root = {0, i / rate, 0};
        pose.turns.assign(clip.rig->joints.size(), Quaterniond::Identity());
        pose.turns[1] = Eigen::AngleAxisd(0.5 * i / rate, Vector3d::UnitX());
        clip.frames.push_back(pose);
    }
    return clip;
}

TEST(Resampled, KeepsTheMotion) {
    const Clip clip = risingClip(61, 60);
    const Clip at25 = resampled(clip, 25);
    ASSERT_EQ(at25.frameCount(), 26);
    for (int i = 0; i < at25.frameCount(); ++i) {
        const Pose& pose = at25.frames[static_cast<std::size_t>(i)];
        EXPECT_NEAR(pose.root.y(), i / 25.0, 1e-12);
        EXPECT_NEAR(pose.turns[1].angularDistance(Quaterniond::Identity()), 0.5 * i / 25.0, 1e-7);
    }
    // Frames that exist are taken as they are.
    const Clip half = resampled(clip, 30);
    ASSERT_EQ(half.frameCount(), 31);
    for (std::size_t i = 0; i < half.frames.size(); ++i)
        EXPECT_EQ(half.frames[i].root, clip.frames[2 * i].root);
    EXPECT_THROW(resampled(clip, 0), Error);
}

TEST(PoseAt, StaysAtTheEnds) {
    const Clip clip = risingClip(11, 10);
    EXPECT_EQ(poseAt(clip, -1).root, clip.frames.front().root);
    EXPECT_EQ(poseAt(clip, 99).root, clip.frames.back().root);
    EXPECT_NEAR(poseAt(clip, 0.25).root.y(), 0.25, 1e-12);
}

TEST(Mirrored, IsTheMirrorImage) {
    const auto rig = humanRig();
    std::mt19937 random(12);
    const Mirror mirror = mirrorOf(*rig);
    EXPECT_LT(mirror.asymmetry, 1e-12);
    const Pose pose = randomPose(*rig, random);
    const Pose image = mirrored(mirror, pose);
    JointFrames before, after;
    jointFrames(*rig, pose, before);
    jointFrames(*rig, image, after);
    int exchanged = 0;
    for (std::size_t i = 0; i < before.positions.size(); ++i) {
        const auto other = static_cast<std::size_t>(mirror.partner[i]);
        exchanged += other != i;
        const Vector3d p = before.positions[other];
        EXPECT_LT((after.positions[i] - Vector3d(-p.x(), p.y(), p.z())).norm(), 1e-12)
            << rig->joints[i].name;
    }
    EXPECT_EQ(exchanged, 20);  // ten a side: arm, leg and End Sites
    EXPECT_LT(distance(mirrored(mirror, image), pose), 1e-7);
}

// Rest poses that lie along x (all bones point the same way) have another mirror than that of x.
TEST(Mirrored, OfARigWhoseRestLies) {
    const auto skeleton = test::makeSkeleton({{"Hips", -1, {0, 0, 0}, "XYZzxy"},
                                              {"Spine", 0, {10, 0, 0}, "zxy"},
                                              {"Neck", 1, {40, 0, 0}, "zxy"},
                                              {"LeftUpLeg", 0, {-2, 0, 10}, "zxy"},
                                              {"LeftLeg", 3, {40, 0, 0}, "zxy"},
                                              {"LeftFoot", 4, {40, 0, 0}, "zxy"},
                                              {"RightUpLeg", 0, {-2, 0, -10}, "zxy"},
                                              {"RightLeg", 6, {40, 0, 0}, "zxy"},
                                              {"RightFoot", 7, {40, 0, 0}, "zxy"}});
    RoleMap roles;
    roles.set(Role::Pelvis, 0);
    roles.set(Role::Neck, 2);
    for (const auto& [role, joint] :
         {std::pair{Role::LeftHip, 3}, std::pair{Role::LeftKnee, 4}, std::pair{Role::LeftAnkle, 5},
          std::pair{Role::RightHip, 6}, std::pair{Role::RightKnee, 7},
          std::pair{Role::RightAnkle, 8}})
        roles.set(role, joint);
    const auto motion = test::makeMotion(skeleton, 1, 60, [](int, int) { return 0.0; });
    const Rig rig = rigOf(*motion, motion->frames(), {0.01, UpAxis::Y}, roles);
    const Mirror mirror = mirrorOf(rig);
    EXPECT_LT((mirror.sideways.cwiseAbs() - Vector3d::UnitZ()).norm(), 1e-12);
    std::mt19937 random(13);
    const Pose pose = randomPose(rig, random);
    JointFrames before, after;
    jointFrames(rig, pose, before);
    jointFrames(rig, mirrored(mirror, pose), after);
    for (std::size_t i = 0; i < before.positions.size(); ++i) {
        const Vector3d p = before.positions[static_cast<std::size_t>(mirror.partner[i])];
        EXPECT_LT((after.positions[i] - Vector3d(-p.x(), p.y(), p.z())).norm(), 1e-12);
    }
}

TEST(Mirrored, ARecordingIsNearItsMirrorImage) {
    KUMITE_NEEDS_DATA();
    const Recording recording =
        readRecording(*test::dataFolder() / "cmu_karate" / "martial_04.bvh");
    const Motion& motion = *recording.motions.front();
    const Survey survey = surveyMotion(motion);
    const Clip clip = clipOf(motion, {600, 610}, survey.space, survey.roles.roles);
    const Mirror mirror = mirrorOf(*clip.rig);
    int exchanged = 0;
    for (std::size_t i = 0; i < mirror.partner.size(); ++i)
        exchanged += mirror.partner[i] != static_cast<int>(i);
    EXPECT_GE(exchanged, 28);  // fingers and thumbs, too
    EXPECT_LT(mirror.asymmetry, 0.05);
    JointFrames before, after;
    jointFrames(*clip.rig, clip.frames[0], before);
    jointFrames(*clip.rig, mirrored(mirror, clip.frames[0]), after);
    for (std::size_t i = 0; i < before.positions.size(); ++i) {
        const Vector3d p = before.positions[static_cast<std::size_t>(mirror.partner[i])];
        EXPECT_LT((after.positions[i] - Vector3d(-p.x(), p.y(), p.z())).norm(), 0.1)
            << clip.rig->joints[i].name;
    }
}

}  // namespace
}  // namespace kumite
