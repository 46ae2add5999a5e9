#include "core/segmentation/segmentation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace kumite {
namespace {

using Kind = Correction::Kind;

constexpr double kThreshold = 0.05;
constexpr double kReach = 6;

/// Minima at 20, 40 (shallow: prominence 0.02), 60 and 80 of a curve of 101 frames.
struct Curve {
    std::vector<double> values = std::vector<double>(101, 1.0);
    std::vector<ForceMinimum> minima;

    Curve() {
        for (const auto& [frame, depth] :
             std::vector<std::pair<int, double>>{{20, 0.4}, {40, 0.02}, {60, 0.3}, {80, 0.5}}) {
            values[static_cast<std::size_t>(frame)] -= depth;
        }
        values[50] = 1.5;
        minima = findMinima(values);
    }

    Segmentation cut(const std::vector<Correction>& corrections,
                     double threshold = kThreshold) const {
        return segment(values, minima, threshold, corrections, kReach);
    }
};

std::vector<int> framesOf(const Segmentation& cut) {
    std::vector<int> frames;
    for (const Boundary& boundary : cut.boundaries)
        frames.push_back(boundary.frame);
    return frames;
}

Correction remove(int frame) {
    return {Kind::Remove, frame, 0, false, false};
}
Correction add(int frame, bool beside = false, bool removed = false) {
    return {Kind::Add, frame, 0, beside, removed};
}
Correction move(int frame, int to) {
    return {Kind::Move, frame, to, false, false};
}

TEST(Segment, CutsAtTheProminentMinimaAndTheEnds) {
    const auto cut = Curve().cut({});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 60, 80, 100}));
    EXPECT_EQ(cut.boundaries.front().source, BoundarySource::End);
    EXPECT_EQ(cut.boundaries[1].source, BoundarySource::Detected);
    ASSERT_EQ(cut.actions.size(), 4u);
    EXPECT_EQ(cut.actions[1], (Action{20, 60, 50})) << "the highest frame strictly inside";
    EXPECT_EQ(cut.actions[0].peak, 1) << "the first of equals";
}

TEST(Segment, ARemovedMinimumMergesItsNeighbours) {
    const auto cut = Curve().cut({remove(60)});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 80, 100}));
    EXPECT_EQ(cut.removed, (std::vector<RemovedBoundary>{{60, 2}}));
    EXPECT_EQ(cut.actions[1].peak, 50) << "the higher peak stays the identity";
    EXPECT_TRUE(cut.unmatched.empty());
}

TEST(Segment, CorrectionsSurviveASmallShiftOfTheirMinimum) {
    EXPECT_EQ(framesOf(Curve().cut({remove(65)})), (std::vector<int>{0, 20, 80, 100}));
    EXPECT_EQ(framesOf(Curve().cut({move(55, 57)})), (std::vector<int>{0, 20, 57, 80, 100}));
}

TEST(Segment, CorrectionsThatMeanNothingAreListedNotDropped) {
    const auto cut = Curve().cut({remove(30), move(70, 72), add(100), add(0)});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 60, 80, 100}));
    EXPECT_EQ(cut.unmatched.size(), 4u);
}

TEST(Segment, ARemovalWaitsWhileItsMinimumIsBelowTheThreshold) {
    const auto quiet = Curve().cut({remove(40)});
    EXPECT_TRUE(quiet.unmatched.empty()) << "the minimum is there, it only does not cut";
    EXPECT_TRUE(quiet.removed.empty());
    EXPECT_EQ(framesOf(Curve().cut({remove(40)}, 0.01)), (std::vector<int>{0, 20, 60, 80, 100}));
    EXPECT_EQ(framesOf(Curve().cut({}, 0.01)), (std::vector<int>{0, 20, 40, 60, 80, 100}));
}

TEST(Segment, AMovedBoundaryStaysWhenItsMinimumFallsBelowTheThreshold) {
    EXPECT_EQ(framesOf(Curve().cut({move(60, 63)}, 0.35)), (std::vector<int>{0, 20, 63, 80, 100}));
}

TEST(Segment, AnAddedBoundaryIsTheMinimumThatAppearsBesideIt) {
    EXPECT_EQ(framesOf(Curve().cut({add(42)})), (std::vector<int>{0, 20, 42, 60, 80, 100}));
    EXPECT_EQ(framesOf(Curve().cut({add(42)}, 0.01)), (std::vector<int>{0, 20, 42, 60, 80, 100}))
        << "not cut twice when a lower threshold finds the minimum";
    EXPECT_EQ(framesOf(Curve().cut({add(23, true)})), (std::vector<int>{0, 20, 23, 60, 80, 100}))
        << "unless it was added beside a boundary on purpose";
}

