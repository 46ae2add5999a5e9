// Time-warps of actions, and how two of them are brought to meet.
#include "core/synthesis/time_map.h"

#include <cmath>

#include <gtest/gtest.h>

namespace kumite {
namespace {

/// Monotone, without a jump in pace; returns the largest change of pace between tenths of a frame.
double largestPaceStep(const TimeMap& map) {
    double largest = 0;
    for (double t = 0.1; t <= map.shownFrames(); t += 0.1) {
        EXPECT_GE(map.sourceAt(t), map.sourceAt(t - 0.1)) << t;
        largest = std::max(largest, std::abs(map.paceAt(t) - map.paceAt(t - 0.1)));
        EXPECT_NEAR(map.sourceAt(map.shownAt(map.sourceAt(t))), map.sourceAt(t), 1e-6);
    }
    return largest;
}

TEST(TimeMap, AsRecordedShowsEveryFrameAtItsTime) {
    const TimeMap map(30);
    for (int i = 0; i <= 30; ++i) {
        EXPECT_DOUBLE_EQ(map.sourceAt(i), i);
        EXPECT_DOUBLE_EQ(map.paceAt(i), 1);
    }
    EXPECT_EQ(map.shownFrames(), 30);
}

TEST(TimeMap, WarpedReachesMomentAndEndWhenItShall) {
    const TimeMap map = TimeMap(40).from(0, 25, 20, 36);
    EXPECT_DOUBLE_EQ(map.sourceAt(0), 0);
    EXPECT_NEAR(map.sourceAt(20), 25, 1e-12);
    EXPECT_NEAR(map.shownAt(25), 20, 1e-6);
    EXPECT_NEAR(map.sourceAt(36), 40, 1e-12);
    EXPECT_EQ(map.shownFrames(), 36);
    EXPECT_EQ(map.sourceFrames(), 40);
    EXPECT_NEAR(map.paceAt(0), 1, 1e-12) << "goes on as the action before";
    EXPECT_NEAR(map.paceAt(36), 1, 1e-12);
    EXPECT_LT(largestPaceStep(map), 0.02);
}

TEST(TimeMap, ChangedInTheMiddleGoesOnFromThere) {
    const TimeMap first = TimeMap(40).from(0, 30, 24, 34);
    const TimeMap second = first.from(10, 30, 17, 27);
    EXPECT_NEAR(second.sourceAt(10), first.sourceAt(10), 1e-12);
    EXPECT_NEAR(second.paceAt(10), first.paceAt(10), 1e-12);
    EXPECT_NEAR(second.sourceAt(27), 30, 1e-9);
    EXPECT_NEAR(second.sourceAt(37), 40, 1e-9);
    largestPaceStep(second);
}

TEST(TimeMap, AMomentAtTheEndIsTheEnd) {
    const TimeMap map = TimeMap(20).from(0, 20, 24.5, 25);
    EXPECT_NEAR(map.sourceAt(25), 20, 1e-12);
    EXPECT_LT(map.sourceAt(24), 20);
    largestPaceStep(map);
}

TEST(TimeMap, HoldsBeyondItsEnds) {
    const TimeMap map(12);
    EXPECT_EQ(map.sourceAt(-3), 0);
    EXPECT_EQ(map.sourceAt(99), 12);
    EXPECT_EQ(map.shownAt(99), 12);
}

TEST(Meeting, ReachesTheLagWithTheLeastChangeOfBoth) {
    const Meeting meeting = meet(0.6, 0.4, 0.1, true);
    EXPECT_NEAR(0.6 * meeting.own - 0.4 * meeting.other, 0.1, 1e-12);
    EXPECT_NEAR(meeting.error, 0, 1e-12);
    // Any other pair that reaches it changes more.
    const auto change = [](double own, double other) {
        return (own - 1) * (own - 1) + (other - 1) * (other - 1);
    };
    for (double own = 0.8; own <= 1.25; own += 0.01) {
        const double other = (0.6 * own - 0.1) / 0.4;
        EXPECT_GE(change(own, other), change(meeting.own, meeting.other) - 1e-9) << own;
    }
}

TEST(Meeting, NothingChangesWhereTheLagIsAsWanted) {
    const Meeting meeting = meet(0.5, 0.45, 0.05, true);
    EXPECT_NEAR(meeting.own, 1, 1e-12);
    EXPECT_NEAR(meeting.other, 1, 1e-12);
}

TEST(Meeting, StaysWithinTheLimitsAndSaysWhatIsMissed) {
    const Meeting far = meet(0.5, 0.5, 0.9, true);
    EXPECT_EQ(far.own, kMostWarp);
    EXPECT_EQ(far.other, kLeastWarp);
    EXPECT_NEAR(far.error, 0.5 * 1.25 - 0.5 * 0.8 - 0.9, 1e-12);
    const Meeting fixed = meet(0.5, 0.5, 0.1, false);
    EXPECT_EQ(fixed.other, 1);
    EXPECT_NEAR(fixed.own, 1.2, 1e-12);
}

TEST(Meeting, OneAtItsLimitLeavesTheRestToTheOther) {
    const Meeting meeting = meet(0.3, 0.9, -0.35, true);
    EXPECT_NEAR(0.3 * meeting.own - 0.9 * meeting.other, -0.35, 1e-9);
    const Meeting short_ = meet(0.1, 1.0, -0.7, true);
    EXPECT_NEAR(0.1 * short_.own - 1.0 * short_.other, -0.7, 1e-9);
}

TEST(Meeting, APastMomentWarpsNothingOfItsOwn) {
    const Meeting meeting = meet(0.4, -0.1, 0.45, true);
    EXPECT_EQ(meeting.other, 1);
    EXPECT_NEAR(meeting.own * 0.4 + 0.1, 0.45, 0.06);
    const Meeting none = meet(0, 0, 0.2, true);
    EXPECT_EQ(none.own, 1);
    EXPECT_NEAR(none.error, -0.2, 1e-12);
}

}  // namespace
}  // namespace kumite
