// Strikes found, aligned, blended and brought to targets.
#include "core/editing/hit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/editing/hit_region.h"
#include "tests/support/made_strikes.h"

namespace kumite {
namespace {

using Eigen::Vector3d;
using test::StrikeKind;

/// The space of a whole made set, made once.
const StrikeSpace& spaceOf(StrikeKind kind) {
    static std::array<std::optional<StrikeSpace>, 4> spaces;
    auto& space = spaces[static_cast<std::size_t>(kind)];
    if (!space)
        space = strikeSpace(test::asExamples(test::madeStrikes(kind)), test::strikerOf(kind));
    return *space;
}

Vector3d strikingAt(const StrikeSpace& space, const Clip& clip, int frame) {
    const JointPositions positions = positionsOf(clip);
    return positions.at(frame, *strikingJoint(*space.rig, space.striker)).cast<double>();
}

class HitTarget : public testing::TestWithParam<StrikeKind> {};

TEST_P(HitTarget, AnExampleAskedForComesBackAsItWas) {
    const StrikeSpace& space = spaceOf(GetParam());
    const auto made = test::asExamples(test::madeStrikes(GetParam()));
    for (const std::size_t e : {std::size_t{0}, made.size() - 1}) {
        const HitMotion motion = hitTarget(space, space.examples[e].point, HitMethod::Full);
        // The examples' feet turn on the spot; the clean-up of a foot that slides moves the body.
        EXPECT_LT(motion.error, 0.02) << made[e].name;
        EXPECT_TRUE(motion.solution.insideNaturalRegion);
        EXPECT_EQ(motion.solution.method, HitMethod::Full);
        EXPECT_TRUE(motion.hits);
        EXPECT_LT(hitTarget(space, space.examples[e].point).error, 0.01) << made[e].name;
    }
}

TEST_P(HitTarget, PointsBetweenExamplesAreHit) {
    const StrikeSpace& space = spaceOf(GetParam());
    // A blend that is no sample of any grid.
    const auto& some = space.neighbourhoods.front();
    BlendWeights weights;
    for (std::size_t i = 0; i < 3; ++i)
        weights.push_back({some[i], std::array{0.471, 0.329, 0.2}[i]});
    const Vector3d target = hitPoint(space, weights);
    const HitSolution solution = solveHit(space, target);
    EXPECT_TRUE(solution.insideNaturalRegion);
    EXPECT_LT(solution.error, 0.005);
    double sum = 0;
    for (const ExampleWeight& w : solution.horizontal.weights) {
        EXPECT_GT(w.weight, 0);
        sum += w.weight;
    }
    EXPECT_NEAR(sum, 1, 1e-9);
}

TEST_P(HitTarget, TargetsBesideTheRegionAreHitByParts) {
    const StrikeSpace& space = spaceOf(GetParam());
    const Vector3d middle = 0.5 * (space.natural.low + space.natural.high);
    int beyond = 0;
    for (int corner = 0; corner < 8; ++corner) {
        // The corners of the box are what blends of whole examples leave out (paper C, Fig. 5).
        Vector3d target = middle;
        for (int axis = 0; axis < 3; ++axis) {
            const double half = 0.5 * (space.natural.high[axis] - space.natural.low[axis]);
            target[axis] += (corner >> axis & 1 ? 1 : -1) * 0.8 * half;
        }
        const HitMotion full = hitTarget(space, target, HitMethod::Full);
        const HitMotion partial = hitTarget(space, target, HitMethod::Partial);
        if (full.error > 0.03) ++beyond;
        EXPECT_LT(partial.error, std::max(0.05, full.error)) << target.transpose();
        // What is said is what the clip shows.
        EXPECT_NEAR((strikingAt(space, partial.clip, partial.hit) - target).norm(), partial.error,
                    1e-5);
        EXPECT_EQ(partial.solution.method, HitMethod::Partial);
        for (const Pose& pose : partial.clip.frames) {
            for (const Eigen::Quaterniond& turn : pose.turns)
                ASSERT_NEAR(turn.norm(), 1, 1e-9);
        }
    }
    EXPECT_GT(beyond, 3) << "corners outside of the natural region";
}

TEST_P(HitTarget, AnUnreachableTargetGetsTheNearestReachablePoint) {
    const StrikeSpace& space = spaceOf(GetParam());
    const Vector3d far(0.3, 1.2, 6);
    const HitMotion motion = hitTarget(space, far);
    EXPECT_FALSE(motion.hits);
    EXPECT_FALSE(motion.solution.insideNaturalRegion);
    EXPECT_GT(motion.error, 4);
    // It stretches out: farther than any example in that direction.
    double farthest = 0;
    for (const auto& example : space.examples)
        farthest = std::max(farthest, example.point.z());
    EXPECT_GT(motion.reached.z(), farthest - 0.15);
    const HitMotion behind = hitTarget(space, {0, 1, -3});
    EXPECT_FALSE(behind.hits);
    EXPECT_TRUE(behind.reached.allFinite());
}

TEST_P(HitTarget, MovesSmoothlyAndStartsInItsFrame) {
    const StrikeSpace& space = spaceOf(GetParam());
    const Vector3d target = space.natural.high - Vector3d(0.05, 0.05, 0.05);
    const HitMotion motion = hitTarget(space, target, HitMethod::Partial);
    EXPECT_NEAR(headingOf(*space.rig, motion.clip.frames.front()).value(), 0, 1e-6);
    EXPECT_NEAR(motion.clip.frames.front().root.x(), 0, 1e-6);
    EXPECT_NEAR(motion.clip.frames.front().root.z(), 0, 1e-6);
    const JointPositions positions = positionsOf(motion.clip);
    const int joint = *strikingJoint(*space.rig, space.striker);
    for (int f = 1; f < positions.frameCount; ++f) {
        const double speed =
            (positions.at(f, joint) - positions.at(f - 1, joint)).norm() * motion.clip.rate;
        EXPECT_LT(speed, 1.3 * space.fastest) << "frame " << f;
    }
}

TEST_P(HitTarget, TheSameTargetGivesTheSameMotion) {
    const StrikeSpace& space = spaceOf(GetParam());
    const Vector3d target = space.natural.low + Vector3d(0.02, 0.02, 0.02);
    const HitMotion a = hitTarget(space, target), b = hitTarget(space, target);
    ASSERT_EQ(a.clip.frameCount(), b.clip.frameCount());
    for (std::size_t f = 0; f < a.clip.frames.size(); ++f) {
        EXPECT_EQ(a.clip.frames[f].root, b.clip.frames[f].root);
        for (std::size_t j = 0; j < a.clip.frames[f].turns.size(); ++j)
            EXPECT_EQ(a.clip.frames[f].turns[j].coeffs(), b.clip.frames[f].turns[j].coeffs());
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, HitTarget, testing::ValuesIn(test::kStrikeKinds));

TEST(StrikeSpace, OfOneExampleHitsItsOwnPointAndByPartsAround) {
    const auto one = test::asExamples(test::madeStrikes(StrikeKind::StraightPunch)).front();
    const StrikeSpace space = strikeSpace({one}, Striker::RightHand);
    EXPECT_EQ(space.samples.size(), 1u);
    EXPECT_LT(hitTarget(space, space.examples[0].point).error, 0.005);
    const Vector3d aside = space.examples[0].point + Vector3d(0.12, 0.05, -0.06);
    EXPECT_GT(hitTarget(space, aside, HitMethod::Full).error, 0.1);
    EXPECT_LT(hitTarget(space, aside, HitMethod::Partial).error, 0.03);
}

TEST(HitRegion, TheExtendedOneHoldsTheNaturalOne) {
    const StrikeSpace& space = spaceOf(StrikeKind::StraightPunch);
    const Box box = extendedBox(space, {}, 0.1, 0.2);
    EXPECT_TRUE(box.contains(space.natural.low));
    EXPECT_TRUE(box.contains(space.natural.high));
    const Coverage coverage = coverageOf(space, space.natural, 0.15);
    EXPECT_GT(coverage.cells, 4);
    EXPECT_GE(coverage.extended, coverage.natural);
    EXPECT_GT(coverage.extended, coverage.cells / 3);
    EXPECT_LE(coverage.extended, coverage.cells);
}

}  // namespace
}  // namespace kumite
