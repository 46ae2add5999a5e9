// The made bout's plan: its law, the path of the centre of mass, footwork.
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "core/demo/choreography.h"
#include "core/demo/com_path.h"
#include "core/demo/com_plan.h"
#include "core/demo/footwork.h"
#include "core/demo/strikes.h"

namespace kumite::demo {
namespace {

std::vector<ComKnot> knotsAt(const std::vector<double>& times) {
    std::vector<ComKnot> knots(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        knots[i].time = times[i];
        knots[i].position = Eigen::Vector3d(0.1 * times[i], 0.95, 0);
        knots[i].force = i == 0 || i + 1 == times.size() ? 1.0 : 0.8;
    }
    return knots;
}

/// Local minima of the force strictly between two times.
int minimaBetween(const ComPath& path, double from, double to) {
    int minima = 0;
    constexpr double kStep = 0.004;
    for (double t = from + 2 * kStep; t < to - 2 * kStep; t += kStep) {
        const double here = path.force(t).norm();
        minima +=
            here < path.force(t - kStep).norm() && here < path.force(t + kStep).norm() ? 1 : 0;
    }
    return minima;
}

TEST(DemoComPath, PassesItsKnotsAndItsForceIsItsSecondDerivative) {
    auto knots = knotsAt({0, 0.5, 1.1, 1.6, 2.5});
    knots[2].position.y() = 1.0;  // up by 5 cm and down again
    const auto wanted = knots;
    const ComPath path(knots, std::vector<std::optional<ForceDip>>(4));
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
        EXPECT_LT((path.position(wanted[i].time) - wanted[i].position).norm(), 1e-9) << i;
        EXPECT_LT((path.velocity(wanted[i].time) - wanted[i].velocity).norm(), 1e-9) << i;
    }
    constexpr double h = 1e-4;
    for (double t = 0.03; t < 2.4; t += 0.0717) {
        const Eigen::Vector3d acceleration =
            (path.position(t + h) - 2 * path.position(t) + path.position(t - h)) / (h * h);
        const Eigen::Vector3d force = acceleration / kGravity + Eigen::Vector3d(0, 1, 0);
        EXPECT_LT((path.force(t) - force).norm(), 1e-4) << t;
    }
}

TEST(DemoComPath, HasOnePeakPerActionAndAMinimumAtEachKnot) {
    const std::vector<double> times = {0, 0.45, 0.95, 1.75, 2.2, 3.3};
    auto knots = knotsAt(times);
    for (ComKnot& knot : knots)
        knot.position.x() = 0;
    const ComPath path(knots, std::vector<std::optional<ForceDip>>(5));
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        EXPECT_EQ(minimaBetween(path, times[i] + 0.02, times[i + 1] - 0.02), 0) << i;
    }
    for (std::size_t i = 1; i + 1 < times.size(); ++i) {
        EXPECT_EQ(minimaBetween(path, times[i] - 0.03, times[i] + 0.03), 1) << i;
    }
}

TEST(DemoComPath, ADipCutsItsActionInTwo) {
    auto knots = knotsAt({0, 0.5, 1.6, 2.1});
    std::vector<std::optional<ForceDip>> dips(3);
    dips[1] = ForceDip{1.05, 0.33, 0.17};
    const ComPath path(knots, dips);
    EXPECT_EQ(minimaBetween(path, 0.53, 1.57), 1);
    EXPECT_LT((path.position(1.6) - Eigen::Vector3d(0.16, 0.95, 0)).norm(), 1e-9);
}

TEST(DemoComPath, FlightIsBallistic) {
    auto knots = knotsAt({0, 0.6, 1.2, 1.8});
    knots[2].flight = 0.3;
    knots[2].position.y() = 1.15;
    const ComPath path(knots, std::vector<std::optional<ForceDip>>(3));
    for (const double t : {1.06, 1.2, 1.34})
        EXPECT_LT(path.force(t).norm(), 1e-9) << t;
    EXPECT_NEAR(path.position(1.2).y() - path.position(1.35).y(), kGravity * 0.15 * 0.15 / 2, 1e-6);
}

