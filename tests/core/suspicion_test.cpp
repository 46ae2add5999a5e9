#include "core/segmentation/suspicion.h"

#include <gtest/gtest.h>

namespace kumite {
namespace {

constexpr double kRate = 60;
constexpr double kThreshold = 0.05;

/// A fighter made of minima alone.
struct Stream {
    std::vector<double> curve = std::vector<double>(2001, 1.0);
    std::vector<ForceMinimum> minima;
    std::vector<float> footSpeed = std::vector<float>(2001, 0.5f);
    Segmentation cut;

    void add(int frame, double force, double prominence) {
        minima.push_back({frame, force, prominence});
    }
    Suspicion rank(const std::vector<Correction>& corrections = {}) {
        cut = segment(curve, minima, kThreshold, corrections, 6);
        const SuspicionInput input{curve, minima, &cut, footSpeed, kRate, kThreshold};
        return rankSuspicion(std::span(&input, 1)).front().suspicion;
    }
};

/// Forty minima, every fourth somewhat shallower and higher than the rest.
Stream mixed() {
    Stream stream;
    for (int i = 1; i <= 40; ++i) {
        const bool shallow = i % 4 == 0;
        stream.add(48 * i, shallow ? 0.68 : 0.6, shallow ? 0.3 : 0.5);
    }
    return stream;
}

TEST(Suspicion, PriorSuspectsShallowHighCrowdedMinimaAndFastFeet) {
    Stream stream;
    stream.add(200, 0.6, 0.5);
    stream.add(400, 0.6, 0.06);  // shallow
    stream.add(600, 1.0, 0.5);   // high
    stream.add(800, 0.6, 0.5);   // a foot flies over it
    stream.footSpeed[800] = 3.0f;
    stream.add(1000, 0.6, 0.5);  // crowded
    stream.add(1006, 0.6, 0.5);
    const Suspicion suspicion = stream.rank();
    for (const std::size_t i : {1u, 2u, 3u, 4u, 5u})
        EXPECT_GT(suspicion[i], suspicion[0]) << i;
    for (const double p : suspicion) {
        EXPECT_GT(p, 0.0);
        EXPECT_LT(p, 1.0);
    }
}

TEST(Suspicion, MinimaBelowTheThresholdCutNothingAndAreNotSuspected) {
    Stream stream;
    stream.add(100, 0.99, 0.01);
    stream.add(200, 0.6, 0.5);
    EXPECT_EQ(stream.rank()[0], 0.0);
}

TEST(Suspicion, LearnsFromRemovals) {
    Stream stream = mixed();
    const Suspicion before = stream.rank();
    // Three of the shallow ones are removed: the seven others must now lead all deep ones by more.
    const Suspicion after = stream.rank({{Correction::Kind::Remove, 4 * 48, 0, false, false},
                                         {Correction::Kind::Remove, 8 * 48, 0, false, false},
                                         {Correction::Kind::Remove, 12 * 48, 0, false, false}});
    for (std::size_t i = 15; i < 40; i += 4) {
        EXPECT_GT(after[i], 2 * before[i]);
        EXPECT_GT(after[i], 5 * after[i - 1]);
    }
}

TEST(Suspicion, WhatIsUsualIsTheFightersOwn) {
    // The same minimum: everyday for one who dances, odd for one who fights.
    Stream dancer, fighter;
    for (int i = 1; i <= 40; ++i) {
        const bool odd = i == 20;
        dancer.add(48 * i, odd ? 0.93 : 0.9, odd ? 0.15 : 0.18);
        fighter.add(48 * i, odd ? 0.93 : 0.6, odd ? 0.15 : 0.6);
    }
    EXPECT_LT(dancer.rank()[19], 0.05);
    EXPECT_GT(fighter.rank()[19], 0.15);
}

TEST(Suspicion, LearnsTheOppositeToo) {
    // A user who removes deep minima under fast feet teaches that, against the prior on depth.
    Stream stream;
    for (int i = 1; i <= 40; ++i) {
        const bool kick = i % 4 == 0;
        stream.add(48 * i, 0.6, 0.5);
        if (kick) stream.footSpeed[static_cast<std::size_t>(48 * i)] = 2.0f;
    }
    const Suspicion after = stream.rank({{Correction::Kind::Remove, 4 * 48, 0, false, false},
                                         {Correction::Kind::Remove, 8 * 48, 0, false, false}});
    EXPECT_GT(after[11], 3 * after[10]);
}

TEST(Suspicion, AMovedBoundaryIsNoSuspect) {
    Stream stream = mixed();
    const Suspicion before = stream.rank();
    const Suspicion after =
        stream.rank({{Correction::Kind::Move, 4 * 48, 4 * 48 + 3, false, false},
                     {Correction::Kind::Move, 8 * 48, 8 * 48 + 3, false, false}});
    EXPECT_LT(after[15], before[15]);
}

TEST(Suspicion, IsSharedByFightersAndDeterministic) {
    Stream one = mixed(), two = mixed();
    one.cut =
        segment(one.curve, one.minima, kThreshold,
                std::vector<Correction>{{Correction::Kind::Remove, 4 * 48, 0, false, false}}, 6);
    two.cut = segment(two.curve, two.minima, kThreshold, {}, 6);
    const std::vector<SuspicionInput> inputs = {
        {one.curve, one.minima, &one.cut, one.footSpeed, kRate, kThreshold},
        {two.curve, two.minima, &two.cut, two.footSpeed, kRate, kThreshold}};
    const auto ranked = rankSuspicion(inputs);
    EXPECT_GT(ranked[1].suspicion[15], mixed().rank()[15])
        << "what was said of one is learned for both";
    EXPECT_EQ(ranked[1].suspicion, rankSuspicion(inputs)[1].suspicion);
    EXPECT_TRUE(rankSuspicion({}).empty());
}

}  // namespace
}  // namespace kumite
