#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/formats/amc.h"
#include "core/formats/bvh.h"
#include "core/formats/recording.h"
#include "core/motion/kinematics.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::dataFolder;
using test::readText;

/// A root, an upper arm turned by 90° about z, a forearm that bends about its y and x, and a hand
/// without a dof.
const std::string kAsf =
    "# a comment\n"
    ":version 1.10\n"
    ":name test\n"
    ":units\n"
    "  mass 1.0\n"
    "  length 0.45\n"
    "  angle deg\n"
    ":documentation\n"
    "   begin of a text that means nothing: dof rx\n"
    ":root\n"
    "   order TX TY TZ RX RY RZ\n"
    "   axis XYZ\n"
    "   position 0 0 0\n"
    "   orientation 0 0 0\n"
    ":bonedata\n"
    "  begin\n"
    "     id 1\n"
    "     name upper\n"
    "     direction 1 0 0\n"
    "     length 2\n"
    "     axis 0 0 90 XYZ\n"
    "    dof rx ry rz\n"
    "    limits (-160.0 20.0)\n"
    "           (-inf inf)\n"
    "           ( -60.0 70.0 )\n"
    "  end\n"
    "  begin\n"
    "     id 2\n"
    "     name lower\n"
    "     direction 0 1 0\n"
    "     length 3\n"
    "     axis 0 0 0 XYZ\n"
    "    dof ry rx\n"
    "  end\n"
    "  begin\n"
    "     id 3 name hand direction 0 0 1 length 0.5 axis 10 20 30 ZYX\n"
    "  end\n"
    ":hierarchy\n"
    "  begin\n"
    "    root upper\n"
    "    upper lower\n"
    "    lower hand\n"
    "  end\n";
const std::string kAmc =
    "#!OML:ASF\n"
    ":FULLY-SPECIFIED\n"
    ":DEGREES\n"
    "1\n"
    "root 1 2 3 4 5 6\n"
    "upper 7 8 9\n"
    "lower 10 11\n"
    "2\n"
    "root 0 0 0 0 0 0\n"
    "upper 0 0 0\n"
    "lower -0 1e-3\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::shared_ptr<const Motion> read(const std::string& asf, const std::string& amc) {
    const AsfSkeleton skeleton = readAsf(asf, "a.asf");
    skeleton.skeleton->validate();
    const Recording recording = readAmc(amc, "a.amc", skeleton);
    recording.motions.front()->validate();
    return recording.motions.front();
}

