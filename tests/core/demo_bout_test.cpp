// The made bout as files and motion, judged by the detector and by the truth.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#ifdef __linux__
#include <sched.h>
#endif

#include "core/demo/fight.h"
#include "core/demo/suit.h"
#include "core/formats/bvh.h"
#include "core/motion/survey.h"
#include "core/project/demo_bout.h"
#include "core/project/project_file.h"
#include "tests/support/bout_figures.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using demo::DemoBout;
using demo::makeDemoBout;
using nlohmann::json;

std::string textOf(const DemoBout& bout) {
    std::string text = demo::truthText(bout.truth);
    for (const Motion& motion : bout.motions) {
        text += bvhText(motion, motion.frames(), motion.frameTime);
    }
    return text;
}

/// A bout of a minute, written, read back and analysed once for all tests.
struct Made {
    test::TemporaryFolder folder;
    Project project;
    Analysis analysis;
    json truth;
};

const Made& made() {
    static const Made* one = [] {
        auto* m = new Made;
        const DemoFiles files = writeDemoBout({90, 60, 1}, m->folder.path());
        m->project = loadProject(files.project()).project;
        m->analysis = analyse(m->project);
        std::ifstream file(files.truth());
        m->truth = json::parse(file);
        return m;
    }();
    return *one;
}

TEST(DemoBout, TheSameSeedMakesTheSameBytes) {
    const std::string first = textOf(makeDemoBout({12, 60, 5}));
    EXPECT_EQ(first, textOf(makeDemoBout({12, 60, 5})));
    EXPECT_NE(first, textOf(makeDemoBout({12, 60, 6})));
}

#ifdef __linux__
TEST(DemoBout, TheNumberOfThreadsChangesNothing) {
    const std::string many = textOf(makeDemoBout({20, 60, 2}));
    cpu_set_t before;
    ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
        if (!CPU_ISSET(cpu, &before)) continue;
        CPU_SET(cpu, &one);
        break;
    }
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    const std::string alone = textOf(makeDemoBout({20, 60, 2}));
    sched_setaffinity(0, sizeof before, &before);
    EXPECT_EQ(many, alone);
}
#endif

TEST(DemoBout, AnotherRateIsTheSameFight) {
    const DemoBout slow = makeDemoBout({15, 30, 3});
    const DemoBout fast = makeDemoBout({15, 120, 3});
    for (std::size_t p = 0; p < 2; ++p) {
        const auto& a = slow.truth.players[p];
        const auto& b = fast.truth.players[p];
        ASSERT_EQ(a.boundaries.size(), b.boundaries.size());
        for (std::size_t i = 0; i + 1 < a.boundaries.size(); ++i) {
            EXPECT_NEAR(a.boundaries[i] / 30.0, b.boundaries[i] / 120.0, 1 / 45.0) << i;
            EXPECT_EQ(a.actions[i].label, b.actions[i].label) << i;
        }
        const SpaceConvention space{p == 0 ? 0.01 : 0.0254, UpAxis::Y};
        const auto x = forwardKinematics(slow.motions[p], slow.motions[p].frames(), space);
        const auto y = forwardKinematics(fast.motions[p], fast.motions[p].frames(), space);
        // The bouts end a little apart (the last frame is not at the same time): look before that.
        for (int f = 0; f < 12 * 30; ++f) {
            for (int joint = 0; joint < x.jointCount; ++joint) {
                ASSERT_LT((x.at(f, joint) - y.at(4 * f, joint)).norm(), 0.001f)
                    << "frame " << f << " joint " << joint;
            }
        }
    }
}

TEST(DemoBout, AnyLengthAndRateIsAValidFile) {
    for (const auto& [seconds, rate] :
         {std::pair{1.0, 24.0}, {1.0, 240.0}, {2.3, 59.94}, {7.0, 100.0}}) {
        const DemoBout bout = makeDemoBout({seconds, rate, 9});
        const int frames = static_cast<int>(std::lround(seconds * rate));
        for (std::size_t p = 0; p < 2; ++p) {
            const Motion& motion = bout.motions[p];
            EXPECT_EQ(motion.frameCount, frames);
            const Recording read =
                readBvh(bvhText(motion, motion.frames(), motion.frameTime), "made");
            EXPECT_TRUE(read.findings.empty());
            EXPECT_EQ(bout.truth.players[p].boundaries.front(), 0);
            EXPECT_EQ(bout.truth.players[p].boundaries.back(), frames - 1);
        }
    }
}

