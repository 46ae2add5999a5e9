#include "core/motion/inertialise.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A rig of one joint, so that poses are a root and a turn.
std::shared_ptr<const Rig> point() {
    Rig rig;
    rig.joints.push_back({"root", -1, Vector3d::Zero(), false});
    return std::make_shared<const Rig>(rig);
}

Pose poseOf(double x, double turn) {
    return {{x, 0, 0}, {Quaterniond(Eigen::AngleAxisd(turn, Vector3d::UnitY()))}};
}

double turnOf(const Pose& pose) {
    return 2 * std::atan2(pose.turns[0].y(), pose.turns[0].w());
}

TEST(Inertialisation, QuinticByHand) {
    // Offsets 1 m and 0.5 rad, no speeds: at half time 1 − 10/8 + 15/16 − 6/32 = ½ is left.
    const Inertialisation join(poseOf(1, 0.5), poseOf(1, 0.5), poseOf(0, 0), poseOf(0, 0), 0.01,
                               {.duration = 0.4});
    Pose pose = poseOf(0, 0);
    join.apply(pose, 0.2);
    EXPECT_NEAR(pose.root.x(), 0.5, 1e-12);
    EXPECT_NEAR(turnOf(pose), 0.25, 1e-12);
    pose = poseOf(3, 0);
    join.apply(pose, 0.0);
    EXPECT_NEAR(pose.root.x(), 4, 1e-12);
    for (const double seconds : {0.4, 7.0}) {
        pose = poseOf(3, 0);
        join.apply(pose, seconds);
        EXPECT_EQ(pose.root.x(), 3);
        EXPECT_TRUE(join.over(seconds));
    }
    // Speed alone: v T (s − 6 s³ + 8 s⁴ − 3 s⁵) at s = ½ is v T · 5/32.
    const Inertialisation moving(poseOf(-0.001, 0), poseOf(0, 0), poseOf(0, 0), poseOf(0, 0), 0.01,
                                 {.duration = 0.4});
    EXPECT_NEAR(moving.at(0.2).root.x(), 0.1 * 0.4 * 5.0 / 32.0, 1e-12);
}

TEST(Inertialisation, PositionAndSpeedAreContinuous) {
    // Both motions turn about differing axes with differing speeds; the offset is large.
    const auto shownAt = [](double t) {
        Pose pose;
        pose.root = {0.3 * t, 1 + 0.2 * t, 0};
        pose.turns = {
            Quaterniond(Eigen::AngleAxisd(1.0 + 0.8 * t, Vector3d(1, 2, 0).normalized()))};
        return pose;
    };
    const auto nextAt = [](double t) {
        Pose pose;
        pose.root = {0.1 - 0.2 * t, 1.02, 0.1 * t};
        pose.turns = {
            Quaterniond(Eigen::AngleAxisd(0.4 - 0.5 * t, Vector3d(0, 1, 1).normalized()))};
        return pose;
    };
    constexpr double dt = 1e-5;
    const Inertialisation join(shownAt(-dt), shownAt(0), nextAt(0), nextAt(dt), dt,
                               {.duration = 0.2, .overshootTurn = 10, .overshootRoot = 10});
    const auto resultAt = [&](double t) {
        Pose pose = nextAt(t);
        join.apply(pose, t);
        return pose;
    };
    EXPECT_LT((resultAt(0).root - shownAt(0).root).norm(), 1e-12);
    EXPECT_LT(resultAt(0).turns[0].angularDistance(shownAt(0).turns[0]), 1e-7);
    const PoseOffset speed = offsetBetween(resultAt(dt), resultAt(0));
    const PoseOffset shownSpeed = offsetBetween(shownAt(0), shownAt(-dt));
    EXPECT_LT((speed.root - shownSpeed.root).norm() / dt, 1e-3);
    EXPECT_LT((speed.turns[0] - shownSpeed.turns[0]).norm() / dt, 1e-3);
    // And at the end it is the following motion's.
    const PoseOffset end = offsetBetween(resultAt(0.2), resultAt(0.2 - dt));
    const PoseOffset nextSpeed = offsetBetween(nextAt(0.2), nextAt(0.2 - dt));
    EXPECT_LT((end.turns[0] - nextSpeed.turns[0]).norm() / dt, 1e-3);
}

TEST(Inertialisation, DoesNotSwingFarBeyondBothMotions) {
    // Shown at 40 rad/s and 10 m/s, followed by rest.
    const Inertialisation join(poseOf(-0.1, -0.4), poseOf(0, 0), poseOf(0, 0), poseOf(0, 0), 0.01);
    double turn = 0, root = 0;
    for (int i = 0; i <= 200; ++i) {
        turn = std::max(turn, join.at(0.001 * i).turns[0].norm());
        root = std::max(root, join.at(0.001 * i).root.norm());
    }
    EXPECT_NEAR(turn, 0.25, 1e-3);
    EXPECT_NEAR(root, 0.05, 1e-3);
}

TEST(Inertialisation, GoesTheShortWayRound) {
    const Inertialisation join(poseOf(0, 3), poseOf(0, 3), poseOf(0, -3), poseOf(0, -3), 0.01,
                               {.duration = 1});
    EXPECT_NEAR(join.at(0).turns[0].norm(), 2 * M_PI - 6, 1e-9);
}

TEST(Joined, ShowsTheSharedFrameOnceAndEndsInTheSecond) {
    const auto rig = point();
    Clip first{rig, 60, {}}, second{rig, 60, {}};
    for (int i = 0; i < 30; ++i) {
        first.frames.push_back(poseOf(0.01 * i, 0.02 * i));
        second.frames.push_back(poseOf(0.4 - 0.005 * i, 0.3));
    }
    const Clip clip = joined(first, second);
    ASSERT_EQ(clip.frameCount(), 59);
    EXPECT_EQ(clip.frames[29].root, first.frames[29].root);
    EXPECT_NE(clip.frames[30].root, second.frames[1].root);
    EXPECT_EQ(clip.frames[58].root, second.frames[29].root);
    // No step is larger than the speeds and the offset's decay explain.
    for (std::size_t i = 1; i < clip.frames.size(); ++i)
        EXPECT_LT((clip.frames[i].root - clip.frames[i - 1].root).norm(), 0.03);
}

TEST(Joined, AMotionCutInTwoComesBackUnchanged) {
    const auto rig = point();
    Clip whole{rig, 60, {}};
    for (int i = 0; i < 60; ++i)
        whole.frames.push_back(poseOf(std::sin(0.1 * i), 0.05 * i));
    Clip first = whole, second = whole;
    first.frames.resize(31);
    second.frames.erase(second.frames.begin(), second.frames.begin() + 30);
    const Clip clip = joined(first, second);
    ASSERT_EQ(clip.frameCount(), 60);
    for (std::size_t i = 0; i < 60; ++i) {
        // What remains is the change of speed within one frame: 0.6 m/s², 0.2 s, 16/81.
        EXPECT_NEAR(clip.frames[i].root.x(), whole.frames[i].root.x(), 4e-3) << i;
        EXPECT_NEAR(turnOf(clip.frames[i]), turnOf(whole.frames[i]), 1e-9);
    }
}

TEST(Joined, RefusesWhatDoesNotFit) {
    Clip clip{point(), 60, {poseOf(0, 0)}};
    EXPECT_THROW(joined(clip, Clip{clip.rig, 30, clip.frames}), Error);
    EXPECT_THROW(joined(clip, Clip{clip.rig, 60, {}}), Error);
    EXPECT_EQ(joined(clip, clip).frameCount(), 1);
}

}  // namespace
}  // namespace kumite
