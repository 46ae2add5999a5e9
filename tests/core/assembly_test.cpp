// Key poses that become motions out of a library's parts; parts of a take replaced.
#include "core/editing/assembly.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/editing/part_edit.h"
#include "core/editing/strike.h"
#include "core/motion/blend.h"
#include "tests/support/made_strikes.h"

namespace kumite {
namespace {

using test::StrikeKind;

/// A library of all made strikes and two walks, at 60 Hz.
const KeyLibrary& madeLibrary() {
    static const KeyLibrary keys = [] {
        auto library = std::make_shared<MotionLibrary>();
        library->rig = test::madeRig();
        library->rate = 60;
        const auto add = [&](std::string name, Clip clip) {
            LibraryMotion motion;
            motion.name = std::move(name);
            motion.standing = standingOf(clip);
            motion.sourceRate = clip.rate;
            motion.clip = std::move(clip);
            library->motions.push_back(std::move(motion));
        };
        for (const StrikeKind kind : test::kStrikeKinds) {
            for (test::MadeStrike& strike : test::madeStrikes(kind))
                add(strike.name, std::move(strike.clip));
        }
        add("walk", test::madeWalk(4));
        add("slow walk", test::madeWalk(4, 0.8));
        return keyLibrary(library);
    }();
    return keys;
}

int motionNamed(const std::string& name) {
    const auto& motions = madeLibrary().library->motions;
    for (std::size_t m = 0; m < motions.size(); ++m) {
        if (motions[m].name == name) return static_cast<int>(m);
    }
    return -1;
}

/// Keys taken out of a motion at some frames, `apart` times as far from each other.
KeyTrack keysFrom(const std::string& name, const std::vector<int>& frames, double apart = 1) {
    KeyTrack track;
    track.rig = test::madeRig();
    const Clip& clip = madeLibrary().motion(motionNamed(name)).clip;
    for (const int f : frames) {
        track = withKey(track, {static_cast<int>(apart * (f - frames.front())),
                                clip.frames[static_cast<std::size_t>(f)], Easing::Smooth});
    }
    return track;
}

double poseDifference(const Pose& a, const Pose& b) {
    double most = 0;
    for (std::size_t j = 0; j < a.turns.size(); ++j)
        most = std::max(most, a.turns[j].angularDistance(b.turns[j]));
    return most;
}

TEST(Assembly, KeysOutOfAClipFindThatClip) {
    for (const std::string name : {"hook 4", "straight kick 3", "walk"}) {
        const KeyTrack track = keysFrom(name, {2, 12, 20, 28, 36});
        const auto found = findSimilar(madeLibrary(), track);
        ASSERT_FALSE(found.empty());
        EXPECT_EQ(madeLibrary().motion(found.front().match.clip).name, name);
        EXPECT_EQ(found.front().match.mismatches, 0);
        EXPECT_LT(found.front().distance, 0.02);
        for (std::size_t i = 1; i < found.size(); ++i)
            EXPECT_LE(found[i - 1].match.mismatches, found[i].match.mismatches);
    }
}

TEST(Assembly, KeysOutOfAClipBecomeThatClip) {
    const KeyTrack track = keysFrom("hook 4", {2, 12, 20, 28, 36});
    const AssemblyPlan plan = planAssembly(madeLibrary(), track);
    for (const auto& part : plan.parts)
        EXPECT_FALSE(part) << "nothing to mend";
    AssemblySettings settings;
    settings.lockFeet = false;
    const Assembly made = assemble(madeLibrary(), track, plan, settings);
    ASSERT_EQ(made.clip.frameCount(), 35);
    const Clip& source = madeLibrary().motion(motionNamed("hook 4")).clip;
    for (int f = 0; f < 35; ++f) {
        const Pose& a = made.clip.frames[static_cast<std::size_t>(f)];
        const Pose& b = source.frames[static_cast<std::size_t>(f + 2)];
        EXPECT_LT(poseDifference(a, b), 0.35) << "frame " << f << ": the match may be a frame off";
    }
    EXPECT_NEAR((made.clip.frames.front().root - track.keys.front().pose.root).norm(), 0, 0.03)
        << "placed where the first key stands";
}

TEST(Assembly, AnotherSpeedIsFollowed) {
    const KeyTrack track = keysFrom("walk", {10, 40, 70, 100, 130}, 1.4);
    const Assembly made = assemble(madeLibrary(), track, planAssembly(madeLibrary(), track));
    EXPECT_EQ(made.clip.frameCount(), 169);
    const double way = made.clip.frames.back().root.z() - made.clip.frames.front().root.z();
    EXPECT_NEAR(way, 1.2 * 2.0, 0.35) << "the same steps in more time";
}

TEST(Assembly, APartComesFromItsOwnClipAndIsAdjusted) {
    // Legs of a walk, the right arm of a punch.
    KeyTrack track = keysFrom("walk", {10, 20, 30, 40, 50});
    const Clip& punch = madeLibrary().motion(motionNamed("straight punch 2")).clip;
    const auto parents = [] {
        std::vector<int> list;
        for (const Rig::Joint& joint : test::madeRig()->joints)
            list.push_back(joint.parent);
        return list;
    }();
    const auto parts = partsOfJoints(parents, test::madeRig()->roles);
    for (std::size_t k = 0; k < track.keys.size(); ++k) {
        for (std::size_t j = 0; j < parts.size(); ++j) {
            if (parts[j] == BodyPart::RightArm)
                track.keys[k].pose.turns[j] = punch.frames[10 * k].turns[j];
        }
    }
    const AssemblyPlan plan = planAssembly(madeLibrary(), track);
    EXPECT_NE(madeLibrary().motion(plan.body.match.clip).name.find("walk"), std::string::npos);
    const auto& arm = plan.parts[static_cast<std::size_t>(BodyPart::RightArm)];
    ASSERT_TRUE(arm);
    const std::string from = madeLibrary().motion(arm->match.clip).name;
    EXPECT_EQ(from.find("walk"), std::string::npos) << from;
    EXPECT_FALSE(plan.parts[static_cast<std::size_t>(BodyPart::LeftLeg)]);

    AssemblySettings direct;
    direct.adjusted = false;
    const Assembly plain = assemble(madeLibrary(), track, plan, direct);
    const Assembly adjusted = assemble(madeLibrary(), track, plan);
    ASSERT_FALSE(adjusted.junctions.empty());
    ASSERT_EQ(plain.clip.frameCount(), adjusted.clip.frameCount());
    const Clip query = clipOf(track);
    for (const AdjustedJunction& junction : adjusted.junctions) {
        EXPECT_EQ(junction.part, BodyPart::RightArm);
        // What the clip shows has the query's statistics, not only what is told of it.
        std::vector<Eigen::Quaterniond> shown;
        for (const Pose& pose : adjusted.clip.frames)
            shown.push_back(pose.turns[static_cast<std::size_t>(junction.joint)]);
        const AngleStatistics s = statisticsOf(anglesOf(shown, junction.values.order));
        EXPECT_NEAR((s.mean - junction.values.query.mean).norm(), 0, 1e-6);
        EXPECT_NEAR((s.deviation - junction.values.query.deviation).norm(), 0, 1e-6);
    }
    // The elbow is not a junction: as retrieved in both.
    const auto elbow = static_cast<std::size_t>(*test::madeRig()->roles[Role::RightElbow]);
    for (std::size_t f = 0; f < plain.clip.frames.size(); ++f)
        EXPECT_LT(
            plain.clip.frames[f].turns[elbow].angularDistance(adjusted.clip.frames[f].turns[elbow]),
            1e-9);
}

TEST(Assembly, ChoicesAreKept) {
    const KeyTrack track = keysFrom("straight punch 1", {2, 12, 20, 28, 36});
    AssemblyChoices choices;
    const int hook = motionNamed("hook 1");
    choices.parts[static_cast<std::size_t>(BodyPart::LeftArm)] = {
        PartChoice::Kind::Own,
        ClipRange{hook, {0, madeLibrary().motion(hook).clip.frameCount()}},
        {}};
    const int walk = motionNamed("walk");
    choices.body = ClipRange{walk, {0, 240}};
    choices.parts[static_cast<std::size_t>(BodyPart::RightArm)].kind = PartChoice::Kind::WithBody;
    const AssemblyPlan plan = planAssembly(madeLibrary(), track, choices);
    EXPECT_EQ(plan.body.match.clip, walk);
    EXPECT_EQ(plan.parts[static_cast<std::size_t>(BodyPart::LeftArm)]->match.clip, hook);
    EXPECT_FALSE(plan.parts[static_cast<std::size_t>(BodyPart::RightArm)]);
    choices.body = ClipRange{walk, {0, 3}};
    EXPECT_THROW(planAssembly(madeLibrary(), track, choices), Error) << "five keys in three frames";
}

TEST(Assembly, DrawnToTheKeysItPassesThem) {
    KeyTrack track = keysFrom("hook 4", {2, 12, 20, 28, 36});
    track.keys[2].pose.root.x() += 0.2;
    const AssemblyPlan plan = planAssembly(madeLibrary(), track);
    AssemblySettings settings;
    settings.meetKeys = 1;
    settings.lockFeet = false;
    const Assembly made = assemble(madeLibrary(), track, plan, settings);
    for (const KeyPose& key : track.keys) {
        const Pose& pose = made.clip.frames[static_cast<std::size_t>(key.frame)];
        EXPECT_LT(poseDifference(pose, key.pose), 1e-6);
        EXPECT_LT((pose.root - key.pose.root).norm(), 1e-6);
    }
}

TEST(Assembly, OneKeyAloneAndNone) {
    const KeyTrack one = keysFrom("hook 4", {20});
    const Assembly made = assemble(madeLibrary(), one, planAssembly(madeLibrary(), one));
    EXPECT_EQ(made.clip.frameCount(), 1);
    KeyTrack none = one;
    none.keys.clear();
    EXPECT_THROW(planAssembly(madeLibrary(), none), Error);
    EXPECT_THROW(planAssembly(KeyLibrary{}, one), Error);
}

TEST(PartEdit, ReplacesOneArmAndNothingElse) {
    const Clip take = test::madeWalk(3);
    const Clip& source = madeLibrary().motion(motionNamed("hook 2")).clip;
    PartEdit edit;
    edit.frames = {40, 100};
    edit.part = BodyPart::LeftArm;
    edit.sourceEnd = source.frameCount() - 1;
    const Clip result = withPart(take, source, edit);
    std::vector<int> parents;
    for (const Rig::Joint& joint : take.rig->joints)
        parents.push_back(joint.parent);
    const auto parts = partsOfJoints(parents, take.rig->roles);
    double most = 0;
    for (int f = 0; f < take.frameCount(); ++f) {
        const Pose& a = take.frames[static_cast<std::size_t>(f)];
        const Pose& b = result.frames[static_cast<std::size_t>(f)];
        EXPECT_EQ(a.root, b.root);
        for (std::size_t j = 0; j < parts.size(); ++j) {
            if (parts[j] == edit.part && edit.frames.contains(f)) {
                most = std::max(most, a.turns[j].angularDistance(b.turns[j]));
            } else {
                EXPECT_EQ(a.turns[j].coeffs(), b.turns[j].coeffs()) << f;
            }
        }
    }
    EXPECT_GT(most, 0.3);
    // In the middle the arm is the source's; at the seams nothing jumps.
    const auto elbow = static_cast<std::size_t>(*take.rig->roles[Role::LeftElbow]);
    const double middle = 30.0 / 59 * edit.sourceEnd;
    EXPECT_LT(result.frames[70].turns[elbow].angularDistance(
                  poseAt(source, middle / source.rate).turns[elbow]),
              1e-9);
    for (const std::size_t f : {40u, 99u})
        EXPECT_LT(result.frames[f].turns[elbow].angularDistance(take.frames[f].turns[elbow]), 1e-9);
    for (std::size_t f = 1; f < result.frames.size(); ++f)
        EXPECT_LT(result.frames[f].turns[elbow].angularDistance(result.frames[f - 1].turns[elbow]),
                  0.35);
}

TEST(PartEdit, ByItselfChangesNothingAndWrongRangesAreRefused) {
    const Clip take = test::madeWalk(2);
    PartEdit edit;
    edit.frames = {10, 90};
    edit.sourceBegin = 10;
    edit.sourceEnd = 89;
    edit.adjusted = true;
    const Clip same = withPart(take, take, edit);
    for (std::size_t f = 0; f < take.frames.size(); ++f)
        EXPECT_LT(poseDifference(take.frames[f], same.frames[f]), 1e-6);
    edit.frames = {10, 500};
    EXPECT_THROW(withPart(take, take, edit), Error);
    edit.frames = {10, 10};
    EXPECT_THROW(withPart(take, take, edit), Error);
    edit.frames = {10, 90};
    edit.sourceEnd = 5;
    EXPECT_THROW(withPart(take, take, edit), Error);
    edit.sourceEnd = 5000;
    EXPECT_THROW(withPart(take, take, edit), Error);
}

}  // namespace
}  // namespace kumite