TEST(DemoBout, RefusesLengthsAndRatesOutOfRange) {
    EXPECT_THROW(makeDemoBout({0.5, 60, 1}), Error);
    EXPECT_THROW(makeDemoBout({60, 23, 1}), Error);
    EXPECT_THROW(makeDemoBout({60, 241, 1}), Error);
    EXPECT_THROW(makeDemoBout({std::nan(""), 60, 1}), Error);
}

TEST(DemoBout, TwoSuitsDifferAndAreUnderstoodWithoutAHand) {
    const Take& take = made().project.takes[0];
    EXPECT_NEAR(take.fighters[0].space.metresPerUnit, 0.01, 1e-9);
    EXPECT_NEAR(take.fighters[1].space.metresPerUnit, 0.0254, 1e-9);
    for (const Fighter& fighter : take.fighters) {
        EXPECT_EQ(fighter.rate, 60);
        EXPECT_EQ(fighter.frames, (FrameRange{0, 90 * 60}));
    }
    EXPECT_EQ(take.fighters[0].roles.count(), kRoleCount);
    EXPECT_EQ(take.fighters[1].roles.missing(), std::vector<Role>{});
    const Skeleton& a = *take.fighters[0].motion->skeleton;
    const Skeleton& b = *take.fighters[1].motion->skeleton;
    EXPECT_NE(a.jointCount(), b.jointCount());
    EXPECT_NE(a.joints[0].channels, b.joints[0].channels);
    for (const Joint& joint : b.joints)
        EXPECT_LT(a.find(joint.name), 0) << joint.name;
}

TEST(DemoBout, TheDetectorFindsThePlannedBoundaries) {
    int spurious = 0;
    int found = 0;
    for (std::size_t p = 0; p < 2; ++p) {
        const auto cut =
            test::compareCut(made().analysis.takes[0][p], made().truth["players"][p], 60);
        EXPECT_GE(cut.f1(), 0.97) << p;
        EXPECT_EQ(cut.spuriousInTop, cut.spurious) << p;
        spurious += cut.spurious;
        found += cut.found;
    }
    EXPECT_GE(spurious, found / 100);
    EXPECT_LE(spurious, 3 * found / 100);
}

TEST(DemoBout, MotionObeysMechanics) {
    for (const FighterAnalysis& fighter : made().analysis.takes[0]) {
        const auto m = test::measureMotion(fighter);
        EXPECT_NEAR(m.meanVerticalForce, 1.0, 0.005);
        EXPECT_LE(m.skate, 0.05);
        EXPECT_LE(m.deepestUnderFloor, 0.05);
        EXPECT_GE(m.sharpestKnee, 0.6);  // radians: a heel does not go through a thigh
        EXPECT_LT(m.straightestKnee, std::numbers::pi - 0.02);
        EXPECT_GE(m.sharpestElbow, 0.6);
        EXPECT_LT(m.straightestElbow, std::numbers::pi - 0.02);
        EXPECT_LT(m.fastestHand, 12);
        EXPECT_LT(m.fastestFoot, 20);
    }
}

TEST(DemoBout, FlightsHaveNoForceAndPlantedFeetStay) {
    int flights = 0;
    int planted = 0;
    int moved = 0;
    for (std::size_t p = 0; p < 2; ++p) {
        const FighterAnalysis& fighter = made().analysis.takes[0][p];
        const json& player = made().truth["players"][p];
        for (const json& action : player["actions"]) {
            if (action["label"]["jump"] != "up") continue;
            ++flights;
            EXPECT_LT(fighter.force->force.curve[action["end"].get<std::size_t>()], 0.1);
        }
        for (const bool left : {true, false}) {
            const int toe = *fighter.input.roles[left ? Role::LeftToe : Role::RightToe];
            for (const json& contact : player["contacts"][left ? "left" : "right"]) {
                const int begin = contact[0].get<int>() + 1;
                const int end = std::min(contact[1].get<int>() - 1, fighter.frameCount());
                for (int f = begin; f < end; ++f) {
                    const Eigen::Vector3f way = fighter.motion->positions.at(f, toe) -
                                                fighter.motion->positions.at(begin, toe);
                    ++planted;
                    moved += way.norm() > 0.02f;
                    ASSERT_LT(way.norm(), 0.2f) << "player " << p << " frame " << f;
                }
            }
        }
    }
    EXPECT_GT(flights, 0);
    // A leg that is too short for where the body goes drags its toe.
    EXPECT_LT(moved, 3 * planted / 100);
}

