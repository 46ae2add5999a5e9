// Key poses on a timeline, their file, and what hostile ones are told.
#include "core/editing/key_track.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/editing/key_file.h"
#include "core/editing/pose_handles.h"
#include "core/motion/blend.h"
#include "tests/support/made_strikes.h"

namespace kumite {
namespace {

using Eigen::Vector3d;
using test::StrikeKind;

Pose strikePose(int frame) {
    static const auto strike =
        test::asExamples(test::madeStrikes(StrikeKind::StraightPunch)).front();
    return strike.clip
        .frames[static_cast<std::size_t>(std::clamp(frame, 0, strike.clip.frameCount() - 1))];
}

KeyTrack threeKeys() {
    KeyTrack track;
    track.rig = test::madeRig();
    track = withKey(track, {30, strikePose(30), Easing::Smooth});
    track = withKey(track, {0, strikePose(0), Easing::Smooth});
    track = withKey(track, {12, strikePose(18), Easing::Linear});
    return track;
}

std::vector<int> framesOf(const KeyTrack& track) {
    std::vector<int> frames;
    for (const KeyPose& key : track.keys)
        frames.push_back(key.frame);
    return frames;
}

double difference(const Pose& a, const Pose& b) {
    double most = (a.root - b.root).norm();
    for (std::size_t j = 0; j < a.turns.size(); ++j)
        most = std::max(most, a.turns[j].angularDistance(b.turns[j]));
    return most;
}

TEST(KeyTrack, KeepsItsKeysInOrderOnePerFrame) {
    KeyTrack track = threeKeys();
    EXPECT_EQ(framesOf(track), (std::vector<int>{0, 12, 30}));
    validate(track);
    track = withKey(track, {12, strikePose(5), Easing::Hold});
    EXPECT_EQ(framesOf(track), (std::vector<int>{0, 12, 30})) << "two keys in one frame: the later";
    EXPECT_LT(difference(track.keys[1].pose, strikePose(5)), 1e-12);
    track = withMovedKey(track, 0, 20);
    EXPECT_EQ(framesOf(track), (std::vector<int>{12, 20, 30}));
    track = withMovedKey(track, 12, 30);
    EXPECT_EQ(framesOf(track), (std::vector<int>{20, 30}));
    track = withCopiedKey(track, 20, 50);
    EXPECT_LT(difference(track.keys[0].pose, track.keys[2].pose), 1e-12);
    track = withoutKey(track, 20);
    EXPECT_EQ(framesOf(track), (std::vector<int>{30, 50}));
    track = withEasing(track, 30, Easing::Out);
    EXPECT_EQ(track.keys[0].easing, Easing::Out);
    EXPECT_THROW(withoutKey(track, 20), Error);
    EXPECT_THROW(withMovedKey(track, 1, 2), Error);
    EXPECT_THROW(withEasing(track, 31, Easing::In), Error);
}

TEST(KeyTrack, RetimesWhatFollows) {
    const KeyTrack track = threeKeys();
    EXPECT_EQ(framesOf(withShiftedKeys(track, 12, 20)), (std::vector<int>{0, 20, 38}));
    EXPECT_EQ(framesOf(withShiftedKeys(track, 12, 1)), (std::vector<int>{0, 1, 19}));
    EXPECT_THROW(withShiftedKeys(track, 12, 0), Error);
    EXPECT_THROW(withShiftedKeys(track, 0, -1), Error);
    EXPECT_THROW(withShiftedKeys(track, 5, 9), Error);
    EXPECT_EQ(framesOf(retimed(track, 0, 2)), (std::vector<int>{0, 24, 60}));
    EXPECT_EQ(framesOf(retimed(track, 12, 0.5)), (std::vector<int>{0, 12, 21}));
    EXPECT_EQ(framesOf(retimed(track, 0, 0.001)), (std::vector<int>{0, 1, 2})) << "apart";
    EXPECT_THROW(retimed(track, 0, 0), Error);
    EXPECT_THROW(retimed(track, 0, -1), Error);
    EXPECT_THROW(retimed(track, 0, 1e300), Error);
    EXPECT_THROW(retimed(track, 5, 2), Error);
}

TEST(KeyTrack, PassesItsKeysAndEasesBetween) {
    const KeyTrack track = threeKeys();
    for (const KeyPose& key : track.keys)
        EXPECT_LT(difference(poseAt(track, key.frame), key.pose), 1e-9);
    EXPECT_LT(difference(poseAt(track, -5), track.keys.front().pose), 1e-12);
    EXPECT_LT(difference(poseAt(track, 99), track.keys.back().pose), 1e-12);
    EXPECT_LT(difference(poseAt(track, 21), blend(track.keys[1].pose, track.keys[2].pose, 0.5)),
              1e-9);
    for (const Easing easing :
         {Easing::Linear, Easing::Smooth, Easing::In, Easing::Out, Easing::Hold}) {
        EXPECT_EQ(eased(easing, 0), 0);
        EXPECT_EQ(eased(easing, 1), 1);
        EXPECT_EQ(easingFromName(easingName(easing)), easing);
        for (double t = 0.1; t < 1; t += 0.1)
            EXPECT_GE(eased(easing, t), eased(easing, t - 0.1));
    }
    EXPECT_EQ(eased(Easing::Hold, 0.99), 0);
    EXPECT_FALSE(easingFromName("bouncy"));
    const Clip clip = clipOf(track);
    EXPECT_EQ(clip.frameCount(), 31);
    EXPECT_LT(difference(clip.frames[12], track.keys[1].pose), 1e-9);
    KeyTrack one = track;
    one.keys.resize(1);
    EXPECT_EQ(clipOf(one).frameCount(), 1);
}

TEST(KeyTrack, RefusesWhatDoesNotFit) {
    KeyTrack track = threeKeys();
    track.keys[1].pose.turns.pop_back();
    EXPECT_THROW(validate(track), Error);
    track = threeKeys();
    std::swap(track.keys[0], track.keys[1]);
    EXPECT_THROW(validate(track), Error);
    EXPECT_THROW(validate(KeyTrack{}), Error);
}

/// Poses of the made punch by the name "punch".
Pose punchPose(const std::string& clip, int frame) {
    if (clip != "punch") throw Error("There is no clip \"" + clip + "\"; there is punch.");
    return strikePose(frame);
}

KeyTrack parse(const std::string& text) {
    return parseKeys(text, "keys.json", test::madeRig(), punchPose);
}

TEST(KeyFile, GivesBackWhatWasWritten) {
    const KeyTrack track = threeKeys();
    const KeyTrack back = parse(keysText(track));
    ASSERT_EQ(framesOf(back), framesOf(track));
    EXPECT_EQ(back.rate, track.rate);
    for (std::size_t k = 0; k < track.keys.size(); ++k) {
        EXPECT_LT(difference(back.keys[k].pose, track.keys[k].pose), 1e-7);
        EXPECT_EQ(back.keys[k].easing, track.keys[k].easing);
    }
    EXPECT_EQ(keysText(back), keysText(parse(keysText(back))));
}

TEST(KeyFile, PosesByClipMirrorTurnsPlaceAndHandles) {
    const KeyTrack track = parse(R"({"key_poses": 1, "rate": 30, "keys": [
        {"frame": 20, "clip": "punch", "at": 18, "easing": "linear"},
        {"frame": 0, "clip": "punch", "place": {"x": 1, "z": -2, "yaw": 90, "height": 0.8}},
        {"frame": 30, "mirror": true},
        {"frame": 40, "turns": {"LeftElbow": [0, -90, 0], "head": [1, 0, 0, 0]},
         "handles": {"right_hand": [-0.2, 1.3, 0.45]}}]})");
    EXPECT_EQ(framesOf(track), (std::vector<int>{0, 20, 30, 40})) << "out of order is put in order";
    EXPECT_EQ(track.rate, 30);
    const Rig& rig = *track.rig;
    EXPECT_LT(difference(track.keys[1].pose, strikePose(18)), 1e-9);
    EXPECT_EQ(track.keys[1].easing, Easing::Linear);
    const Pose& first = track.keys[0].pose;
    EXPECT_NEAR((first.root - Vector3d(1, 0.8, -2)).norm(), 0, 1e-9);
    EXPECT_NEAR(headingOf(rig, first).value(), std::numbers::pi / 2, 1e-9);
    // In the order of the file, a key without a clip goes on from the one before.
    EXPECT_LT(difference(track.keys[2].pose, mirrored(rig, first)), 1e-9);
    const Pose& last = track.keys[3].pose;
    EXPECT_NEAR(
        last.turns[std::size_t(*rig.roles[Role::LeftElbow])].angularDistance(
            Eigen::Quaterniond(Eigen::AngleAxisd(-std::numbers::pi / 2, Vector3d::UnitY()))),
        0, 1e-9);
    const Pose home = moved(last, toOrigin(rig, last));
    EXPECT_NEAR((*handlePoint(rig, home, Handle::RightHand) - Vector3d(-0.2, 1.3, 0.45)).norm(), 0,
                1e-3);
}