TEST(Segment, RemovingAnAddedBoundaryKeepsItForRestoring) {
    const auto cut = Curve().cut({add(42, false, true)});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 60, 80, 100}));
    EXPECT_EQ(cut.removed, (std::vector<RemovedBoundary>{{42, {}}}));
}

TEST(Segment, ARemovalWinsOverAMoveOfTheSameMinimum) {
    const auto cut = Curve().cut({move(60, 63), remove(60)});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 80, 100}));
    EXPECT_EQ(cut.removed, (std::vector<RemovedBoundary>{{63, 2}}));
}

TEST(Segment, TheMinimumAtTheFrameIsMeantEvenIfAnotherOneCuts) {
    // The shallow minimum at 40 was removed; a boundary 5 frames away must not suffer for it.
    Curve curve;
    curve.values[45] -= 0.3;
    curve.values[42] = 1.1;
    curve.minima = findMinima(curve.values);
    EXPECT_EQ(framesOf(curve.cut({remove(40)})), (std::vector<int>{0, 20, 45, 60, 80, 100}));
}

TEST(Segment, EachCorrectionMeansAMinimumOfItsOwn) {
    const auto cut = Curve().cut({move(59, 57), move(61, 64)});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 57, 80, 100}));
    EXPECT_EQ(cut.unmatched, std::vector<Correction>{move(61, 64)});
    EXPECT_EQ(cut.meant[0], 2);
    EXPECT_EQ(cut.meant[1], std::nullopt);
}

TEST(Segment, AnAddedBoundaryLeavesAloneWhatAHandMovedOrRemoved) {
    EXPECT_EQ(framesOf(Curve().cut({move(60, 50), add(62)})),
              (std::vector<int>{0, 20, 50, 62, 80, 100}));
    const auto cut = Curve().cut({remove(60), add(62)});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 62, 80, 100}));
    EXPECT_EQ(cut.removed, (std::vector<RemovedBoundary>{{60, 2}})) << "it can still be restored";
}

TEST(Segment, OneBoundaryPerFrame) {
    const auto cut = Curve().cut({move(60, 80), add(80, true)});
    EXPECT_EQ(framesOf(cut), (std::vector<int>{0, 20, 80, 100}));
    EXPECT_EQ(cut.unmatched.size(), 1u) << "one of the two that ask for frame 80 is listed";
    EXPECT_EQ(cut.boundaries[2].source, BoundarySource::Added);
}

TEST(Segment, ClipsOfNoOneTwoAndThreeFrames) {
    EXPECT_TRUE(segment({}, {}, kThreshold, {}, kReach).actions.empty());
    const std::vector<double> level(3, 1.0);
    const auto cut = [&](std::size_t n) {
        return segment(std::span(level).first(n), {}, kThreshold, {}, kReach);
    };
    EXPECT_EQ(framesOf(cut(1)), std::vector<int>{0});
    EXPECT_EQ(cut(1).actions, (std::vector<Action>{{0, 0, 0}}));
    EXPECT_EQ(cut(2).actions, (std::vector<Action>{{0, 1, 0}}));
    EXPECT_EQ(cut(3).actions, (std::vector<Action>{{0, 2, 1}}));
}

// Whatever the corrections, actions are a gapless partition and every peak lies inside.
TEST(Segment, ActionsAreAGaplessPartition) {
    const Curve curve;
    for (unsigned seed = 0; seed < 300; ++seed) {
        std::vector<Correction> corrections;
        unsigned state = seed * 2654435761u + 1;
        const auto draw = [&](unsigned n) {
            state = state * 1664525u + 1013904223u;
            return static_cast<int>((state >> 16) % n);
        };
        for (int i = draw(8); i > 0; --i) {
            corrections.push_back(
                {static_cast<Kind>(draw(3)), draw(110), draw(110), draw(2) == 0, draw(4) == 0});
        }
        const auto cut = curve.cut(corrections, 0.01 * draw(60));
        ASSERT_EQ(cut.actions.size() + 1, cut.boundaries.size());
        for (std::size_t i = 0; i < cut.actions.size(); ++i) {
            const Action& action = cut.actions[i];
            EXPECT_EQ(action.begin, cut.boundaries[i].frame);
            EXPECT_EQ(action.end, cut.boundaries[i + 1].frame);
            EXPECT_LT(action.begin, action.end);
            EXPECT_TRUE(action.peak == action.begin ? action.end - action.begin == 1
                                                    : action.peak < action.end);
        }
    }
}

}  // namespace
}  // namespace kumite
