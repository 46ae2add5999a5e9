// Where an action that begins stands: the identities of method A9.
#include "core/synthesis/action_placement.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kumite {
namespace {

void expectNear(const Station& a, const Station& b, double tolerance = 1e-12) {
    EXPECT_NEAR((a.root - b.root).norm(), 0, tolerance);
    EXPECT_NEAR(std::remainder(a.yaw - b.yaw, 2 * std::numbers::pi), 0, tolerance);
}

/// A recorded way: a step ahead with a turn.
Station recorded(double phase) {
    return {{1.0 + 0.3 * phase, -2.0 + 0.8 * phase * phase}, 0.4 + 0.5 * phase};
}

const GroundFrame kRecordedFrame{{1.5, -1.0}, 0.7};
const GroundFrame kFrameNow{{-3.0, 2.0}, -2.9};

TEST(ActionPlacement, BetweenFramesTakesOneToTheOther) {
    const GroundTransform t = between(kRecordedFrame, kFrameNow);
    expectNear(moved(Station{kRecordedFrame.origin, kRecordedFrame.yaw}, t),
               Station{kFrameNow.origin, kFrameNow.yaw});
    // What was one metre ahead of the mid-point still is.
    const Eigen::Vector2d point =
        kRecordedFrame.origin + Eigen::Vector2d(std::sin(0.7), std::cos(0.7));
    const Eigen::Vector2d there = moved(Station{point, 0}, t).root;
    EXPECT_NEAR((kFrameNow.toLocal(there) - Eigen::Vector2d(0, 1)).norm(), 0, 1e-12);
}

TEST(ActionPlacement, BeginsWhereItsFighterStandsAndGoesHalfWayBack) {
    const GroundTransform wanted = between(kRecordedFrame, kFrameNow);
    const Station shown{{-2.7, 2.5}, 3.0};
    const ActionPlacement placement(wanted, recorded(0), shown);
    expectNear(placement.at(recorded(0), 0), shown);

    const Station there = moved(recorded(1), wanted);
    const GroundTransform rigid = between(recorded(0), shown);
    const Station carried = moved(recorded(1), rigid);
    const Station end = placement.at(recorded(1), 1);
    EXPECT_NEAR((end.root - 0.5 * (there.root + carried.root)).norm(), 0, 1e-12);
    EXPECT_NEAR(std::remainder(end.yaw - there.yaw, 2 * std::numbers::pi),
                0.5 * std::remainder(carried.yaw - there.yaw, 2 * std::numbers::pi), 1e-12);
}

TEST(ActionPlacement, NothingToCorrectIsNotCorrected) {
    const GroundTransform wanted = between(kRecordedFrame, kFrameNow);
    const ActionPlacement placement(wanted, recorded(0), moved(recorded(0), wanted));
    EXPECT_NEAR(placement.distance(), 0, 1e-12);
    for (double phase = 0; phase <= 1; phase += 0.25)
        expectNear(placement.at(recorded(phase), phase), moved(recorded(phase), wanted));
}

TEST(ActionPlacement, TheSameFrameAgainIsTheRecording) {
    const ActionPlacement placement(between(kRecordedFrame, kRecordedFrame), recorded(0),
                                    recorded(0));
    for (double phase = 0; phase <= 1; phase += 0.25)
        expectNear(placement.at(recorded(phase), phase), recorded(phase));
}

TEST(ActionPlacement, ATurnIsCorrectedTheShortWayRound) {
    const GroundTransform wanted = between(kRecordedFrame, kFrameNow);
    Station shown = moved(recorded(0), wanted);
    shown.yaw += 0.3 + 4 * std::numbers::pi;
    const ActionPlacement placement(wanted, recorded(0), shown);
    EXPECT_NEAR(placement.turn(), 0.3, 1e-9);
}

TEST(ActionPlacement, TheReleaseHasNoJumpInSpeed) {
    const GroundTransform wanted = between(kRecordedFrame, kFrameNow);
    const ActionPlacement placement(wanted, recorded(0), Station{{-2.7, 2.5}, 3.0});
    const auto drift = [&](double phase) {
        return placement.at(recorded(0.5), phase).root;  // a still pose: the release alone
    };
    const double h = 1e-4;
    EXPECT_NEAR((drift(h) - drift(0)).norm() / h, 0, 1e-3);
    EXPECT_NEAR((drift(1) - drift(1 - h)).norm() / h, 0, 1e-3);
}

TEST(ActionPlacement, SteeringShiftsWhatFollows) {
    const GroundTransform wanted = between(kRecordedFrame, kFrameNow);
    const Station shown{{-2.7, 2.5}, 3.0};
    ActionPlacement placement(wanted, recorded(0), shown);
    const Station before = placement.at(recorded(0.5), 0.5);
    placement.steer({0.2, -0.1}, 0, 0.5);
    expectNear(placement.at(recorded(0), 0), shown);
    const Station after = placement.at(recorded(0.5), 0.5);
    EXPECT_NEAR((after.root - before.root - Eigen::Vector2d(0.2, -0.1)).norm(), 0, 1e-12);
    EXPECT_EQ(after.yaw, before.yaw);
}

}  // namespace
}  // namespace kumite