TEST(DemoProcess, EveryRowIsALawAndEverySuccessorMayFollow) {
    const Temper temper = drawTemper(1, 1);
    const auto& all = techniques();
    for (const Technique& own : all) {
        for (const Technique& opponent : all) {
            for (const Range range : {Range::Near, Range::Middle, Range::Far}) {
                const auto law = nextTechnique(temper, own, opponent, range);
                double sum = 0;
                for (std::size_t i = 0; i < law.size(); ++i) {
                    sum += law[i];
                    EXPECT_TRUE(law[i] == 0 || mayFollow(own, all[i])) << own.label();
                }
                EXPECT_NEAR(sum, 1.0, 1e-12) << own.label() << " " << opponent.label();
            }
        }
    }
}

TEST(DemoProcess, FrequenciesConvergeToTheLaw) {
    const auto scripts = choreograph(3, 6 * 3600);
    const auto& all = techniques();
    for (const Script& script : scripts) {
        std::map<std::tuple<int, int, int>, std::vector<int>> counts;
        for (const PlannedAction& action : script.actions) {
            if (!action.choice) continue;
            const Choice& c = *action.choice;
            auto& row = counts[{c.own, c.opponent, static_cast<int>(c.range)}];
            row.resize(all.size());
            ++row[static_cast<std::size_t>(indexOf(action.technique))];
        }
        int rows = 0;
        double surprise = 0;  // sum of χ²/degrees of freedom
        for (const auto& [key, row] : counts) {
            const auto [own, opponent, range] = key;
            const auto law =
                nextTechnique(script.temper, all[static_cast<std::size_t>(own)],
                              all[static_cast<std::size_t>(opponent)], static_cast<Range>(range));
            int n = 0;
            for (const int count : row)
                n += count;
            if (n < 300) continue;
            double chi = 0;
            int cells = 0;
            for (std::size_t i = 0; i < law.size(); ++i) {
                const double expected = n * law[i];
                EXPECT_TRUE(law[i] > 0 || row[i] == 0) << all[i].label();
                // Five standard deviations, over a few thousand cells.
                EXPECT_LE(std::abs(row[i] - expected), 5 * std::sqrt(expected) + 3)
                    << all[static_cast<std::size_t>(own)].label() << " > " << all[i].label();
                if (expected < 5) continue;
                chi += (row[i] - expected) * (row[i] - expected) / expected;
                ++cells;
            }
            if (cells < 2) continue;
            surprise += chi / (cells - 1);
            ++rows;
        }
        EXPECT_GT(rows, 15);
        EXPECT_NEAR(surprise / rows, 1.0, 0.35);
    }
}

TEST(DemoChoreography, AnswersComeAHumanReactionTimeAfterTheAttack) {
    const auto scripts = choreograph(2, 1800);
    std::vector<double> lags;
    for (std::size_t i = 0; i < 2; ++i) {
        for (const PlannedAction& answer : scripts[i].actions) {
            if (!answer.technique.isOthers() || !isDefence(answer.manner)) continue;
            const Script& opponent = scripts[1 - i];
            const PlannedAction& attack =
                opponent.actions[static_cast<std::size_t>(opponent.actionAt(answer.begin))];
            const bool isAttack = attack.technique.punches() || attack.technique.kicks();
            if (isAttack) lags.push_back(answer.begin - attack.begin);
        }
    }
    ASSERT_GT(lags.size(), 200u);
    std::sort(lags.begin(), lags.end());
    const double median = lags[lags.size() / 2];
    EXPECT_GT(median, 0.16);
    EXPECT_LT(median, 0.30);
    EXPECT_GT(lags[9 * lags.size() / 10] - lags[lags.size() / 10], 0.06);  // with spread
}

TEST(DemoChoreography, KicksAreBegunFromFartherAwayThanPunches) {
    const auto scripts = choreograph(4, 3600);
    std::map<bool, std::pair<double, int>> distance;  // by kick: sum and count
    for (std::size_t i = 0; i < 2; ++i) {
        for (const PlannedAction& action : scripts[i].actions) {
            const bool kick = action.technique.kicks();
            if (!kick && !action.technique.punches()) continue;
            auto& [sum, count] = distance[kick];
            sum += (scripts[0].stationAt(action.begin) - scripts[1].stationAt(action.begin)).norm();
            ++count;
        }
    }
    const double punches = distance[false].first / distance[false].second;
    const double kicks = distance[true].first / distance[true].second;
    EXPECT_GT(kicks, punches + 0.05);
}

