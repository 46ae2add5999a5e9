// Dynamic time warping, its limits, and the mapping of frames between feature poses.
#include "core/editing/time_alignment.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/editing/time_mapping.h"
#include "core/motion/blend.h"
#include "tests/support/known_answers.h"

namespace kumite {
namespace {

std::vector<JointPoints> framesOf(const nlohmann::json& frames) {
    std::vector<JointPoints> result;
    for (const auto& frame : frames) {
        JointPoints points(3, static_cast<Eigen::Index>(frame.size()));
        for (std::size_t j = 0; j < frame.size(); ++j) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                points(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(j)) =
                    frame[j][axis];
        }
        result.push_back(points);
    }
    return result;
}

AlignmentGrid gridOf(const std::vector<double>& a, const std::vector<double>& b) {
    AlignmentGrid grid{static_cast<int>(a.size()), static_cast<int>(b.size()), {}};
    for (const double x : a) {
        for (const double y : b)
            grid.values.push_back((x - y) * (x - y));
    }
    return grid;
}

class KnownAlignment : public testing::TestWithParam<const char*> {};

TEST_P(KnownAlignment, GridAndPath) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer(GetParam());
    const auto& input = known["input"];
    const auto& expected = known["expected"];
    const AlignmentGrid grid =
        input["a"][0].is_array()
            ? alignmentGrid(framesOf(input["a"]), framesOf(input["b"]))
            : gridOf(input["a"].get<std::vector<double>>(), input["b"].get<std::vector<double>>());
    for (int i = 0; i < grid.rows; ++i) {
        for (int j = 0; j < grid.columns; ++j) {
            EXPECT_NEAR(grid.at(i, j),
                        expected["cost_grid"][std::size_t(i)][std::size_t(j)].get<double>(), 1e-9);
        }
    }
    const auto check = [&](int limit, const char* cost, const char* path) {
        const auto found = alignInTime(grid, limit);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->cost, expected[cost].get<double>(), 1e-9);
        ASSERT_EQ(found->path.size(), expected[path].size());
        for (std::size_t k = 0; k < found->path.size(); ++k) {
            EXPECT_EQ(found->path[k].a, expected[path][k][0].get<int>());
            EXPECT_EQ(found->path[k].b, expected[path][k][1].get<int>());
        }
    };
    check(input["slope_limit"], "path_cost", "path");
    check(100, "path_cost_without_slope_limit", "path_without_slope_limit");
}

INSTANTIATE_TEST_SUITE_P(Files, KnownAlignment,
                         testing::Values("dtw_figures", "dtw_line", "dtw_line_limit_3"));

/// A cloud of joints that moves smoothly.
std::vector<JointPoints> cloud(int frames, double speed = 1, std::uint32_t seed = 5) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> draw(-1, 1);
    const JointPoints base = JointPoints::NullaryExpr(3, 9, [&] { return draw(random); });
    const JointPoints phase = JointPoints::NullaryExpr(3, 9, [&] { return 3 * draw(random); });
    std::vector<JointPoints> result;
    for (int f = 0; f < frames; ++f) {
        result.push_back(base + (phase.array() + 0.12 * speed * f).sin().matrix());
    }
    return result;
}

TEST(TimeAlignment, OfAMotionWithItselfIsTheIdentity) {
    const auto motion = cloud(40);
    const auto found = alignInTime(alignmentGrid(motion, motion));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->cost, 0, 1e-12);
    ASSERT_EQ(found->path.size(), 40u);
    for (int f = 0; f < 40; ++f)
        EXPECT_EQ(found->path[std::size_t(f)], (FramePair{f, f}));
    const auto times = matchingTimes(*found);
    for (int f = 0; f < 40; ++f)
        EXPECT_NEAR(times[std::size_t(f)], f, 1e-12);
}

TEST(TimeAlignment, DoesNotSeePlaceAndHeading) {
    const auto motion = cloud(20);
    auto other = motion;
    for (std::size_t f = 0; f < other.size(); ++f) {
        const double yaw = 0.3 * static_cast<double>(f);
        other[f] = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()).toRotationMatrix() * other[f];
        other[f].colwise() += Eigen::Vector3d(yaw, 0, 2 - yaw);
    }
    const AlignmentGrid grid = alignmentGrid(motion, other);
    for (int f = 0; f < 20; ++f)
        EXPECT_NEAR(grid.at(f, f), 0, 1e-12);
    // A cell is what the shared alignment of points leaves over.
    for (const auto& [i, j] : {std::pair(0, 7), std::pair(13, 4)}) {
        std::vector<Eigen::Vector3d> a, b;
        for (int k = 0; k < 9; ++k) {
            a.push_back(motion[std::size_t(i)].col(k));
            b.push_back(other[std::size_t(j)].col(k));
        }
        const GroundTransform transform = groundAlignment(b, a);
        double sum = 0;
        for (std::size_t k = 0; k < 9; ++k)
            sum += (a[k] - transform * b[k]).squaredNorm();
        EXPECT_NEAR(grid.at(i, j), sum, 1e-9);
    }
}

