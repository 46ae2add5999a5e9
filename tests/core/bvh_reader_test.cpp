#include <charconv>
#include <clocale>
#include <cmath>
#include <cstring>
#include <locale>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/formats/bvh.h"
#include "core/formats/number.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::dataFolder;
using test::readText;

/// A hip, a knee and an End Site: nine channels, two frames.
const std::string kHierarchy =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "\tOFFSET 0 1 0\n"
    "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "\tJOINT Knee\n"
    "\t{\n"
    "\t\tOFFSET 0 -2.5 0\n"
    "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"
    "\t\tEnd Site\n"
    "\t\t{\n"
    "\t\t\tOFFSET 0 -3 0.5\n"
    "\t\t}\n"
    "\t}\n"
    "}\n";
const std::string kMotion =
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.01\n"
    "1 2 3 4 5 6 7 8 9\n"
    "10 20 30 40 50 60 70 80 90\n";
const std::vector<double> kValues = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 30, 40, 50, 60, 70, 80, 90};

/// One root whose block and numbers are given; 0.01 s, one frame.
std::string oneJoint(const std::string& block, const std::string& numbers) {
    return "HIERARCHY\nROOT Hips\n{\n" + block + "}\nMOTION\nFrames: 1\nFrame Time: 0.01\n" +
           numbers + "\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
    return text;
}

Recording read(const std::string& text) {
    Recording recording = readBvh(text, "a.bvh");
    for (const auto& motion : recording.motions)
        motion->validate();
    return recording;
}

const Motion& first(const Recording& recording) {
    return *recording.motions.front();
}

/// The text of the only finding; fails the test if there is not exactly one.
std::string onlyFinding(const Recording& recording) {
    EXPECT_EQ(recording.findings.size(), 1U);
    return recording.findings.empty() ? "" : recording.findings.front().text;
}

TEST(BvhReader, ReadsHierarchyAndValues) {
    const Recording recording = read(kHierarchy + kMotion);
    EXPECT_EQ(recording.format, "BVH");
    EXPECT_TRUE(recording.findings.empty());
    ASSERT_EQ(recording.motions.size(), 1U);
    const Motion& motion = first(recording);
    EXPECT_EQ(motion.frameCount, 2);
    EXPECT_EQ(motion.frameTime, 0.01);
    EXPECT_EQ(motion.channels, kValues);
    const Skeleton& skeleton = *motion.skeleton;
    ASSERT_EQ(skeleton.jointCount(), 3);
    EXPECT_EQ(skeleton.channelCount, 9);
    EXPECT_EQ(skeleton.joints[0].name, "Hips");
    EXPECT_EQ(skeleton.joints[0].parent, -1);
    EXPECT_EQ(skeleton.joints[0].offset, Eigen::Vector3d(0, 1, 0));
    EXPECT_EQ(skeleton.joints[0].channels,
              (std::vector{Channel::Xposition, Channel::Yposition, Channel::Zposition,
                           Channel::Zrotation, Channel::Xrotation, Channel::Yrotation}));
    EXPECT_EQ(skeleton.joints[1].name, "Knee");
    EXPECT_EQ(skeleton.joints[1].parent, 0);
    EXPECT_EQ(skeleton.joints[1].firstChannel, 6);
    EXPECT_EQ(skeleton.joints[2].name, "Knee End Site");
    EXPECT_TRUE(skeleton.joints[2].isEndSite);
    EXPECT_EQ(skeleton.joints[2].offset, Eigen::Vector3d(0, -3, 0.5));
    EXPECT_EQ(skeleton.joints[2].parent, 1);
}

TEST(BvhReader, TakesAnyLineEndsAndByteOrderMark) {
    const std::string text = kHierarchy + kMotion;
    for (const std::string lineEnd : {"\n", "\r\n", "\r", "\n\n", "\r\r\n"}) {
        const std::string variant = replaced(text, "\n", lineEnd);
        EXPECT_EQ(first(read(variant)).channels, kValues);
        EXPECT_EQ(first(read("\xEF\xBB\xBF" + variant)).channels, kValues);
        const std::string unended = variant.substr(0, variant.find_last_not_of("\r\n") + 1);
        EXPECT_EQ(first(read(unended)).channels, kValues);
        EXPECT_TRUE(read(unended).findings.empty());
    }
}