TEST(DemoBout, TruthAgreesWithItself) {
    for (std::size_t p = 0; p < 2; ++p) {
        const json& actions = made().truth["players"][p]["actions"];
        const json& others = made().truth["players"][1 - p]["actions"];
        const json& boundaries = made().truth["players"][p]["boundaries"];
        ASSERT_EQ(actions.size() + 1, boundaries.size());
        for (std::size_t i = 0; i < actions.size(); ++i) {
            EXPECT_EQ(actions[i]["begin"], boundaries[i]);
            EXPECT_EQ(actions[i]["end"], boundaries[i + 1]);
            EXPECT_GT(actions[i]["peak"], actions[i]["begin"]);
            EXPECT_LT(actions[i]["peak"], actions[i]["end"]);
            const std::string move = actions[i]["label"]["move"];
            if (i > 0) {
                const std::string before = actions[i - 1]["label"]["move"];
                EXPECT_EQ(before.back(), move.front()) << i;
            }
            // The opponent's action that overlaps longest, found again from the frames.
            int longest = 0;
            int second = 0;
            std::string react = "others";
            for (const json& other : others) {
                const int overlap =
                    std::min(actions[i]["end"].get<int>(), other["end"].get<int>()) -
                    std::max(actions[i]["begin"].get<int>(), other["begin"].get<int>());
                second = overlap > longest ? longest : std::max(second, overlap);
                if (overlap <= longest) continue;
                longest = overlap;
                const json& label = other["label"];
                const auto is = [&](const char* aspect, std::initializer_list<const char*> values) {
                    return std::any_of(values.begin(), values.end(),
                                       [&](const char* v) { return label[aspect] == v; });
                };
                react = is("left_kick", {"up", "downup"}) || is("right_kick", {"up", "downup"})
                            ? "kick"
                        : is("left_punch", {"fwd", "bwdfwd", "fwdbwd"}) ||
                                is("right_punch", {"fwd", "bwdfwd", "fwdbwd"})
                            ? "punch"
                            : "others";
            }
            // Rounding to frames may swap what is nearly equal.
            EXPECT_TRUE(longest - second <= 2 || actions[i]["label"]["react"] == react) << i;
        }
    }
    double sum = 0;
    for (const json& row : made().truth["process"]) {
        double p = 0;
        for (const auto& [label, probability] : row["next"].items())
            p += probability.get<double>();
        EXPECT_NEAR(p, 1, 1e-9);
        sum += p;
    }
    EXPECT_GT(sum, 50);
}

TEST(DemoBout, CallingEverythingOthersIsNotEnough) {
    const auto labels = test::measureLabels(made().truth);
    EXPECT_LT(labels.baseline, 0.30);
    EXPECT_GT(labels.actions, 200);
}

TEST(DemoBout, StrikesThatLandTouch) {
    const std::array<demo::Suit, 2> suits = {demo::makeHumanIkSuit(), demo::makePoserSuit()};
    const auto plans = demo::planFight(8, 180, {suits[0].size, suits[1].size});
    std::vector<double> misses;
    int landed = 0;
    int strikes = 0;
    for (std::size_t p = 0; p < 2; ++p) {
        for (const demo::Strike& strike : plans[p].strikes) {
            if (strike.feint || strike.hit > 179) continue;
            ++strikes;
            const auto figure = demo::figureAt(plans[p], plans[1 - p].centreOfMass, strike.hit);
            const double miss =
                (demo::strikingPoint(plans[p].size, strike, figure) - strike.point).norm();
            misses.push_back(miss);
            landed += strike.outcome == demo::Outcome::Lands;
        }
    }
    ASSERT_GT(strikes, 100);
    std::sort(misses.begin(), misses.end());
    EXPECT_LT(misses[misses.size() / 2], 0.002);
    EXPECT_LT(misses[9 * misses.size() / 10], 0.02);
    EXPECT_GT(landed, strikes / 4);
    EXPECT_LT(landed, strikes);
}

TEST(DemoBout, TheWrittenMotionHasThePlannedCentreOfMass) {
    const std::array<demo::Suit, 2> suits = {demo::makeHumanIkSuit(), demo::makePoserSuit()};
    const auto plans = demo::planFight(1, 60, {suits[0].size, suits[1].size});
    double worst = 0;
    for (double t = 0.1; t < 59; t += 0.173) {
        const auto figure = demo::figureAt(plans[0], plans[1].centreOfMass, t);
        worst = std::max(
            worst, (demo::centreOfMassOf(figure.marks) - plans[0].centreOfMass.position(t)).norm());
    }
    EXPECT_LT(worst, 0.0005);
}

}  // namespace
}  // namespace kumite
