#include "core/quality/quality.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/blend.h"
#include "core/motion/feet.h"
#include "core/motion/inertialise.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A human that stands at the origin facing +z, toes on the floor, placed frame by frame.
Clip placedHuman(
    int frames, const std::function<GroundTransform(int)>& place,
    const std::function<double(int)>& height = [](int) { return 0.0; }) {
    const auto motion = test::bobbing(1, 60, [](double) { return 0.0; });
    const Fighter fighter = test::makeFighter(motion, 60);
    const Clip still = clipOf(*motion, motion->frames(), fighter.space, fighter.roles);
    Clip clip{still.rig, 60, {}};
    for (int i = 0; i < frames; ++i) {
        clip.frames.push_back(moved(still.frames[0], place(i)));
        clip.frames.back().root.y() += height(i);
    }
    return clip;
}

Clip standingAt(double x, double z, double yaw, int frames = 10) {
    return placedHuman(frames, [=](int) { return GroundTransform{yaw, x, z}; });
}

TEST(Quality, FootSkateIsThatOfTheFeet) {
    // Slides at 1 m/s over intervals 0 … 29 of 60; the mean over 15 intervals (0.25 s) round each
    // of these is above 0.5 m/s, as at least 8 of them slide.
    const Clip clip = placedHuman(61, [](int i) {
        return GroundTransform{0, std::min(i, 30) / 60.0, 0};
    });
    const MeasuredBody body = measuredBody(clip, 0);
    EXPECT_NEAR(*footSkateOf(body), 30.0 / 60.0, 1e-9);
    // The same feet 6 cm over the floor do not touch it.
    EXPECT_EQ(*footSkateOf(measuredBody(clip, -0.06)), 0);
}

TEST(Quality, FloorPenetrationCountsFramesAndTheWorst) {
    // 2 of 10 frames are 2 cm deep, one 4 mm: wobble.
    const Clip clip = placedHuman(
        10, [](int) { return GroundTransform{}; },
        [](int i) { return i < 2    ? -0.02
                           : i == 5 ? -0.004
                                    : 0.0; });
    const auto penetration = floorPenetration(measuredBody(clip, 0));
    EXPECT_DOUBLE_EQ(penetration->share, 0.2);
    EXPECT_NEAR(penetration->worst, 0.02, 1e-6);
}

TEST(Quality, BodiesInEachOther) {
    const Clip here = standingAt(0, 0, 0);
    // Far apart, beside, and within each other.
    EXPECT_EQ(interpenetration(measuredBody(here, 0), measuredBody(standingAt(9, 0, 0), 0)).worst,
              0);
    const Clip through = placedHuman(10, [](int i) {
        return GroundTransform{M_PI, 0, i < 3 ? 0.0 : 3.0};
    });
    const auto deep = interpenetration(measuredBody(here, 0), measuredBody(through, 0));
    EXPECT_DOUBLE_EQ(deep.share, 0.3);
    EXPECT_GT(deep.worst, 0.2);
    // Trunks of 12 cm radius 20 cm apart are 4 cm in each other; arms and legs are not.
    const Clip near = standingAt(0, 0.2, 0);
    EXPECT_NEAR(interpenetration(measuredBody(here, 0), measuredBody(near, 0)).worst, 0.04, 1e-6);
}

TEST(Quality, FacingAndDistanceByHand) {
    // Two metres apart along z; the first looks 30° past the other, the second straight at it.
    const Clip first = standingAt(0, 0, M_PI / 6), second = standingAt(0, 2, M_PI);
    const MeasuredBody a = measuredBody(first, 0), b = measuredBody(second, 0);
    EXPECT_NEAR(facingError(a, b), M_PI / 6, 1e-9);
    EXPECT_NEAR(facingError(b, a), 0, 1e-9);
    const Clip going = placedHuman(10, [](int i) { return GroundTransform{0, 0, 1.0 + 0.1 * i}; });
    const FighterDistance distance = fighterDistance(a, measuredBody(going, 0));
    EXPECT_NEAR(distance.nearest, 1.0, 1e-12);
    EXPECT_NEAR(distance.mean, 1.45, 1e-12);
    EXPECT_NEAR(distance.farthest, 1.9, 1e-12);
}

TEST(Quality, HitTiming) {
    const std::vector<HitMoments> hits = {{1.0, 1.1, 0.1}, {2.0, 2.0, 0.1}, {3.0, 3.25, 0.05}};
    EXPECT_NEAR(*hitTimingError(hits), (0 + 0.1 + 0.2) / 3, 1e-12);
    EXPECT_FALSE(hitTimingError({}));
}

TEST(Percentile, IsLinearBetweenRanks) {
    EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 1), 4);
    EXPECT_DOUBLE_EQ(percentile({7}, 0.99), 7);
    EXPECT_DOUBLE_EQ(percentile({}, 0.99), 0);
}

/// The human turning its neck by `angle(frame)` radians.
Clip nodding(int frames, const std::function<double(int)>& angle) {
    Clip clip = standingAt(0, 0, 0, frames);
    auto rig = std::make_shared<Rig>(*clip.rig);
    const int neck = *rig->roles[Role::Neck];
    rig->roles = RoleMap();
    rig->roles.set(Role::Neck, neck);
    clip.rig = rig;
    for (int i = 0; i < frames; ++i)
        clip.frames[static_cast<std::size_t>(i)].turns[static_cast<std::size_t>(neck)] =
            AngleAxisd(angle(i), Vector3d::UnitX());
    return clip;
}