TEST(BvhReader, TakesTabsBlanksAndNoIndent) {
    EXPECT_EQ(first(read(replaced(kHierarchy + kMotion, " ", "\t \t"))).channels, kValues);
    EXPECT_EQ(first(read(replaced(kHierarchy + kMotion, "\t", ""))).channels, kValues);
    EXPECT_EQ(first(read(replaced(kHierarchy + kMotion, "\n", " \t\n\n  "))).channels, kValues);
}

TEST(BvhReader, TakesKeywordsInAnyCase) {
    for (const auto change : {::toupper, ::tolower}) {
        std::string text = kHierarchy + kMotion;
        for (char& c : text)
            c = static_cast<char>(change(static_cast<unsigned char>(c)));
        const Recording recording = read(text);
        EXPECT_EQ(first(recording).channels, kValues);
        EXPECT_EQ(first(recording).skeleton->joints[1].channels[0], Channel::Zrotation);
        EXPECT_TRUE(first(recording).skeleton->joints[2].isEndSite);
    }
}

TEST(BvhReader, ReadsNumbersOfAllSpellings) {
    const std::vector<std::pair<std::string, double>> spellings = {
        {".0083", 0.0083},
        {"-.5", -0.5},
        {"5.", 5.0},
        {"+1.25", 1.25},
        {"1e2", 100.0},
        {"1.5E-3", 0.0015},
        {"-2.5e+01", -25},
        {"007", 7.0},
        {"1e-400", 0.0},
        {"7.5692e-005", 7.5692e-5},
        {"-0", -0.0},
        {"1E0", 1.0},
        {"16.666666666666666", 16.666666666666666},
        {"0.00000000000000000000000000000125", 1.25e-30},
        {"123456789012345678901234567890", 123456789012345678901234567890.0},
        {"9007199254740993", 9007199254740992.0},  // 2^53 + 1: a tie, to even
    };
    for (const auto& [text, value] : spellings) {
        const Recording recording = read(oneJoint("OFFSET 0 0 0\nCHANNELS 1 Xrotation\n", text));
        EXPECT_EQ(first(recording).channels.front(), value) << text;
        EXPECT_EQ(std::signbit(first(recording).channels.front()), std::signbit(value)) << text;
    }
}

/// The quick way of readNumber must give the very bits that std::from_chars gives.
TEST(BvhReader, RoundsEveryNumberCorrectly) {
    std::mt19937_64 random(1);
    const auto check = [](const std::string& text) {
        double expected = 0;
        double value = 0;
        std::from_chars(text.data(), text.data() + text.size(), expected);
        ASSERT_EQ(readNumber(text.data(), text.data() + text.size(), value),
                  text.data() + text.size());
        ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << text;
    };
    for (int i = 0; i < 200'000; ++i) {
        const auto digits = static_cast<int>(random() % 21);
        std::string text = random() % 2 ? "-" : "";
        text += std::to_string(random() % 1000) + ".";
        for (int d = 0; d < digits; ++d)
            text += static_cast<char>('0' + random() % 10);
        if (random() % 8 == 0) text += "e" + std::to_string(static_cast<int>(random() % 60) - 30);
        check(text);
    }
    for (int i = 0; i < 200'000; ++i) {
        const std::uint64_t bits = random();
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (std::isfinite(value)) check(shortest(value));
    }
}

TEST(BvhReader, TakesAnyChannels) {
    const Recording recording = read(
        "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Yrotation\n"
        "JOINT B\n{\nOFFSET 1 0 0\nCHANNELS 6 Yrotation Xrotation Zrotation Zposition Yposition "
        "Xposition\n"
        "JOINT C\n{\nOFFSET 1 0 0\nCHANNELS 2 Xrotation Yposition\n}\n}\n}\n"
        "MOTION\nFrames: 1\nFrame Time: .0083\n1 2 3 4 5 6 7 8 9\n");
    const Skeleton& skeleton = *first(recording).skeleton;
    EXPECT_EQ(first(recording).frameTime, 0.0083);
    EXPECT_EQ(skeleton.joints[0].channels, std::vector{Channel::Yrotation});
    EXPECT_EQ(skeleton.joints[1].channels,
              (std::vector{Channel::Yrotation, Channel::Xrotation, Channel::Zrotation,
                           Channel::Zposition, Channel::Yposition, Channel::Xposition}));
    EXPECT_EQ(skeleton.joints[1].firstChannel, 1);
    EXPECT_EQ(skeleton.joints[2].channels, (std::vector{Channel::Xrotation, Channel::Yposition}));
    EXPECT_EQ(skeleton.joints[2].firstChannel, 7);
}

