#include "core/motion/foot_lock.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/recording.h"
#include "core/motion/feet.h"
#include "core/motion/survey.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using Eigen::Vector3d;

constexpr double kRate = 60;

/// A human that stands with slightly bent knees, toes at height 0, moved by `shift(seconds)`.
Clip standingHuman(int frames, const std::function<Vector3d(double)>& shift) {
    const auto motion = test::bobbing(1, kRate, [](double) { return 0.0; });
    const Fighter fighter = test::makeFighter(motion, kRate);
    Clip clip = clipOf(*motion, motion->frames(), fighter.space, fighter.roles);
    Pose pose = clip.frames[0];
    pose.root.y() -= 0.03;
    for (const Role end : {Role::LeftAnkle, Role::RightAnkle}) {
        JointFrames world;
        jointFrames(*clip.rig, pose, world);
        const Limb limb = *limbOf(*clip.rig, end);
        reach(*clip.rig, pose, world, limb,
              world.positions[static_cast<std::size_t>(limb.end)] + Vector3d(0, 0.03, 0));
    }
    clip.frames.clear();
    for (int i = 0; i < frames; ++i) {
        clip.frames.push_back(pose);
        clip.frames.back().root += shift(i / kRate);
    }
    return clip;
}

std::vector<Vector3d> toes(const Clip& clip, bool left) {
    const JointPositions positions = positionsOf(clip);
    std::vector<Vector3d> track;
    for (int frame = 0; frame < positions.frameCount; ++frame)
        track.push_back(positions.at(frame, *footPoint(*clip.rig, left)).cast<double>());
    return track;
}

std::vector<Standing> standingFrom(int frames, int begin, int end) {
    std::vector<Standing> standing(static_cast<std::size_t>(frames), Standing{false, false});
    for (int i = begin; i < end; ++i)
        standing[static_cast<std::size_t>(i)] = {true, true};
    return standing;
}

double largestStep(const std::vector<Vector3d>& track) {
    double largest = 0;
    for (std::size_t i = 1; i < track.size(); ++i)
        largest = std::max(largest, (track[i] - track[i - 1]).norm());
    return largest;
}

TEST(FootLock, APlantedFootStaysPut) {
    // The body slides at 0.2 m/s; both feet stand in frames 30 to 79.
    const Clip clip = standingHuman(120, [](double t) { return Vector3d(0.2 * t, 0, 0); });
    const Clip locked = withLockedFeet(clip, standingFrom(120, 30, 80), {});
    for (const bool left : {true, false}) {
        const auto before = toes(clip, left), after = toes(locked, left);
        // It comes to rest within the ease, near where it was.
        for (std::size_t i = 38; i < 80; ++i)
            EXPECT_LT((after[i] - after[38]).norm(), 1e-6) << i;
        EXPECT_LT((after[38] - before[30]).norm(), 0.4 * 0.2 * 0.12 + 1e-3);
        for (std::size_t i = 31; i < 80; ++i)
            EXPECT_GT(after[i].x() - after[i - 1].x(), -1e-6) << "no way back, frame " << i;
        // Before it stands nothing is touched, and in the end all is let go.
        for (std::size_t i = 0; i < 30; ++i)
            EXPECT_LT((after[i] - before[i]).norm(), 1e-9);
        EXPECT_LT((after[90] - before[90]).norm(), 1e-6);
        // Letting go of 17 cm within 0.12 s: no faster than the quintic's 15/8 of the mean.
        EXPECT_LT(largestStep(after), 0.2 / 60 + 0.167 / 0.12 / 60 * 2.0);
    }
    // The pelvis goes on.
    EXPECT_NEAR(locked.frames[70].root.x(), clip.frames[70].root.x(), 1e-12);
}