TEST(TimeAlignment, KeepsItsSlopeLimit) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> draw(0, 1);
    for (int limit = 1; limit <= 3; ++limit) {
        AlignmentGrid grid{30, 30 + 10 * limit, {}};
        for (int i = 0; i < grid.rows * grid.columns; ++i)
            grid.values.push_back(draw(random));
        const auto found = alignInTime(grid, limit);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->path.front(), (FramePair{0, 0}));
        EXPECT_EQ(found->path.back(), (FramePair{grid.rows - 1, grid.columns - 1}));
        int down = 0, right = 0;
        for (std::size_t k = 1; k < found->path.size(); ++k) {
            const int di = found->path[k].a - found->path[k - 1].a;
            const int dj = found->path[k].b - found->path[k - 1].b;
            EXPECT_TRUE((di == 0 || di == 1) && (dj == 0 || dj == 1) && di + dj > 0);
            down = di == 1 && dj == 0 ? down + 1 : 0;
            right = di == 0 && dj == 1 ? right + 1 : 0;
            EXPECT_LE(down, limit);
            EXPECT_LE(right, limit);
        }
    }
}

TEST(TimeAlignment, SaysWhereNoPathIs) {
    const auto longOne = cloud(40), shortOne = cloud(10);
    EXPECT_FALSE(alignInTime(alignmentGrid(shortOne, longOne), 2)) << "four times as long";
    EXPECT_TRUE(alignInTime(alignmentGrid(shortOne, longOne), 4));
    EXPECT_FALSE(alignInTime(AlignmentGrid{}, 2));
    const auto one = alignInTime(alignmentGrid(cloud(1), cloud(1)));
    ASSERT_TRUE(one);
    EXPECT_EQ(matchingTimes(*one), std::vector<double>{0});
}

TEST(TimeAlignment, OneFrameBesideManyWithTheLimitThatItNeeds) {
    const AlignmentGrid grid = gridOf({1}, std::vector<double>(300, 1.0));
    EXPECT_FALSE(alignInTime(grid, 298));
    const auto found = alignInTime(grid, 299);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->path.size(), 300u);
}

TEST(TimeAlignment, FindsTheTimesOfASlowerMotion) {
    const auto fast = cloud(40, 1.5), slow = cloud(60);
    const auto found = alignInTime(alignmentGrid(fast, slow));
    ASSERT_TRUE(found);
    const auto times = matchingTimes(*found);
    ASSERT_EQ(times.size(), 40u);
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), 59);
    for (std::size_t i = 1; i < times.size(); ++i)
        EXPECT_GE(times[i], times[i - 1]);
    for (std::size_t i = 5; i < 35; ++i)
        EXPECT_NEAR(times[i], 1.5 * static_cast<double>(i), 1.5);
}

TEST(TimeMapping, PassesTheFeaturePosesAndNeverRunsBackward) {
    // The paper's figure 7: frames 2, 5 and 18 belong to frames 7, 9 and 16.
    const TimeMapping map({2, 5, 18}, {7, 9, 16});
    EXPECT_DOUBLE_EQ(map(2), 7);
    EXPECT_DOUBLE_EQ(map(5), 9);
    EXPECT_DOUBLE_EQ(map(18), 16);
    double before = map(-3);
    for (double t = -2.9; t < 25; t += 0.1) {
        EXPECT_GT(map(t), before);
        before = map(t);
    }
    // No kink at the feature pose in the middle, nor where the curve ends.
    for (const double t : {2.0, 5.0, 18.0})
        EXPECT_NEAR((map(t + 1e-6) - map(t)) / 1e-6, (map(t) - map(t - 1e-6)) / 1e-6, 1e-4) << t;
    const auto points = map.controlPoints(0);
    ASSERT_EQ(points.size(), 4u);
    EXPECT_DOUBLE_EQ(points[1].query, 3);
    EXPECT_DOUBLE_EQ(points[3].clip, 9);
}

TEST(TimeMapping, WithAbruptChangesOfSpeed) {
    const TimeMapping map({0, 10, 11, 40}, {0, 1, 30, 31});
    double before = map(0);
    for (double t = 0.05; t < 40; t += 0.05) {
        EXPECT_GE(map(t), before) << t;
        before = map(t);
    }
}

TEST(TimeMapping, OneFeaturePoseShiftsAndWrongOnesAreRefused) {
    const TimeMapping map({4}, {10});
    EXPECT_DOUBLE_EQ(map(0), 6);
    EXPECT_DOUBLE_EQ(map(9), 15);
    EXPECT_THROW(TimeMapping({}, {}), Error);
    EXPECT_THROW(TimeMapping({1, 2}, {1}), Error);
    EXPECT_THROW(TimeMapping({1, 1}, {1, 2}), Error) << "two keys in one frame";
    EXPECT_THROW(TimeMapping({1, 2}, {2, 1}), Error) << "out of order";
}

}  // namespace
}  // namespace kumite
