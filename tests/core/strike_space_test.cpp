// Strikes found, aligned in time, sampled and blended.
#include "core/editing/strike_space.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/made_strikes.h"

namespace kumite {
namespace {

using Eigen::Vector3d;
using test::StrikeKind;

StrikeSpace spaceOf(StrikeKind kind) {
    return strikeSpace(test::asExamples(test::madeStrikes(kind)), test::strikerOf(kind));
}

class MadeStrikes : public testing::TestWithParam<StrikeKind> {};

TEST_P(MadeStrikes, AreFoundWhereTheyHit) {
    for (const test::MadeStrike& made : test::madeStrikes(GetParam())) {
        const auto moment =
            strikeIn(made.clip, {0, made.clip.frameCount()}, test::strikerOf(GetParam()));
        ASSERT_TRUE(moment);
        const Strike strike =
            strikeFrom(made.clip, {{0, made.clip.frameCount()}, moment->hit}, 0, made.name);
        const Vector3d found =
            positionsOf(strike.clip)
                .at(moment->hit, *strikingJoint(*made.clip.rig, test::strikerOf(GetParam())))
                .cast<double>();
        // A hook is stretched farthest a little before its end.
        const double near = GetParam() == StrikeKind::Hook ? 0.25 : 0.03;
        EXPECT_LT((found - made.point).norm(), near) << made.name;
        EXPECT_NEAR(headingOf(*strike.clip.rig, strike.clip.frames.front()).value(), 0, 1e-9);
        EXPECT_NEAR(strike.clip.frames.front().root.x(), 0, 1e-9);
    }
}

TEST_P(MadeStrikes, OneAfterTheOtherAreToldApart) {
    // The whole set in one recording, each brought to where the one before ended.
    Clip all;
    const auto made = test::madeStrikes(GetParam());
    for (const Strike& strike : test::asExamples(made)) {
        all.rig = strike.clip.rig;
        all.rate = strike.clip.rate;
        for (int rest = 0; rest < 30; ++rest)
            all.frames.push_back(strike.clip.frames.front());
        all.frames.insert(all.frames.end(), strike.clip.frames.begin(), strike.clip.frames.end());
    }
    const Striker striker = test::strikerOf(GetParam());
    // A hook goes out less from a guard that is out already.
    const double least = GetParam() == StrikeKind::Hook ? 0.15 : 0.25;
    EXPECT_EQ(findStrikes(all, striker, least).size(), made.size());
    EXPECT_EQ(likeliestStriker(all, {0, all.frameCount()}), striker);
}

TEST_P(MadeStrikes, HitsFallOnEachOtherInTime) {
    const StrikeSpace& space = spaceOf(GetParam());
    const auto made = test::madeStrikes(GetParam());
    ASSERT_EQ(space.examples.size(), made.size());
    for (std::size_t e = 0; e < made.size(); ++e) {
        const auto& example = space.examples[e];
        EXPECT_NEAR((example.point - made[e].point).norm(), 0, 1e-6) << example.name;
        EXPECT_NEAR(example.seconds[static_cast<std::size_t>(space.hit)], made[e].hit / 60.0, 1e-9);
        EXPECT_NEAR(example.seconds.back(), (made[e].clip.frameCount() - 1) / 60.0, 1e-9);
        for (std::size_t i = 1; i < example.seconds.size(); ++i)
            EXPECT_GE(example.seconds[i], example.seconds[i - 1]);
    }
}

TEST_P(MadeStrikes, BlendsMeetPointsBetweenExamples) {
    const StrikeSpace space = spaceOf(GetParam());
    EXPECT_GT(space.samples.size(), 200u);
    for (const auto& example : space.examples) {
        const BlendFit fit = fitBlend(space, example.point);
        EXPECT_LT(fit.error, 1e-3) << example.name;
    }
    // A blend that is no sample of any grid.
    const auto& some = space.neighbourhoods.front();
    BlendWeights weights;
    for (std::size_t i = 0; i < 3; ++i)
        weights.push_back({some[i], std::array{0.471, 0.329, 0.2}[i]});
    const BlendFit fit = fitBlend(space, hitPoint(space, weights));
    EXPECT_LT(fit.error, 2e-3);
    double sum = 0;
    for (const ExampleWeight& w : fit.weights) {
        EXPECT_GT(w.weight, 0);
        sum += w.weight;
    }
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_NEAR((hitPoint(space, fit.weights) - fit.point).norm(), 0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Kinds, MadeStrikes, testing::ValuesIn(test::kStrikeKinds));

TEST(StrikeSpace, BlendsOfIdenticalExamplesAreTheExample) {
    const auto one = test::asExamples(test::madeStrikes(StrikeKind::Hook)).front();
    const StrikeSpace space = strikeSpace({one, one, one}, Striker::RightHand);
    const BlendWeights weights = {{0, 0.2}, {1, 0.5}, {2, 0.3}};
    const std::vector<double> times = blendedTimes(space, weights);
    ASSERT_EQ(space.frames, one.clip.frameCount());
    for (int f = 0; f < space.frames; ++f) {
        EXPECT_NEAR(times[static_cast<std::size_t>(f)], f / 60.0, 1e-12);
        const Pose pose = blendedPose(space, weights, f);
        const Pose& own = one.clip.frames[static_cast<std::size_t>(f)];
        EXPECT_NEAR((pose.root - own.root).norm(), 0, 1e-9);
        for (std::size_t j = 0; j < pose.turns.size(); ++j)
            EXPECT_NEAR(pose.turns[j].angularDistance(own.turns[j]), 0, 1e-7);
    }
}

TEST(StrikeSpace, BlendsTheShortWayAcrossTheSignOfQuaternions) {
    const auto examples = test::asExamples(test::madeStrikes(StrikeKind::StraightPunch));
    auto flipped = examples;
    std::mt19937 random(5);
    for (Strike& strike : flipped) {
        for (Pose& pose : strike.clip.frames) {
            for (Eigen::Quaterniond& turn : pose.turns) {
                if (random() & 1) turn.coeffs() = -turn.coeffs();
            }
        }
    }
    const StrikeSpace a = strikeSpace(examples, Striker::RightHand);
    const StrikeSpace b = strikeSpace(flipped, Striker::RightHand);
    ASSERT_EQ(a.samples.size(), b.samples.size());
    for (std::size_t i = 0; i < a.samples.size(); ++i)
        EXPECT_NEAR((a.points.points()[i] - b.points.points()[i]).norm(), 0, 1e-9);
}

TEST(StrikeSpace, RefusesWhatIsNoStrike) {
    EXPECT_THROW(strikeSpace({}, Striker::RightHand), Error);
    auto rig = std::make_shared<Rig>(*test::madeRig());
    rig->roles.clear(Role::RightWrist);
    auto one = test::asExamples(test::madeStrikes(StrikeKind::StraightPunch)).front();
    one.clip.rig = rig;
    EXPECT_THROW(strikeSpace({one}, Striker::RightHand), Error);
    EXPECT_FALSE(strikeIn(one.clip, {0, 2}, Striker::LeftHand)) << "too short";
    EXPECT_FALSE(strikeIn(one.clip, {0, 40}, Striker::RightHand)) << "no such limb";
}

}  // namespace
}  // namespace kumite