TEST(FootLock, ToesAreNeverBelowTheFloor) {
    const Clip clip =
        standingHuman(120, [](double t) { return Vector3d(0, 0.05 * std::sin(9 * t), 0.1 * t); });
    for (const auto& standing : {standingFrom(120, 0, 0), standingFrom(120, 20, 100)}) {
        const Clip locked = withLockedFeet(clip, standing, {});
        for (const bool left : {true, false}) {
            double lowest = 1;
            for (const Vector3d& toe : toes(locked, left))
                lowest = std::min(lowest, toe.y());
            EXPECT_GT(lowest, -1e-6);
            EXPECT_LT(lowest, 1e-6);
        }
    }
}

TEST(FootLock, AFloatingFootIsBroughtDown) {
    // The whole body floats 5 cm over the floor and stands from frame 40 on: on its toes at most.
    const Clip clip = standingHuman(100, [](double) { return Vector3d(0, 0.05, 0); });
    const auto after = toes(withLockedFeet(clip, standingFrom(100, 40, 100), {}), true);
    EXPECT_NEAR(after[30].y(), 0.05, 1e-6);
    EXPECT_NEAR(after[60].y(), 0.03, 1e-6);
    EXPECT_LT(largestStep(after), 0.02 / 0.12 / 60 * 1.9);
}

TEST(FootLock, HipsLowerWhereLegsDoNotReach) {
    // The body leans 30 cm away from planted feet; from hip to ankle it is 81 cm down.
    const Clip clip = standingHuman(120, [](double t) {
        return Vector3d(0, 0, 0.3 * (t < 1 ? 0.5 - 0.5 * std::cos(M_PI * t) : 1));
    });
    FootLockSettings settings;
    settings.farthest = 0.4;
    FootLock lock(clip.rig, kRate, settings);
    const auto standing = standingFrom(120, 0, 120);
    const std::span<const Pose> poses(clip.frames);
    double before = 0, steepest = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const Pose pose = lock.show(poses.subspan(i), std::span(standing).subspan(i));
        EXPECT_NEAR(pose.root.y(), poses[i].root.y() - lock.drop(), 1e-12);
        EXPECT_NEAR(lock.correction(true).z(), poses[0].root.z() - poses[i].root.z(), 1e-6);
        steepest = std::max(steepest, std::abs(lock.drop() - before));
        before = lock.drop();
    }
    const double reach = 0.84 * 0.9985;
    EXPECT_NEAR(before, 0.81 - std::sqrt(reach * reach - 0.09), 1e-3);
    EXPECT_LT(steepest, 0.004);
}

TEST(FootLock, WhatIsTooFarIsDragged) {
    const Clip clip = standingHuman(240, [](double t) { return Vector3d(0.5 * t, 0, 0); });
    const Clip locked = withLockedFeet(clip, standingFrom(240, 10, 230), {});
    const auto raw = toes(clip, true), after = toes(locked, true);
    const Limb limb = *limbOf(*clip.rig, Role::LeftAnkle);
    const JointPositions positions = positionsOf(locked);
    for (int i = 0; i < 240; ++i) {
        EXPECT_LT((after[static_cast<std::size_t>(i)] - raw[static_cast<std::size_t>(i)]).norm(),
                  0.2501);
        const double reach =
            (positions.at(i, limb.end) - positions.at(i, limb.root)).cast<double>().norm();
        EXPECT_LT(reach, 0.84 * 0.9986);
    }
    EXPECT_GT((after[200] - raw[200]).norm(), 0.2);
    EXPECT_LT(largestStep(after), 0.5 / 60 + 0.25 / 0.12 / 60 * 2.0);
}