TEST(KeyFile, HostileOnesAreToldWhatIsWrong) {
    const auto wrong = [](const std::string& text, const std::string& word) {
        try {
            parse(text);
            ADD_FAILURE() << "accepted: " << text;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("keys.json"), std::string::npos)
                << error.what();
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    };
    const auto keys = [](const std::string& list) {
        return "{\"key_poses\": 1, \"keys\": [" + list + "]}";
    };
    wrong("", "");
    wrong("{", "");
    wrong("[1, 2]", "key_poses");
    wrong("{}", "key_poses");
    wrong("{\"key_poses\": 2, \"keys\": []}", "version");
    wrong("{\"key_poses\": 1}", "keys");
    wrong("{\"key_poses\": 1, \"keys\": 7}", "keys");
    wrong("{\"key_poses\": 1, \"rate\": -5, \"keys\": [{\"frame\": 0}]}", "rate");
    wrong("{\"key_poses\": 1, \"rate\": 1e9, \"keys\": [{\"frame\": 0}]}", "rate");
    wrong(keys(""), "at least one");
    wrong(keys("7"), "keys[0]");
    wrong(keys("{}"), "frame");
    wrong(keys("{\"frame\": -1}"), "frame");
    wrong(keys("{\"frame\": 1e300}"), "frame");
    wrong(keys("{\"frame\": 2.5}"), "frame");
    wrong(keys("{\"frame\": 3}, {\"frame\": 3}"), "another key");
    wrong(keys("{\"frame\": 0, \"clip\": \"kick\"}"), "no clip");
    wrong(keys("{\"frame\": 0, \"at\": 4}"), "clip");
    wrong(keys("{\"frame\": 0, \"pose\": 4}"), "pose");
    wrong(keys("{\"frame\": 0, \"easing\": \"bouncy\"}"), "easing");
    wrong(keys("{\"frame\": 0, \"mirror\": 1}"), "mirror");
    wrong(keys("{\"frame\": 0, \"turns\": {\"Tail\": [0, 0, 0]}}"), "Tail");
    wrong(keys("{\"frame\": 0, \"turns\": {\"Chest\": [0, 0]}}"), "Chest");
    wrong(keys("{\"frame\": 0, \"turns\": {\"Chest\": [0, 0, 0, 0]}}"), "Chest");
    wrong(keys("{\"frame\": 0, \"turns\": {\"Chest\": [1e400, 0, 0]}}"), "");
    wrong(keys("{\"frame\": 0, \"turns\": {\"Chest\": [\"a\", 0, 0]}}"), "Chest");
    wrong(keys("{\"frame\": 0, \"root\": [0, 0, 1e200]}"), "root");
    wrong(keys("{\"frame\": 0, \"handles\": {\"tail\": [0, 0, 0]}}"), "tail");
    wrong(keys("{\"frame\": 0, \"handles\": {\"left_hand\": [0, 9, 0]}}"), "out of reach");
    wrong(keys("{\"frame\": 0, \"place\": {\"w\": 0}}"), "\"w\"");
}

}  // namespace
}  // namespace kumite