std::string messageFor(const std::string& asf, const std::string& amc) {
    try {
        read(asf, amc);
        return "read";
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(Asf, TurnsBonesIntoJoints) {
    const AsfSkeleton asf = readAsf(kAsf, "a.asf");
    EXPECT_TRUE(asf.degrees);
    EXPECT_EQ(asf.unitLength, 0.45);
    EXPECT_TRUE(asf.findings.empty());
    const Skeleton& skeleton = *asf.skeleton;
    ASSERT_EQ(skeleton.jointCount(), 5);
    EXPECT_EQ(skeleton.channelCount, 11);
    EXPECT_EQ(skeleton.joints[0].name, "root");
    EXPECT_EQ(skeleton.joints[1].name, "upper");
    EXPECT_EQ(skeleton.joints[1].offset, Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(skeleton.joints[2].offset, Eigen::Vector3d(2, 0, 0));
    EXPECT_EQ(skeleton.joints[3].name, "hand");
    EXPECT_EQ(skeleton.joints[3].offset, Eigen::Vector3d(0, 3, 0));
    EXPECT_TRUE(skeleton.joints[3].channels.empty());
    EXPECT_EQ(skeleton.joints[4].name, "hand End Site");
    EXPECT_EQ(skeleton.joints[4].offset, Eigen::Vector3d(0, 0, 0.5));
    EXPECT_TRUE(skeleton.joints[4].isEndSite);
    // R = Rz · Ry · Rx for rx ry rz, R = Rx · Ry for ry rx.
    EXPECT_EQ(skeleton.joints[0].channels,
              (std::vector{Channel::Xposition, Channel::Yposition, Channel::Zposition,
                           Channel::Zrotation, Channel::Yrotation, Channel::Xrotation}));
    EXPECT_EQ(skeleton.joints[1].channels,
              (std::vector{Channel::Zrotation, Channel::Yrotation, Channel::Xrotation}));
    EXPECT_EQ(skeleton.joints[2].channels, (std::vector{Channel::Xrotation, Channel::Yrotation}));
    Eigen::Matrix3d quarterTurn;
    quarterTurn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    EXPECT_TRUE(skeleton.joints[1].rotationFrame.isApprox(quarterTurn, 1e-12));
    EXPECT_EQ(skeleton.joints[2].rotationFrame, Eigen::Matrix3d::Identity());
}

TEST(Asf, MultipliesTheAxisInItsOrder) {
    const double degree = std::numbers::pi / 180;
    const Eigen::Matrix3d x = Eigen::AngleAxisd(10 * degree, Eigen::Vector3d::UnitX()).matrix();
    const Eigen::Matrix3d y = Eigen::AngleAxisd(20 * degree, Eigen::Vector3d::UnitY()).matrix();
    const Eigen::Matrix3d z = Eigen::AngleAxisd(30 * degree, Eigen::Vector3d::UnitZ()).matrix();
    const Skeleton zyx = *readAsf(kAsf, "a.asf").skeleton;
    EXPECT_TRUE(zyx.joints[3].rotationFrame.isApprox(x * y * z, 1e-12));
    const Skeleton xyz = *readAsf(replaced(kAsf, "30 ZYX", "30 xyz"), "a.asf").skeleton;
    EXPECT_TRUE(xyz.joints[3].rotationFrame.isApprox(z * y * x, 1e-12));
}

TEST(Amc, PutsValuesIntoTheirChannels) {
    const AsfSkeleton asf = readAsf(kAsf, "a.asf");
    const Recording recording = readAmc(kAmc, "a.amc", asf);
    EXPECT_EQ(recording.format, "ASF/AMC");
    ASSERT_EQ(recording.motions.size(), 1U);
    const Motion& motion = *recording.motions.front();
    EXPECT_EQ(motion.frameCount, 2);
    EXPECT_EQ(motion.channels, (std::vector<double>{1, 2, 3, 6, 5, 4, 9, 8, 7, 11,    10,  //
                                                    0, 0, 0, 0, 0, 0, 0, 0, 0, 0.001, 0}));
    EXPECT_TRUE(std::signbit(motion.channels.back()));
    EXPECT_EQ(motion.frameTime, 1.0 / 120.0);
    ASSERT_EQ(recording.findings.size(), 1U);
    EXPECT_EQ(recording.findings[0].severity, Severity::Note);
    EXPECT_NE(recording.findings[0].text.find("120 Hz"), std::string::npos);
}

/// Worked out by hand. The upper arm's frame is turned by 90° about z, so its own x axis is the
/// file's y: rx 90 turns the bone, which lies along x, to -z. The forearm along y stays on y.
TEST(Amc, RotatesInTheFrameOfTheBone) {
    const auto motion = read(kAsf,
                             ":DEGREES\n1\nroot 1 2 3 0 0 0\nupper 90 0 0\nlower 0 0\n"
                             "2\nroot 0 0 0 0 0 90\nupper 0 0 0\nlower 0 90\n");
    const JointPositions at = forwardKinematics(*motion, motion->frames(), {1.0, UpAxis::Y});
    EXPECT_LT((at.at(0, 1) - Eigen::Vector3f(1, 2, 3)).norm(), 1e-6F);
    EXPECT_LT((at.at(0, 2) - Eigen::Vector3f(1, 2, 1)).norm(), 1e-6F);
    EXPECT_LT((at.at(0, 3) - Eigen::Vector3f(1, 5, 1)).norm(), 1e-6F);
    EXPECT_LT((at.at(0, 4) - Eigen::Vector3f(1.5, 5, 1)).norm(), 1e-6F);
    // The root turns all by 90° about z; the forearm, now along -x, bends about its x: y to z.
    EXPECT_LT((at.at(1, 2) - Eigen::Vector3f(0, 2, 0)).norm(), 1e-6F);
    EXPECT_LT((at.at(1, 3) - Eigen::Vector3f(0, 2, 3)).norm(), 1e-6F);
}

TEST(Amc, TakesRadians) {
    const std::string asf = replaced(replaced(kAsf, "angle deg", "angle rad"), "axis 0 0 90",
                                     "axis 0 0 1.5707963267948966");
    const AsfSkeleton skeleton = readAsf(asf, "a.asf");
    EXPECT_FALSE(skeleton.degrees);
    EXPECT_TRUE(skeleton.skeleton->joints[1].rotationFrame.isApprox(
        readAsf(kAsf, "a.asf").skeleton->joints[1].rotationFrame, 1e-12));
    const std::string radians = "1\nroot 1 2 3 0 0 3.141592653589793\nupper 0 0 0\nlower 0 0\n";
    for (const std::string header : {"", ":RADIANS\n", ":FULLY-SPECIFIED\n:radians\n"}) {
        EXPECT_NEAR(read(asf, header + radians)->channels[3], 180, 1e-12);
        EXPECT_EQ(read(asf, header + radians)->channels[2], 3);
    }
    // What the motion says about its own angles counts.
    EXPECT_EQ(read(asf, kAmc)->channels[3], 6);
}

TEST(Amc, TakesAnyRootOrder) {
    const std::string asf =
        replaced(replaced(kAsf, "TX TY TZ RX RY RZ", "RZ RX RY TZ TX TY"), "axis XYZ", "axis ZYX");
    const auto motion = read(asf, kAmc);
    // Rz is applied first: R = Rx · Ry · Rz.
    EXPECT_EQ(motion->skeleton->joints[0].channels,
              (std::vector{Channel::Zposition, Channel::Xposition, Channel::Yposition,
                           Channel::Xrotation, Channel::Yrotation, Channel::Zrotation}));
    EXPECT_EQ(std::vector<double>(motion->channels.begin(), motion->channels.begin() + 6),
              (std::vector<double>{4, 5, 6, 2, 3, 1}));
}

TEST(Amc, AddsTheRootsPositionAndOrientation) {
    const std::string asf = replaced(replaced(kAsf, "position 0 0 0", "position 10 20 30"),
                                     "orientation 0 0 0", "orientation 1 2 3");
    const auto motion = read(asf, kAmc);
    EXPECT_EQ(std::vector<double>(motion->channels.begin(), motion->channels.begin() + 6),
              (std::vector<double>{11, 22, 33, 9, 7, 5}));
}

TEST(Amc, AddsTheOffsetToTranslationsOfBones) {
    const std::string asf = replaced(kAsf, "dof ry rx", "dof tx ry tz l");
    const AsfSkeleton skeleton = readAsf(asf, "a.asf");
    ASSERT_EQ(skeleton.findings.size(), 1U);
    EXPECT_EQ(skeleton.findings[0].text, "Bone lower changes its length: that is not used.");
    const auto motion = read(asf, replaced(replaced(kAmc, "lower 10 11", "lower 10 11 12 13"),
                                           "lower -0 1e-3", "lower 0 0 0 0"));
    EXPECT_EQ(motion->skeleton->joints[2].channels,
              (std::vector{Channel::Xposition, Channel::Zposition, Channel::Yrotation}));
    EXPECT_EQ(motion->frame(0)[9], 12);  // 10 and the offset 2
    EXPECT_EQ(motion->frame(0)[10], 12);
    EXPECT_EQ(motion->frame(0)[11], 11);
}

TEST(Amc, TakesSloppyText) {
    std::string asf = kAsf;
    std::string amc = kAmc;
    for (std::string* text : {&asf, &amc}) {
        std::string sloppy = "\xEF\xBB\xBF";
        for (const char c : *text)
            sloppy += c == '\n' ? " \t\r\n\r\n" : c == ' ' ? "\t " : std::string(1, c);
        *text = sloppy;
    }
    EXPECT_EQ(read(asf, amc)->channels, read(kAsf, kAmc)->channels);
    amc.erase(amc.find_last_not_of(" \t\r\n") + 1);
    EXPECT_EQ(read(asf, amc)->frameCount, 2);
}

TEST(Amc, TakesBonesInAnyOrderAndTheRateIfThereIsOne) {
    const auto motion = read(
        kAsf, ":SAMPLES-PER-SECOND 60\n:DEGREES\n5\nlower 1 2\nroot 0 0 0 0 0 0\nupper 3 4 5\n");
    EXPECT_EQ(motion->frame(0)[6], 5);
    EXPECT_EQ(motion->frame(0)[9], 2);
    EXPECT_EQ(motion->frameTime, 1.0 / 60.0);
}

TEST(Amc, ReportsFramesThatDoNotFollow) {
    const Recording recording =
        readAmc(replaced(kAmc, "\n2\n", "\n5\n"), "a.amc", readAsf(kAsf, "a.asf"));
    ASSERT_EQ(recording.findings.size(), 2U);
    EXPECT_EQ(recording.findings[0].text.substr(0, 23), "Frame 5 does not follow");
}

TEST(Amc, DropsACutLastFrame) {
    const std::size_t secondFrame = kAmc.find("\n2\n") + 1;
    const std::size_t lastBone = kAmc.find("lower -0") + std::string("lower -0 1").size();
    for (std::size_t size = secondFrame + 1; size < lastBone; ++size) {
        const Recording recording = readAmc(kAmc.substr(0, size), "a.amc", readAsf(kAsf, "a.asf"));
        EXPECT_EQ(recording.motions.front()->frameCount, 1) << size;
        EXPECT_EQ(recording.motions.front()->channels.size(), 11U);
        EXPECT_EQ(recording.findings.front().text, "Frame 2, the last, is cut: it is dropped.");
    }
}

TEST(Amc, NamesThePlaceOfErrors) {
    const auto amcWith = [](const std::string& from, const std::string& to) {
        return messageFor(kAsf, replaced(kAmc, from, to));
    };
    EXPECT_EQ(amcWith("upper 7 8 9\n", ""),
              "a.amc:4:1: found no line for bone 'upper' in frame 1, expected one for each bone "
              "with a dof");
    EXPECT_EQ(amcWith("upper 7", "uper 7"),
              "a.amc:6:1: found 'uper', expected a bone of the skeleton that has a dof, or the "
              "number of the frame after 1");
    EXPECT_EQ(amcWith("upper 7 8 9", "hand 7"),
              "a.amc:6:1: found 'hand', expected a bone of the skeleton that has a dof, or the "
              "number of the frame after 1");
    EXPECT_EQ(amcWith("upper 7 8 9", "upper 7 8"),
              "a.amc:6:10: found 2 numbers, expected 3 for bone 'upper' in frame 1");
    EXPECT_EQ(amcWith("upper 7 8 9", "upper 7 8 9 10"),
              "a.amc:6:13: found '10', expected only 3 numbers for bone 'upper' in frame 1");
    EXPECT_EQ(amcWith("upper 7 8 9", "upper 7 nan 9"),
              "a.amc:6:9: found 'nan', expected a number for bone 'upper' in frame 1");
    EXPECT_EQ(amcWith("upper 7 8 9", "root 1 2 3 4 5 6"),
              "a.amc:6:1: found 'root', expected each bone once in frame 1");
    EXPECT_EQ(amcWith("\n1\n", "\n"), "a.amc:4:1: found 'root', expected the number of a frame");
    EXPECT_EQ(messageFor(kAsf, ":DEGREES\n"),
              "a.amc:2:1: found the end of the file, expected at least one whole frame");
    EXPECT_EQ(messageFor(kAsf, ""),
              "a.amc:1:1: found the end of the file, expected at least one whole frame");
}

TEST(Asf, NamesThePlaceOfErrors) {
    const auto asfWith = [](const std::string& from, const std::string& to) {
        return messageFor(replaced(kAsf, from, to), kAmc);
    };
    EXPECT_EQ(asfWith("length 0.45", "length 0"),
              "a.asf:6:10: found 0, expected a unit of length greater than zero");
    EXPECT_EQ(asfWith("angle deg", "angle grad"), "a.asf:7:9: found 'grad', expected deg or rad");
    EXPECT_EQ(asfWith("axis XYZ", "axis XYY"),
              "a.asf:12:9: found 'XYY', expected an order of rotations, such as XYZ");
    EXPECT_EQ(asfWith("direction 1 0 0", "direction 1 zero 0"),
              "a.asf:19:18: found 'zero', expected a number: the direction of the bone");
    EXPECT_EQ(asfWith("rx ry rz", "rx ry rx"),
              "a.asf:22:15: found 'rx', expected each degree of freedom once");
    EXPECT_EQ(asfWith("name lower", "name upper"),
              "a.asf:29:11: found a second bone 'upper', expected one");
    EXPECT_EQ(asfWith("    lower hand\n", ""),
              "a.asf:36:16: found bone 'hand' that does not hang on the root, expected it in "
              ":hierarchy");
    EXPECT_EQ(asfWith("lower hand", "lower foot"),
              "a.asf:42:11: found 'foot', expected the name of a bone of :bonedata, or end");
    EXPECT_EQ(asfWith("lower hand", "lower upper"),
              "a.asf:42:11: found bone 'upper' a second time, expected one parent for each");
    EXPECT_EQ(messageFor("", kAmc),
              "a.asf:1:1: found the end of the file, expected the section "
              ":root");
    EXPECT_EQ(messageFor("junk", kAmc),
              "a.asf:1:1: found 'junk', expected a section of an ASF "
              "file, such as :units or :bonedata");
}

TEST(Asf, SurvivesEveryTruncation) {
    for (std::size_t size = 0; size < kAsf.size(); ++size) {
        const std::string message = messageFor(kAsf.substr(0, size), kAmc);
        EXPECT_TRUE(message == "read" || message.find(", expected ") != std::string::npos)
            << message;
    }
    for (std::size_t size = 0; size < kAmc.size(); ++size) {
        const std::string message = messageFor(kAsf, kAmc.substr(0, size));
        EXPECT_TRUE(message == "read" || message.find(", expected ") != std::string::npos)
            << message;
    }
}

TEST(Asf, RefusesBonesThatHangOnThemselves) {
    const std::string loop = replaced(kAsf, "root upper\n    upper lower\n    lower hand",
                                      "upper lower\n    lower upper hand");
    EXPECT_NE(messageFor(loop, kAmc).find("does not hang on the root"), std::string::npos);
}

TEST(Amc, ReadsTheRealRecording) {
    KUMITE_NEEDS_DATA();
    const Recording recording = readRecording(*dataFolder() / "cmu_karate/135_06-martialArts.amc");
    const Motion& motion = *recording.motions.front();
    EXPECT_EQ(motion.frameCount, 3261);
    EXPECT_EQ(motion.skeleton->channelCount, 62);
    EXPECT_EQ(motion.frame(0)[0], -2.95645);
    EXPECT_EQ(motion.frame(0)[5], 3.79203);
    EXPECT_EQ(motion.frame(0)[3], -2.77144);
    EXPECT_EQ(recording.asf.filename(), "135-martialArts.asf");
}

/// The BVH of the same motion was made by another program, on a skeleton of other proportions:
/// its shins and thighs point where ours do but for a few degrees.
TEST(Amc, PointsTheBonesAsTheBvhOfTheSameMotion) {
    KUMITE_NEEDS_DATA();
    const Recording amc = readRecording(*dataFolder() / "cmu_karate/135_06-martialArts.amc");
    const Recording bvh = readRecording(*dataFolder() / "cmu_karate/martial_06.bvh");
    const Motion& ours = *amc.motions.front();
    const Motion& theirs = *bvh.motions.front();
    const JointPositions a = forwardKinematics(ours, {0, 3261}, {0.056444, UpAxis::Y});
    const JointPositions b = forwardKinematics(theirs, {1, 3262}, {0.01, UpAxis::Y});
    struct BonePair {
        const char* ourBegin;
        const char* ourEnd;
        const char* theirBegin;
        const char* theirEnd;
        double degrees;  ///< the most on average
    };
    for (const BonePair& bone : {BonePair{"ltibia", "lfoot", "lShin", "lFoot", 4},
                                 BonePair{"rtibia", "rfoot", "rShin", "rFoot", 4},
                                 BonePair{"lhumerus", "lradius", "lShldr", "lForeArm", 6},
                                 BonePair{"lfemur", "ltibia", "lThigh", "lShin", 10}}) {
        const int begin = ours.skeleton->find(bone.ourBegin);
        const int end = ours.skeleton->find(bone.ourEnd);
        const int theirBegin = theirs.skeleton->find(bone.theirBegin);
        const int theirEnd = theirs.skeleton->find(bone.theirEnd);
        double sum = 0;
        for (int frame = 0; frame < 3261; ++frame) {
            const Eigen::Vector3f u = (a.at(frame, end) - a.at(frame, begin)).normalized();
            const Eigen::Vector3f v =
                (b.at(frame, theirEnd) - b.at(frame, theirBegin)).normalized();
            sum += std::acos(std::min(1.0F, u.dot(v))) * 180 / std::numbers::pi;
        }
        EXPECT_LT(sum / 3261, bone.degrees) << bone.ourBegin;
    }
}

TEST(Amc, IsWrittenAsBvhAndReadBack) {
    KUMITE_NEEDS_DATA();
    const Recording amc = readRecording(*dataFolder() / "cmu_karate/135_06-martialArts.amc");
    const Motion& motion = *amc.motions.front();
    const Recording bvh = readBvh(bvhText(motion, motion.frames(), motion.frameTime), "a.bvh");
    const Motion& again = *bvh.motions.front();
    EXPECT_TRUE(bvh.findings.empty());
    EXPECT_EQ(again.skeleton->joints[0].channels.size(), 6U);
    const JointPositions a = forwardKinematics(motion, motion.frames(), {0.056444, UpAxis::Y});
    const JointPositions b = forwardKinematics(again, again.frames(), {0.056444, UpAxis::Y});
    ASSERT_EQ(a.xyz.size(), b.xyz.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.xyz.size(); ++i) {
        largest = std::max(largest, std::abs(double{a.xyz[i]} - double{b.xyz[i]}));
    }
    EXPECT_LT(largest, 1e-6);
}

}  // namespace
}  // namespace kumite