TEST(FootLock, AStreamIsTheSameAndCanGoBack) {
    const Clip clip = standingHuman(120, [](double t) {
        return Vector3d(0.3 * t, 0.04 * std::sin(7 * t), 0.1 * std::sin(5 * t));
    });
    auto standing = standingFrom(120, 20, 60);
    for (std::size_t i = 70; i < 110; ++i)
        standing[i] = {true, false};
    const Clip whole = withLockedFeet(clip, standing, {});
    FootLock lock(clip.rig, kRate), kept = lock;
    const std::span<const Pose> poses(clip.frames);
    const auto useful = static_cast<std::size_t>(lock.useful());
    EXPECT_EQ(useful, 10U);
    const auto show = [&](FootLock& stream, std::size_t i) {
        const std::size_t known = std::min(useful, poses.size() - i);
        return stream.show(poses.subspan(i, known), std::span(standing).subspan(i, known));
    };
    const auto expectSame = [](const Pose& a, const Pose& b) {
        EXPECT_EQ(a.root, b.root);
        for (std::size_t j = 0; j < a.turns.size(); ++j)
            EXPECT_EQ(a.turns[j].coeffs(), b.turns[j].coeffs());
    };
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (i == 50) kept = lock;
        expectSame(show(lock, i), whole.frames[i]);
    }
    for (std::size_t i = 50; i < poses.size(); ++i)
        expectSame(show(kept, i), whole.frames[i]);
}

TEST(FootLock, ARigWithoutLegsIsLeftAlone) {
    Clip clip = standingHuman(5, [](double t) { return Vector3d(t, 0, 0); });
    auto rig = std::make_shared<Rig>(*clip.rig);
    rig->roles = RoleMap();
    clip.rig = rig;
    const Clip same = withLockedFeet(clip);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(same.frames[i].root, clip.frames[i].root);
        for (std::size_t j = 0; j < clip.frames[i].turns.size(); ++j)
            EXPECT_EQ(same.frames[i].turns[j].coeffs(), clip.frames[i].turns[j].coeffs());
    }
    EXPECT_THROW(withLockedFeet(clip, {}, {}), Error);
}

TEST(FootLock, RecordingsSkateLess) {
    KUMITE_NEEDS_DATA();
    for (const char* name : {"cmu_salsa/60_01.bvh", "cmu_karate/martial_04.bvh"}) {
        SCOPED_TRACE(name);
        const Recording recording = readRecording(*test::dataFolder() / name);
        const Motion& motion = *recording.motions.front();
        const Survey survey = surveyMotion(motion);
        const double rate = name[4] == 's' ? 60 : 120;
        const Clip clip =
            clipOf(motion, {1, motion.frameCount}, survey.space, survey.roles.roles, rate);
        const Clip locked = withLockedFeet(clip);
        const auto standing = standingOf(clip);
        double worst = 0, slide = 0, slideBefore = 0, lowest = 1, mean = 0;
        const JointPositions before = positionsOf(clip), after = positionsOf(locked);
        for (const bool left : {true, false}) {
            const int point = *footPoint(*clip.rig, left);
            const double floor = restHeight(before, point);
            for (int i = 1; i < clip.frameCount(); ++i) {
                lowest = std::min(lowest, after.at(i, point).y() - floor);
                const auto at = static_cast<std::size_t>(i);
                if (!standing[at][left ? 0 : 1] || !standing[at - 1][left ? 0 : 1]) continue;
                const auto step = [&](const JointPositions& p) {
                    const Eigen::Vector3f way = p.at(i, point) - p.at(i - 1, point);
                    return std::hypot(way.x(), way.z());
                };
                slide += step(after);
                slideBefore += step(before);
            }
        }
        for (std::size_t i = 0; i < clip.frames.size(); ++i) {
            for (std::size_t j = 0; j < clip.frames[i].turns.size(); ++j)
                worst = std::max(
                    worst, clip.frames[i].turns[j].angularDistance(locked.frames[i].turns[j]));
            mean += (clip.frames[i].root - locked.frames[i].root).norm() / clip.frameCount();
        }
        EXPECT_LT(slide, 0.25 * slideBefore);
        EXPECT_GT(lowest, -1e-4);
        EXPECT_LT(worst, 1.2);
        EXPECT_LT(mean, 0.02);
    }
}

}  // namespace
}  // namespace kumite
