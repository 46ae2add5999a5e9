#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/base/text.h"
#include "core/formats/bvh.h"
#include "core/motion/kinematics.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::dataFolder;
using test::readText;

std::shared_ptr<const Motion> readBack(const std::string& text) {
    const Recording recording = readBvh(text, "written.bvh");
    EXPECT_EQ(recording.motions.size(), 1U);
    recording.motions.front()->validate();
    return recording.motions.front();
}

std::string textOf(const Motion& motion) {
    return bvhText(motion, motion.frames(), motion.frameTime);
}

void expectSameBits(const std::vector<double>& a, const std::vector<double>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void expectSameSkeleton(const Skeleton& a, const Skeleton& b) {
    ASSERT_EQ(a.jointCount(), b.jointCount());
    for (std::size_t i = 0; i < a.joints.size(); ++i) {
        EXPECT_EQ(a.joints[i].name, b.joints[i].name);
        EXPECT_EQ(a.joints[i].parent, b.joints[i].parent);
        EXPECT_EQ(a.joints[i].offset, b.joints[i].offset);
        EXPECT_EQ(a.joints[i].channels, b.joints[i].channels);
        EXPECT_EQ(a.joints[i].isEndSite, b.joints[i].isEndSite);
    }
}

/// The largest distance between joints of two motions at the same frames, file units.
double largestDistance(const Motion& a, const Motion& b) {
    const SpaceConvention asItIs{1.0, UpAxis::Y};
    const JointPositions first = forwardKinematics(a, a.frames(), asItIs);
    const JointPositions second = forwardKinematics(b, b.frames(), asItIs);
    EXPECT_EQ(first.xyz.size(), second.xyz.size());
    double largest = 0;
    for (int frame = 0; frame < first.frameCount; ++frame) {
        for (int joint = 0; joint < first.jointCount; ++joint) {
            const double distance = (first.at(frame, joint) - second.at(frame, joint)).norm();
            largest = std::max(largest, distance);
        }
    }
    return largest;
}

TEST(BvhWriter, WritesTheTextThatIsExpected) {
    const std::string text =
        "HIERARCHY\n"
        "ROOT Hips\n"
        "{\n"
        "\tOFFSET 0 1.5 -0\n"
        "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
        "\tJOINT Left Up Leg\n"
        "\t{\n"
        "\t\tOFFSET 0.1 1e-09 0\n"
        "\t\tCHANNELS 0\n"
        "\t\tEnd Site\n"
        "\t\t{\n"
        "\t\t\tOFFSET 0 -3 0\n"
        "\t\t}\n"
        "\t}\n"
        "\tJOINT mixamorig:Spine.1\n"
        "\t{\n"
        "\t\tOFFSET 1 2 3\n"
        "\t\tCHANNELS 1 Yrotation\n"
        "\t}\n"
        "}\n"
        "MOTION\n"
        "Frames: 2\n"
        "Frame Time: 0.0083333\n"
        "1 -0 0.3333333333333333 4 5 6 7\n"
        "1e-300 2 3 4 5 6 -179.5\n";
    EXPECT_EQ(textOf(*readBack(text)), text);
}

TEST(BvhWriter, WritesAStretchOfFrames) {
    Skeleton skeleton;
    skeleton.joints.push_back({.name = "A", .channels = {Channel::Xrotation}});
    skeleton.channelCount = 1;
    Motion motion;
    motion.skeleton = std::make_shared<const Skeleton>(skeleton);
    motion.frameCount = 4;
    motion.channels = {1, 2, 3, 4};
    EXPECT_EQ(readBack(bvhText(motion, {1, 3}, 0.5))->channels, (std::vector<double>{2, 3}));
    EXPECT_EQ(readBack(bvhText(motion, {1, 3}, 0.5))->frameTime, 0.5);
}

TEST(BvhWriter, GivesRealRecordingsBackBitForBit) {
    KUMITE_NEEDS_DATA();
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*dataFolder())) {
        if (entry.path().extension() != ".bvh") continue;
        ++files;
        SCOPED_TRACE(entry.path().filename().string());
        for (const auto& motion : readBvh(readText(entry.path()), "read").motions) {
            const auto again = readBack(textOf(*motion));
            expectSameSkeleton(*motion->skeleton, *again->skeleton);
            expectSameBits(motion->channels, again->channels);
            EXPECT_EQ(motion->frameTime, again->frameTime);
        }
    }
    EXPECT_GE(files, 18);
}

/// A skeleton with random tree, names and channels, and values from all of what a double can be.
Motion randomMotion(std::mt19937_64& random) {
    const auto pick = [&](std::uint64_t count) { return static_cast<int>(random() % count); };
    static const std::vector<std::string> kNames = {"Hips", "a b", "x:y.z", "左足", "JOINT", "End"};
    auto skeleton = std::make_shared<Skeleton>();
    std::vector<int> path;  // from the root to the joint added last
    const int count = 1 + pick(12);
    for (int i = 0; i < count; ++i) {
        if (i > 0) path.resize(static_cast<std::size_t>(1 + pick(path.size())));
        Joint joint;
        joint.name = kNames[static_cast<std::size_t>(pick(kNames.size()))];
        joint.parent = i == 0 ? -1 : path.back();
        joint.offset = Eigen::Vector3d::Random() * 100;
        joint.firstChannel = skeleton->channelCount;
        std::vector<Channel> all = {Channel::Xposition, Channel::Yposition, Channel::Zposition,
                                    Channel::Xrotation, Channel::Yrotation, Channel::Zrotation};
        std::shuffle(all.begin(), all.end(), random);
        all.resize(static_cast<std::size_t>(i == 0 ? 1 + pick(6) : pick(7)));
        joint.channels = all;
        skeleton->channelCount += static_cast<int>(all.size());
        path.push_back(i);
        skeleton->joints.push_back(joint);
    }
    Motion motion;
    motion.frameTime = 1.0 / (1 + pick(500));
    motion.frameCount = 1 + pick(5);
    const auto size = static_cast<std::size_t>(motion.frameCount * skeleton->channelCount);
    while (motion.channels.size() < size) {
        const std::uint64_t bits = random();
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (std::isfinite(value)) motion.channels.push_back(value);
    }
    motion.skeleton = std::move(skeleton);
    return motion;
}