TEST(JointMotion, ByHand) {
    // 0.01 rad a frame at 60 Hz, twice that from frame 30 on: 0.6 and 1.2 rad/s; the velocity
    // changes over frame 30 alone, by 0.6 rad/s in 1/60 s.
    const Clip clip = nodding(61, [](int i) { return i <= 30 ? 0.01 * i : 0.3 + 0.02 * (i - 30); });
    const std::vector<int> joins = {30};
    const JoinMotion motion = measureJoins(clip, joins, 0.1);
    // Frames 29 … 36 lie at the join.
    ASSERT_EQ(motion.atJoins.velocity.size(), 8U);
    ASSERT_EQ(motion.inside.velocity.size(), 52U);
    ASSERT_EQ(motion.inside.acceleration.size(), 51U);
    EXPECT_NEAR(motion.atJoins.velocity.front(), 0.6, 1e-5);
    EXPECT_NEAR(motion.atJoins.velocity.back(), 1.2, 1e-5);
    EXPECT_NEAR(percentile(motion.atJoins.acceleration, 1), 36, 1e-3);
    EXPECT_NEAR(percentile(motion.inside.acceleration, 1), 0, 1e-3);
}

TEST(JointMotion, ATurnOverTheAntipodeIsTheShortWay) {
    Clip clip = nodding(3, [](int i) { return 0.1 * i; });
    for (Quaterniond& turn : clip.frames[1].turns)
        turn.coeffs() = -turn.coeffs();
    const JoinMotion motion = measureJoins(clip, {});
    for (const float velocity : motion.inside.velocity)
        EXPECT_NEAR(velocity, 6.0, 1e-4);
}

TEST(Quality, AHardCutReadsWorseThanAnInertialisedJoin) {
    const auto swaying = [](double phase) {
        return nodding(60, [phase](int i) { return 0.5 * std::sin(0.1 * i + phase); });
    };
    const Clip first = swaying(0), second = swaying(2.5);
    Clip cut = first;
    cut.frames.insert(cut.frames.end(), second.frames.begin() + 1, second.frames.end());
    const Clip smooth = joined(first, second);
    const auto ratio = [](const Clip& clip) {
        JudgedMotion motion;
        motion.fighters.push_back({&clip, 0, {59}});
        return *measureQuality(motion).joinAccelerationRatio;
    };
    EXPECT_GT(ratio(cut), 4 * ratio(smooth));
}

TEST(Labels, NgramsByHand) {
    const std::vector<LabelSequence> sequences = {{"a", "b", "a", "b"}, {"b", "a"}};
    // ab ba ab | ba: two of four; none goes across.
    const NgramCount pairs = countNgrams(sequences, 2);
    EXPECT_EQ(pairs.distinct, 2);
    EXPECT_EQ(pairs.total, 4);
    EXPECT_DOUBLE_EQ(countNgrams(sequences, 3).share(), 1.0);
    EXPECT_EQ(countNgrams(sequences, 5).total, 0);
    EXPECT_EQ(countNgrams(sequences, 5).share(), 0);
}

TEST(Labels, DistanceByHand) {
    const std::vector<LabelSequence> a = {{"x", "x", "y", "z"}}, b = {{"x", "y", "y", "y"}};
    // ½ (|½ − ¼| + |¼ − ¾| + |¼ − 0|)
    EXPECT_DOUBLE_EQ(ngramDistance(a, b, 1), 0.5);
    EXPECT_DOUBLE_EQ(ngramDistance(b, a, 1), 0.5);
    EXPECT_DOUBLE_EQ(ngramDistance(a, a, 2), 0.0);
    EXPECT_DOUBLE_EQ(ngramDistance(a, {}, 1), 1.0);
    EXPECT_DOUBLE_EQ(ngramDistance({}, {}, 1), 0.0);
}

TEST(Quality, JsonHasTheContractsKeys) {
    const Clip first = standingAt(0, 0, 0), second = standingAt(0, 1.5, M_PI);
    JudgedMotion motion;
    motion.fighters = {{&first, 0, {}}, {&second, 0, {}}};
    motion.labels = {{"a", "b", "c", "d"}};
    const auto json = qualityJson(measureQuality(motion));
    for (const char* key : {"foot_skate", "penetration", "penetration_cm", "interpenetration",
                            "interpenetration_cm", "facing_error_deg", "variety"})
        EXPECT_TRUE(json[key].is_number()) << key;
    EXPECT_EQ(json["foot_skate"], 0.0);
    EXPECT_NEAR(json["distance_m"]["mean"].get<double>(), 1.5, 1e-9);
    EXPECT_TRUE(json.contains("join_acceleration_p99_ratio"));
    EXPECT_TRUE(json["join_acceleration_p99_ratio"].is_null());
    EXPECT_TRUE(json["hit_timing_ms"].is_null());
}

TEST(Quality, OfOneFighterSaysNothingOfTwo) {
    const Clip clip = standingAt(0, 0, 0);
    JudgedMotion motion;
    motion.fighters.push_back({&clip, 0, {}});
    const Quality quality = measureQuality(motion);
    EXPECT_TRUE(quality.footSkate);
    EXPECT_FALSE(quality.facingError);
    EXPECT_FALSE(quality.interpenetration);
    EXPECT_FALSE(quality.variety);
}

}  // namespace
}  // namespace kumite
