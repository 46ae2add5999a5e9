// The critical joint's angles get the mean and deviation of the query's.
#include "core/editing/critical_joint.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/known_answers.h"

namespace kumite {
namespace {

AngleTrack trackOf(const nlohmann::json& rows) {
    AngleTrack track;
    for (const auto& row : rows) {
        Eigen::Vector3d angles = Eigen::Vector3d::Zero();
        for (std::size_t axis = 0; axis < row.size(); ++axis)
            angles[static_cast<Eigen::Index>(axis)] = row[axis];
        track.push_back(angles);
    }
    return track;
}

TEST(CriticalJoint, KnownAnswers) {
    KUMITE_NEEDS_DATA();
    const auto known = test::knownAnswer("critical_joint");
    ASSERT_GT(known["items"].size(), 4u);
    for (const auto& item : known["items"]) {
        const std::string what = item["what"];
        const auto& expected = item["expected"];
        const AngleTrack r = trackOf(item["input"]["R"]), q = trackOf(item["input"]["query"]);
        const AngleTrack s = adjusted(r, q);
        ASSERT_EQ(s.size(), expected["S"].size()) << what;
        const auto axes = static_cast<Eigen::Index>(expected["S"][0].size());
        const AngleStatistics ofR = statisticsOf(r), ofQ = statisticsOf(q);
        for (Eigen::Index axis = 0; axis < axes; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            EXPECT_NEAR(ofR.mean[axis], expected["M_R"][a].get<double>(), 1e-9) << what;
            EXPECT_NEAR(ofR.deviation[axis], expected["sigma_R"][a].get<double>(), 1e-9) << what;
            EXPECT_NEAR(ofQ.mean[axis], expected["M_Q"][a].get<double>(), 1e-9) << what;
            EXPECT_NEAR(ofQ.deviation[axis], expected["sigma_Q"][a].get<double>(), 1e-9) << what;
            for (std::size_t i = 0; i < s.size(); ++i) {
                const double difference = s[i][axis] - expected["S"][i][a].get<double>();
                EXPECT_NEAR(std::remainder(difference, 2 * std::numbers::pi), 0, 1e-9) << what;
            }
        }
    }
}

AngleTrack waves(int frames, std::uint32_t seed, double size) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> draw(-1, 1);
    const Eigen::Vector3d middle = 0.5 * Eigen::Vector3d(draw(random), draw(random), draw(random));
    const Eigen::Vector3d phase = 3 * Eigen::Vector3d(draw(random), draw(random), draw(random));
    AngleTrack track;
    for (int f = 0; f < frames; ++f)
        track.push_back(middle + size * (phase.array() + 0.11 * f).sin().matrix());
    return track;
}

TEST(CriticalJoint, TakesOverTheStatisticsOfTheQuery) {
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
        const AngleTrack r = waves(50, seed, 0.4), q = waves(80, 100 + seed, 0.1);
        const AngleStatistics after = statisticsOf(adjusted(r, q)), wanted = statisticsOf(q);
        EXPECT_NEAR((after.mean - wanted.mean).norm(), 0, 1e-12);
        EXPECT_NEAR((after.deviation - wanted.deviation).norm(), 0, 1e-12);
    }
}

TEST(CriticalJoint, AdjustedToItselfStaysAsItIs) {
    const AngleTrack r = waves(50, 3, 0.4);
    const AngleTrack s = adjusted(r, r);
    for (std::size_t i = 0; i < r.size(); ++i)
        EXPECT_NEAR((s[i] - r[i]).norm(), 0, 1e-12);
}

TEST(CriticalJoint, WithoutSpreadTheMeanStands) {
    const AngleTrack still(10, Eigen::Vector3d(0.3, -0.2, 0.1)), q = waves(10, 2, 0.3);
    for (const Eigen::Vector3d& angles : adjusted(still, q))
        EXPECT_NEAR((angles - statisticsOf(q).mean).norm(), 0, 1e-12);
    EXPECT_TRUE(adjusted({}, q).empty());
}

TEST(CriticalJoint, RotationsThroughAnglesAndBack) {
    const AngleTrack track = waves(60, 9, 0.5);
    for (const std::array<int, 3> order :
         {std::array{2, 0, 1}, std::array{0, 1, 2}, std::array{1, 2, 0}}) {
        std::vector<Eigen::Quaterniond> turns;
        for (const Eigen::Vector3d& angles : track)
            turns.push_back(turnOf(angles, order));
        const AngleTrack back = anglesOf(turns, order);
        for (std::size_t i = 0; i < track.size(); ++i)
            EXPECT_NEAR((back[i] - track[i]).norm(), 0, 1e-9);
    }
}

TEST(CriticalJoint, AnAdjustedJointStaysClearOfGimbalLock) {
    // An arm that swings through ±90° about y: with y in the middle its angles would jump.
    std::vector<Eigen::Quaterniond> r, q;
    for (int f = 0; f < 60; ++f) {
        const double a = 1.2 + 0.6 * std::sin(0.1 * f);
        r.emplace_back(Eigen::AngleAxisd(a, Eigen::Vector3d::UnitY()));
        q.emplace_back(Eigen::AngleAxisd(0.5 * a, Eigen::Vector3d::UnitY()));
    }
    EXPECT_NE(safestOrder(r, q)[1], 1);
    const JointAdjustment done = adjustJoint(r, q);
    EXPECT_NEAR((done.assembled.mean - done.query.mean).norm(), 0, 1e-9);
    EXPECT_NEAR((done.assembled.deviation - done.query.deviation).norm(), 0, 1e-9);
    EXPECT_GT((done.retrieved.mean - done.query.mean).norm(), 0.3);
    for (std::size_t f = 0; f < r.size(); ++f)
        EXPECT_NEAR(r[f].angularDistance(q[f]), 0, 1e-6) << "the same course, half as large";
}

}  // namespace
}  // namespace kumite