TEST(DemoChoreography, AFewMinutesHoldEveryTechniqueAndEveryFootstep) {
    const auto scripts = choreograph(1, 1800);
    std::set<std::string> labels;
    std::set<std::string> moves;
    for (std::size_t i = 0; i < 2; ++i) {
        std::vector<double> boundaries = {0};
        for (const PlannedAction& action : scripts[i].actions) {
            labels.insert(action.technique.label());
            boundaries.push_back(action.end);
        }
        const Feet feet = planFeet(scripts[i], scripts[1 - i],
                                   planCentreOfMass(scripts[i], scripts[1 - i], 0.97, i), i);
        for (const std::string& move : movesOf(feet, boundaries))
            moves.insert(move);
    }
    EXPECT_EQ(labels.size(), techniques().size());
    EXPECT_EQ(moves.size(), 9u);
}

TEST(DemoFootwork, FeetNeverSwingThroughEachOther) {
    const auto scripts = choreograph(5, 600);
    const Feet feet =
        planFeet(scripts[0], scripts[1], planCentreOfMass(scripts[0], scripts[1], 0.97, 1), 1);
    for (const FootTrack& foot : feet) {
        ASSERT_EQ(foot.swings.size() + 1, foot.plants.size());
        for (std::size_t i = 0; i < foot.plants.size(); ++i) {
            EXPECT_LT(foot.plants[i].begin, foot.plants[i].end) << i;
            EXPECT_TRUE(i == 0 || foot.plants[i - 1].end < foot.plants[i].begin) << i;
        }
    }
    // Both are up in hops and jumps only.
    for (std::size_t i = 0; i < feet[0].swings.size(); ++i) {
        const double middle = (feet[0].plants[i].end + feet[0].plants[i + 1].begin) / 2;
        EXPECT_TRUE(feet[0].swings[i] != Swing::Step || feet[1].onGround(middle)) << middle;
    }
}

TEST(DemoFootwork, MoveFollowsTheRuleOfTheMethod) {
    // Right foot up in 1…1.4, left in 3…3.4, both in 5…5.2 (method A5, worked out by hand).
    Feet feet;
    feet[0].plants = {{0, 3, {0.1, 0}, 0}, {3.4, 5, {0.1, 0}, 0}, {5.2, 9, {0.1, 0}, 0}};
    feet[0].swings = {Swing::Step, Swing::Hop};
    feet[1].plants = {{0, 1, {-0.1, 0}, 0}, {1.4, 5, {-0.1, 0}, 0}, {5.2, 9, {-0.1, 0}, 0}};
    feet[1].swings = {Swing::Step, Swing::Hop};
    // 0: nearest single stance is L. 1.2: L. 2.2: halfway between both, the later counts: R.
    // 3.2: R. 4.5: R, also before a flight. 5.1: F. 6: R across the flight.
    const std::vector<double> boundaries = {0, 1.2, 2.1, 2.2, 3.2, 4.5, 5.1, 6};
    const std::vector<std::string> expected = {"L-L", "L-L", "L-R", "R-R", "R-R", "R-F", "F-R"};
    EXPECT_EQ(movesOf(feet, boundaries), expected);
}

TEST(DemoFootwork, WithoutAnySingleStanceMoveIsLeft) {
    Feet feet;
    feet[0].plants = {{0, 9, {0, 0}, 0}};
    feet[1].plants = {{0, 9, {0, 0}, 0}};
    EXPECT_EQ(movesOf(feet, std::vector<double>{0, 1}), std::vector<std::string>{"L-L"});
}

TEST(DemoRandom, NoiseIsSmoothBoundedAndIndependentOfTheRate) {
    double most = 0;
    for (int i = 0; i < 4000; ++i) {
        const double t = i * 0.001;
        const double here = smoothNoise(7, 3, t, 5);
        most = std::max(most, std::abs(here));
        EXPECT_LT(std::abs(smoothNoise(7, 3, t + 1e-5, 5) - here), 1e-3);
    }
    EXPECT_LE(most, 1.0);
    EXPECT_GT(most, 0.3);
    EXPECT_NE(smoothNoise(7, 3, 0.3, 5), smoothNoise(8, 3, 0.3, 5));
    EXPECT_NE(smoothNoise(7, 3, 0.3, 5), smoothNoise(7, 4, 0.3, 5));
}

}  // namespace
}  // namespace kumite::demo