TEST(BvhWriter, GivesAnyMotionBack) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 500; ++i) {
        const Motion motion = randomMotion(random);
        const auto again = readBack(textOf(motion));
        expectSameSkeleton(*motion.skeleton, *again->skeleton);
        expectSameBits(motion.channels, again->channels);
        EXPECT_EQ(motion.frameTime, again->frameTime);
        EXPECT_EQ(textOf(*again), textOf(motion));
        if (HasFailure()) FAIL() << textOf(motion);
    }
}

/// A root and an arm of two bones that rotate in frames of their own, over `frames` frames.
Motion motionWithFrames(int frames, std::mt19937& random) {
    auto skeleton = std::make_shared<Skeleton>();
    std::uniform_real_distribution<double> angle(-180, 180);
    const auto frameOf = [&] {
        return (Eigen::AngleAxisd(angle(random), Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(angle(random), Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    };
    skeleton->joints = {
        {.name = "root",
         .channels = {Channel::Xposition, Channel::Yposition, Channel::Zposition,
                      Channel::Zrotation, Channel::Yrotation, Channel::Xrotation}},
        {.name = "humerus",
         .parent = 0,
         .offset = {0, 5, 1},
         .rotationFrame = frameOf(),
         .channels = {Channel::Zrotation, Channel::Yrotation, Channel::Xrotation},
         .firstChannel = 6},
        {.name = "radius",
         .parent = 1,
         .offset = {3, 0, 0},
         .rotationFrame = frameOf(),
         .channels = {Channel::Yposition, Channel::Xrotation},
         .firstChannel = 9},
        {.name = "radius End Site",
         .parent = 2,
         .offset = {2, 1, 0},
         .channels = {},
         .firstChannel = 11,
         .isEndSite = true},
    };
    skeleton->channelCount = 11;
    Motion motion;
    motion.skeleton = skeleton;
    motion.frameCount = frames;
    for (int i = 0; i < 11 * frames; ++i)
        motion.channels.push_back(angle(random));
    return motion;
}

TEST(BvhWriter, ConvertsRotationsInFramesOfTheirOwn) {
    std::mt19937 random(6);
    for (int i = 0; i < 50; ++i) {
        const Motion motion = motionWithFrames(20, random);
        const auto again = readBack(textOf(motion));
        EXPECT_EQ(again->skeleton->joints[0].channels, motion.skeleton->joints[0].channels);
        EXPECT_EQ(again->skeleton->joints[2].channels,
                  (std::vector{Channel::Yposition, Channel::Zrotation, Channel::Yrotation,
                               Channel::Xrotation}));
        for (int frame = 0; frame < 20; ++frame) {
            for (std::size_t joint = 0; joint < 3; ++joint) {
                const Eigen::Matrix3d a =
                    localRotation(motion.skeleton->joints[joint], motion.frame(frame));
                const Eigen::Matrix3d b =
                    localRotation(again->skeleton->joints[joint], again->frame(frame));
                EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-12);
            }
        }
        EXPECT_LT(largestDistance(motion, *again), 1e-4);  // floats at 300 units
    }
}

TEST(BvhWriter, ConvertsAtTheGimbalLock) {
    std::mt19937 random(7);
    Motion motion = motionWithFrames(1, random);
    auto skeleton = std::make_shared<Skeleton>(*motion.skeleton);
    // A quarter turn about x makes the bone's z rotation a y rotation of the file.
    skeleton->joints[1].rotationFrame =
        Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
    motion.skeleton = skeleton;
    for (const double nearLock : {90.0, -90.0, 90.0 + 1e-9, 90.0 - 1e-13, -90.0 - 1e-6, 270.0}) {
        motion.channels = {0, 0, 0, 0, 0, 0, nearLock, 0, 25, 0, 0};
        const auto again = readBack(textOf(motion));
        const Eigen::Matrix3d a = localRotation(motion.skeleton->joints[1], motion.frame(0));
        const Eigen::Matrix3d b = localRotation(again->skeleton->joints[1], again->frame(0));
        EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-12) << nearLock;
    }
}

TEST(BvhWriter, WritesConvertedAnglesWithoutJumps) {
    std::mt19937 random(8);
    Motion motion = motionWithFrames(1, random);
    motion.frameCount = 720;
    motion.channels.clear();
    auto skeleton = std::make_shared<Skeleton>(*motion.skeleton);
    skeleton->joints[1].rotationFrame =
        Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()).toRotationMatrix();
    motion.skeleton = skeleton;
    for (int frame = 0; frame < 720; ++frame) {  // two turns about z
        motion.channels.insert(motion.channels.end(), {0, 0, 0, 0, 0, 0, 1.0 * frame, 0, 0, 0, 0});
    }
    const auto again = readBack(textOf(motion));
    for (int frame = 1; frame < 720; ++frame) {
        for (std::size_t c = 6; c < 9; ++c) {
            EXPECT_LT(std::abs(again->frame(frame)[c] - again->frame(frame - 1)[c]), 2.0);
        }
    }
    EXPECT_NEAR(again->frame(719)[6], 719, 15);
}

}  // namespace
}  // namespace kumite