TEST(BvhReader, TakesJointsWithoutChannelsAndHelpersAboveTheHips) {
    const Recording recording = read(
        "HIERARCHY\nROOT Scene\n{\nOFFSET 0 0 0\n"
        "JOINT Reference\n{\nOFFSET 0 0 0\nCHANNELS 0\n"
        "JOINT Hips\n{\nCHANNELS 3 Zrotation Xrotation Yrotation\nOFFSET 1 2 3\n}\n}\n}\n"
        "MOTION\nFrames: 1\nFrame Time: 0.01\n4 5 6\n");
    EXPECT_TRUE(recording.findings.empty());
    const Skeleton& skeleton = *first(recording).skeleton;
    EXPECT_EQ(skeleton.channelCount, 3);
    EXPECT_EQ(skeleton.joints[2].offset, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(skeleton.joints[2].firstChannel, 0);
}

TEST(BvhReader, ReportsAJointWithoutOffset) {
    const Recording recording = read(oneJoint("CHANNELS 1 Xrotation\n", "1"));
    EXPECT_EQ(onlyFinding(recording), "'Hips' has no OFFSET: taken as 0 0 0.");
    EXPECT_EQ(first(recording).skeleton->joints[0].offset, Eigen::Vector3d(0, 0, 0));
}

TEST(BvhReader, KeepsNamesAsTheyAre) {
    for (const std::string name : {"Left Up Leg", "mixamorig:Hips", "Bip01 L.Thigh", "a-b_c|d",
                                   "x{y}z", "Hand#2", "http://a", "左足", "JOINT", "End"}) {
        for (const std::string brace : {"\n{", " {", "\t{ ", "  \t\n\n{"}) {
            const Recording recording =
                read("HIERARCHY\nROOT \t" + name + brace +
                     "\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\nJOINT " + name + brace +
                     "\nOFFSET 0 0 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n1\n");
            EXPECT_EQ(first(recording).skeleton->joints[0].name, name);
            EXPECT_EQ(first(recording).skeleton->joints[1].name, name);
        }
    }
    const Recording glued = read(replaced(kHierarchy + kMotion, "Hips\n{", "Hips{"));
    EXPECT_EQ(first(glued).skeleton->joints[0].name, "Hips");
}

TEST(BvhReader, TakesAWholeHierarchyOnOneLine) {
    const Recording recording = read(
        "HIERARCHY ROOT A B { OFFSET 0 0 0 CHANNELS 1 Xrotation JOINT C { OFFSET 1 2 3 End "
        "Site { OFFSET 4 5 6 } } } MOTION Frames: 1 Frame Time: 0.01 7");
    const Skeleton& skeleton = *first(recording).skeleton;
    ASSERT_EQ(skeleton.jointCount(), 3);
    EXPECT_EQ(skeleton.joints[0].name, "A B");
    EXPECT_EQ(skeleton.joints[2].offset, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(first(recording).channels, std::vector<double>{7});
}

TEST(BvhReader, TakesEndSitesNamedUnnamedOrAbsent) {
    for (const std::string endSite : {"End Site", "End Site toe", "END SITE", "EndSite",
                                      "End  Site  Toe Tip", "End Site {", "End Site toe {"}) {
        const bool hasBrace = endSite.ends_with('{');
        const Recording recording = read(
            replaced(kHierarchy + kMotion, hasBrace ? "End Site\n\t\t{" : "End Site", endSite));
        EXPECT_EQ(first(recording).skeleton->joints[2].name, "Knee End Site") << endSite;
        EXPECT_TRUE(first(recording).skeleton->joints[2].isEndSite);
    }
    const Recording none = read(oneJoint("OFFSET 0 0 0\nCHANNELS 1 Xrotation\n", "1"));
    EXPECT_EQ(first(none).skeleton->jointCount(), 1);
}

TEST(BvhReader, ReadsAnEndSiteWithChildrenAsAJoint) {
    const Recording recording =
        read(oneJoint("OFFSET 0 0 0\nCHANNELS 1 Xrotation\nEnd Site\n{\nOFFSET 1 0 0\nJOINT B\n{\n"
                      "OFFSET 2 0 0\nCHANNELS 1 Yrotation\n}\n}\n",
                      "1 2"));
    EXPECT_FALSE(first(recording).skeleton->joints[1].isEndSite);
    EXPECT_EQ(first(recording).skeleton->joints[2].parent, 1);
    EXPECT_EQ(onlyFinding(recording), "'Hips End Site' has channels or children: read as a joint.");
}

TEST(BvhReader, SkipsCommentsAndBlankLines) {
    const std::string hierarchy = replaced(kHierarchy, "\n", " // a { } comment\n\n# another\n");
    const std::string motion = replaced(kMotion, "\n", "\n\n# 1 2 3\n  // 4\n");
    const Recording recording = read("# exported\n" + hierarchy + motion);
    EXPECT_EQ(first(recording).channels, kValues);
    EXPECT_EQ(first(recording).skeleton->joints[0].name, "Hips");
    EXPECT_TRUE(recording.findings.empty());
    EXPECT_EQ(first(read(kHierarchy + replaced(kMotion, "9\n", "9 # row\n"))).channels, kValues);
}

TEST(BvhReader, CountsNumbersNotLines) {
    EXPECT_EQ(first(read(kHierarchy + replaced(kMotion, " 5 ", "\n5 "))).channels, kValues);
    EXPECT_EQ(first(read(kHierarchy + replaced(kMotion, "9\n10", "9 10"))).channels, kValues);
    std::string columns = kHierarchy + "MOTION\nFrames: 2\nFrame Time: 0.01\n";
    for (const double value : kValues)
        columns += shortest(value) + "\n";
    EXPECT_EQ(first(read(columns)).channels, kValues);
}

TEST(BvhReader, TakesHeadersAsTheyAreWritten) {
    for (const std::string header :
         {"Frames: 2\nFrame Time: 0.01\n", "FRAMES:2\nFRAME TIME:0.01\n",
          "Frames :\t2\nFrame  Time :\t0.01\n", "frames 2\nFrameTime: 1e-2\n",
          "Frame Time: 0.01\nFrames: 2\n", "Frames: 2 Frame Time: 0.01 ",
          "Frames: 2.0\n\nFrame Time: .01\n"}) {
        const Recording recording =
            read(kHierarchy + replaced(kMotion, "Frames: 2\nFrame Time: 0.01\n", header));
        EXPECT_EQ(first(recording).channels, kValues) << header;
        EXPECT_EQ(first(recording).frameTime, 0.01) << header;
        EXPECT_TRUE(recording.findings.empty()) << header;
    }
}

TEST(BvhReader, LetsTheNumbersDecideHowManyFramesThereAre) {
    const auto withCount = [](const std::string& count) {
        return read(kHierarchy + replaced(kMotion, "Frames: 2\n", count));
    };
    EXPECT_EQ(first(withCount("Frames: 1\n")).frameCount, 1);
    EXPECT_EQ(first(withCount("Frames: 1\n")).channels.size(), 9U);
    EXPECT_EQ(onlyFinding(withCount("Frames: 1\n")),
              "The header says 1 frames but the file holds 2: the surplus is dropped.");
    EXPECT_EQ(first(withCount("Frames: 7\n")).frameCount, 2);
    EXPECT_EQ(onlyFinding(withCount("Frames: 7\n")),
              "The header says 7 frames but the file holds 2: these are used.");
    for (const std::string count : {"Frames: 0\n", "Frames: -3\n", ""}) {
        EXPECT_EQ(first(withCount(count)).frameCount, 2);
        EXPECT_EQ(withCount(count).findings.size(), 1U);
    }
}

TEST(BvhReader, DropsACutLastFrame) {
    for (const std::string stump : {"1 2 3", "1 2 3\n", "1 2 3 -", "1 2 -3.", "1 2e", "1 2e-"}) {
        const Recording recording =
            read(kHierarchy + replaced(kMotion, "Frames: 2", "Frames: 3") + stump);
        EXPECT_EQ(first(recording).channels, kValues) << stump;
        ASSERT_EQ(recording.findings.size(), 2U) << stump;
        EXPECT_NE(recording.findings[1].text.find("The last frame is cut"), std::string::npos);
    }
}

TEST(BvhReader, UsesOddFrameTimesWithAWarning) {
    const auto withTime = [](const std::string& time) {
        return read(kHierarchy + replaced(kMotion, "0.01", time));
    };
    EXPECT_TRUE(withTime("0.1").findings.empty());    // 10 Hz
    EXPECT_TRUE(withTime("0.001").findings.empty());  // 1000 Hz
    EXPECT_TRUE(withTime("0.041708").findings.empty());
    EXPECT_EQ(first(withTime("0.2")).frameTime, 0.2);
    EXPECT_EQ(onlyFinding(withTime("0.2")),
              "The frame time 0.2 means 5 frames a second, which is unusual; give the true rate "
              "with --rate if it is wrong.");
    EXPECT_EQ(withTime("0.0005").findings.size(), 1U);
    EXPECT_EQ(first(withTime("30")).frameTime, 30);
    for (const std::string time : {"0", "-0.01", "1e-9", "1e300", "0.000000"}) {
        EXPECT_EQ(first(withTime(time)).frameTime, 1.0 / 30.0);
        EXPECT_NE(onlyFinding(withTime(time)).find("--rate"), std::string::npos);
    }
}

TEST(BvhReader, ReadsTwoSkeletonsThatShareFrames) {
    for (const std::string between : {"", "HIERARCHY\n"}) {
        const Recording recording = read(
            "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 2 Xrotation Yrotation\n}\n" + between +
            "ROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\n}\n"
            "MOTION\nFrames: 2\nFrame Time: 0.01\n1 2\n3\n4 5\n6\n");
        ASSERT_EQ(recording.motions.size(), 2U);
        EXPECT_EQ(recording.motions[0]->channels, (std::vector<double>{1, 2, 4, 5}));
        EXPECT_EQ(recording.motions[1]->channels, (std::vector<double>{3, 6}));
        EXPECT_EQ(recording.motions[1]->frameCount, 2);
        EXPECT_EQ(onlyFinding(recording),
                  "The file holds 2 skeletons: A#1, A#2. The first is read unless --root names "
                  "another.");
    }
}

TEST(BvhReader, ReadsASecondWholeSection) {
    const std::string other =
        "ROOT Other\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\n}\n"
        "MOTION\nFrames: 3\nFrame Time: 0.02\n1\n2\n3\n";
    for (const std::string start : {"", "HIERARCHY\n"}) {
        const Recording recording = read(kHierarchy + kMotion + start + other);
        ASSERT_EQ(recording.motions.size(), 2U);
        EXPECT_EQ(recording.motions[0]->channels, kValues);
        EXPECT_EQ(recording.motions[1]->channels, (std::vector<double>{1, 2, 3}));
        EXPECT_EQ(recording.motions[1]->frameTime, 0.02);
        EXPECT_EQ(recording.motions[1]->skeleton->joints[0].name, "Other");
    }
}

TEST(BvhReader, LeavesOutASkeletonWithoutChannels) {
    const Recording recording = read(
        "HIERARCHY\nROOT Prop\n{\nOFFSET 0 0 0\n}\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 "
        "Zrotation\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n5\n");
    ASSERT_EQ(recording.motions.size(), 1U);
    EXPECT_EQ(first(recording).channels, std::vector<double>{5});
    EXPECT_EQ(onlyFinding(recording), "The skeleton of 'Prop' has no channels: it is left out.");
}

/// A decimal comma, as German and French have it, without a language of the system.
class DecimalComma : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(BvhReader, DoesNotDependOnTheLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // has no effect where it is not installed
    const std::string text = oneJoint("OFFSET 0.5 1e-3 -.25\nCHANNELS 1 Xrotation\n", "1234.5678");
    const Recording recording = read(text);
    const std::string written = bvhText(first(recording), {0, 1}, 0.0125);
    std::setlocale(LC_ALL, "C");
    std::locale::global(before);
    EXPECT_EQ(first(recording).channels.front(), 1234.5678);
    EXPECT_EQ(first(recording).skeleton->joints[0].offset, Eigen::Vector3d(0.5, 0.001, -0.25));
    EXPECT_NE(written.find("OFFSET 0.5 0.001 -0.25\n"), std::string::npos);
    EXPECT_NE(written.find("Frame Time: 0.0125\n1234.5678\n"), std::string::npos);
}

TEST(BvhReader, ReportsProgressAndStops) {
    std::string text = oneJoint("OFFSET 0 0 0\nCHANNELS 1 Xrotation\n", "");
    for (int i = 0; i < 100'000; ++i)
        text += "12.5\n";
    Progress progress;
    std::vector<double> fractions;
    progress.report = [&](double fraction) { fractions.push_back(fraction); };
    readBvh(text, "a.bvh", progress);
    EXPECT_GE(fractions.size(), 5U);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1.0);

    std::stop_source stop;
    progress.stop = stop.get_token();
    progress.report = [&](double fraction) {
        if (fraction > 0.3) stop.request_stop();
    };
    EXPECT_THROW(readBvh(text, "a.bvh", progress), Cancelled);
}

struct RealFile {
    const char* path;
    int joints;  ///< without End Sites
    int channels;
    int frames;
    double frameTime;
    double firstValue;
    double lastValue;
};

TEST(BvhReader, ReadsRealRecordings) {
    KUMITE_NEEDS_DATA();
    const std::vector<RealFile> files = {
        {"awkward/Boxing_Toes.bvh", 21, 66, 3069, 0.01, -6.101614, -1.329659},
        {"awkward/kick_37_joints.bvh", 37, 114, 231, 0.00833333, -76.157, 6.36111e-15},
        {"awkward/karate.bvh", 18, 57, 653, 0.033333333, 0.010345, -7.521492},
        {"awkward/test_anim_sword_attack.bvh", 29, 90, 598, 0.00833333, 0, -1.24824e-06},
        {"awkward/walk_left_45_UPPERCASE_channels.bvh", 13, 42, 180, 0.033333, 1.88811662,
         -0.238826128746},
        {"awkward/sinusoidal_noEndSite.bvh", 4, 15, 120, 0.016666666666666666, -3, 0},
        {"cmu_salsa/60_01.bvh", 43, 132, 2243, 0.00833333, -71.6924, 16.2391},
        {"cmu_moves/02_05.bvh", 31, 96, 1855, 0.0083333, 9.6274, 0.6331},
    };
    for (const RealFile& file : files) {
        const Recording recording = read(readText(*dataFolder() / file.path));
        ASSERT_EQ(recording.motions.size(), 1U) << file.path;
        const Motion& motion = first(recording);
        const auto endSites =
            std::count_if(motion.skeleton->joints.begin(), motion.skeleton->joints.end(),
                          [](const Joint& joint) { return joint.isEndSite; });
        EXPECT_EQ(motion.skeleton->jointCount() - endSites, file.joints) << file.path;
        EXPECT_EQ(motion.skeleton->channelCount, file.channels) << file.path;
        EXPECT_EQ(motion.frameCount, file.frames) << file.path;
        EXPECT_EQ(motion.frameTime, file.frameTime) << file.path;
        EXPECT_EQ(motion.channels.front(), file.firstValue) << file.path;
        EXPECT_EQ(motion.channels.back(), file.lastValue) << file.path;
    }
}

TEST(BvhReader, ReadsTheRealFileWithTwoSkeletons) {
    KUMITE_NEEDS_DATA();
    const Recording recording = read(readText(*dataFolder() / "awkward/two_roots.bvh"));
    ASSERT_EQ(recording.motions.size(), 2U);
    for (const auto& motion : recording.motions)
        EXPECT_EQ(motion->frameCount, 726);
    EXPECT_EQ(recording.motions[0]->frame(0)[0], -3.1118);
    EXPECT_EQ(recording.motions[1]->frame(0)[0], -10.2971);
    EXPECT_EQ(recording.motions[0]->frame(1)[0], -3.0495);
    EXPECT_EQ(recording.motions[1]->frame(1)[1], 32.9244);
    EXPECT_TRUE(std::signbit(recording.motions[0]->channels.back()));
}

}  // namespace
}  // namespace kumite
