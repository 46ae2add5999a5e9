#include "core/project/analysis.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/project/edits.h"
#include "core/project/report.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

using test::makeBout;

TEST(Analyse, TheForceOfABobbingFighterIsThatOfItsHeight) {
    const Project bout = makeBout();
    const Analysis analysis = analyse(bout);
    for (const int player : {0, 1}) {
        const FighterAnalysis& fighter = analysis.at({0, player});
        ASSERT_TRUE(fighter.force);
        EXPECT_NEAR(fighter.body->com.massCoverage, 1.0, 1e-12);
        // The smoothed height's own second difference, by another route than the code's.
        const auto& c = fighter.force->force.smoothedCom;
        for (std::size_t i = 30; i < 330; i += 17) {
            const double acceleration = (c[i + 1].y() - 2 * c[i].y() + c[i - 1].y()) * 3600;
            EXPECT_NEAR(fighter.force->force.curve[i], std::abs(1 + acceleration / 9.80665), 1e-9);
            EXPECT_NEAR(c[i].y() - c[100].y(),
                        test::boutHeight(player, static_cast<double>(i) / 60) -
                            test::boutHeight(player, 100.0 / 60),
                        0.004)
                << "6 Hz hardly touches a bobbing of 2 Hz";
        }
        EXPECT_GE(fighter.force->minima.size(), 8u);
        EXPECT_EQ(fighter.suspicion->size(), fighter.force->minima.size());
    }
}

TEST(Analyse, TakesOverWhatDidNotChange) {
    const Project bout = makeBout();
    const Analysis first = analyse(bout);
    const int minimum = first.at({0, 0}).force->minima[2].frame;
    const auto edit = removeBoundary(bout, first, {0, 0}, minimum);
    const Analysis second = analyse(edit->project, first);
    EXPECT_EQ(second.at({0, 0}).motion, first.at({0, 0}).motion);
    EXPECT_EQ(second.at({0, 0}).force, first.at({0, 0}).force);
    EXPECT_NE(second.at({0, 0}).segmentation, first.at({0, 0}).segmentation);
    EXPECT_EQ(second.at({0, 1}).segmentation, first.at({0, 1}).segmentation);
}

// Whatever is edited, taking over old stages gives what a fresh analysis gives.
TEST(Analyse, GivesTheSameWithAndWithoutOldValues) {
    Project project = makeBout();
    Analysis analysis = analyse(project);
    const int minimum = analysis.at({0, 0}).force->minima[3].frame;
    const std::vector<std::function<MaybeEdit()>> edits = {
        [&] {
            return removeBoundary(project, analysis, {0, 0}, minimum);
        },
        [&] {
            return setSegmentation(project, {4.0, 0.05, ForceCurve::Norm});
        },
        [&] {
            return setSegmentation(project, {4.0, 0.1, ForceCurve::Vertical});
        },
        [&] {
            return setFloor(project, {0, 1}, 0.3);
        },
        [&] {
            return setRole(project, {0, 0}, Role::LeftWrist, std::nullopt);
        },
        [&] { return swapFighters(project, 0); },
        [&] {
            BodyModel model = deLevaMale();
            model.segments.pop_back();
            return setBodyModel(project, model);
        },
    };
    for (const auto& make : edits) {
        const MaybeEdit edit = make();
        ASSERT_TRUE(edit);
        project = edit->project;
        analysis = analyse(project, analysis);
        const Analysis fresh = analyse(project);
        EXPECT_EQ(segmentationJson(project, analysis, {{}, true}),
                  segmentationJson(project, fresh, {{}, true}))
            << edit->name;
        for (const int player : {0, 1}) {
            EXPECT_EQ(analysis.at({0, player}).body->floor, fresh.at({0, player}).body->floor);
        }
    }
}

TEST(Analyse, AMissingRecordingLeavesTheOthersAlone) {
    Project bout = makeBout();
    bout.takes[0].fighters[0].motion = nullptr;
    const Analysis analysis = analyse(bout);
    EXPECT_FALSE(analysis.at({0, 0}).available());
    EXPECT_TRUE(analysis.at({0, 1}).force);
    EXPECT_NE(segmentationJson(bout, analysis).find("\"missing\""), std::string::npos);
}

TEST(Analyse, WithoutABodyAHandCanStillCut) {
    Project bout = makeBout();
    bout.takes[0].fighters[0].roles = RoleMap();
    const Analysis analysis = analyse(bout);
    EXPECT_FALSE(analysis.at({0, 0}).force);
    EXPECT_EQ(analysis.at({0, 0}).segmentation->actions.size(), 1u);
    const auto edit = addBoundary(bout, analysis, {0, 0}, 100);
    EXPECT_EQ(analyse(edit->project, analysis).at({0, 0}).segmentation->actions.size(), 2u);
    EXPECT_THROW(forceCsv(analysis.at({0, 0})), Error);
}

TEST(Analyse, ClipsOfOneTwoAndThreeFramesOfOneFighter) {
    for (int frames = 1; frames <= 3; ++frames) {
        Project project = makeBout();
        project.takes[0].fighters.pop_back();
        project.takes[0].fighters[0].frames = {10, 10 + frames};
        const Analysis analysis = analyse(project);
        EXPECT_EQ(analysis.at({0, 0}).frameCount(), frames);
        EXPECT_EQ(analysis.at({0, 0}).segmentation->actions.size(), 1u);
    }
}

TEST(Analyse, CanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(analyse(makeBout(), {}, {{}, stop.get_token()}), Cancelled);
}

TEST(Times, OffsetsAndRatesOfEachFighter) {
    Project bout = makeBout();
    Fighter& second = bout.takes[0].fighters[1];
    second.offset = 1.5;
    second.rate = 120;
    EXPECT_DOUBLE_EQ(timeOfFrame(second, 60), 2.0);
    EXPECT_EQ(frameAtTime(second, 2.0), 60);
    EXPECT_EQ(frameAtTime(second, 0.0), 0);
    EXPECT_EQ(frameAtTime(second, 1e9), 360);
    const TimeSpan span = timeSpan(bout.takes[0]);
    EXPECT_DOUBLE_EQ(span.begin, 0.0);
    EXPECT_DOUBLE_EQ(span.end, 6.0);
}

TEST(Placed, TurnsShiftsAndStandsOnTheFloor) {
    Fighter fighter;
    fighter.placement = {1.0, 2.0, M_PI / 2};
    const Eigen::Vector3d p = placed(fighter, 0.1, {0, 1.0, 1.0});
    EXPECT_LT((p - Eigen::Vector3d(2.0, 0.9, 2.0)).norm(), 1e-12) << "+z turns toward +x";
}

}  // namespace
}  // namespace kumite
