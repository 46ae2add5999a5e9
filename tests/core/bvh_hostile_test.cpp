#include <random>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/bvh.h"
#include "core/formats/scanner.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::dataFolder;
using test::readText;

const std::string kHierarchy =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "\tOFFSET 0 1 0\n"
    "\tCHANNELS 3 Xposition Zrotation Xrotation\n"
    "\tJOINT Left Knee\n"
    "\t{\n"
    "\t\tOFFSET 0 -2.5 0\n"
    "\t\tCHANNELS 2 Zrotation Xrotation\n"
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
    "1 2 3 4 5\n"
    "-10 20.5 3e1 .4 50\n";
const std::string kValid = kHierarchy + kMotion;

/// What readBvh says about `text`; "read" if it is content.
std::string messageFor(const std::string& text) {
    try {
        readBvh(text, "a.bvh");
        return "read";
    } catch (const InputError& error) {
        return error.what();
    }
}

/// The message for the valid file with `from` replaced by `to`.
std::string messageWith(const std::string& from, const std::string& to) {
    std::string text = kValid;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return messageFor(text.replace(at, from.size(), to));
}

TEST(BvhHostile, NamesThePlaceAndWhatIsExpected) {
    EXPECT_EQ(messageFor(kValid), "read");
    EXPECT_EQ(messageWith("HIERARCHY", "HIRARCHY"),
              "a.bvh:1:1: found 'HIRARCHY', expected HIERARCHY");
    EXPECT_EQ(messageWith("ROOT", "JOINT"), "a.bvh:2:1: found 'JOINT', expected ROOT");
    EXPECT_EQ(messageWith("ROOT Hips", "ROOT"),
              "a.bvh:3:1: found '{', expected the name of the root joint");
    EXPECT_EQ(messageWith("Hips\n{", "Hips\n"), "a.bvh:4:2: found 'OFFSET', expected {");
    EXPECT_EQ(messageWith("OFFSET 0 1 0", "OFSET 0 1 0"),
              "a.bvh:4:2: found 'OFSET', expected OFFSET, CHANNELS, JOINT, End Site or } in joint "
              "'Hips'");
    EXPECT_EQ(messageWith("0 -2.5 0", "0 -2,5 0"),
              "a.bvh:8:12: found '-2,5', expected a number of the OFFSET");
    EXPECT_EQ(messageWith("0 -2.5 0", "0 -2.5"),
              "a.bvh:9:3: found 'CHANNELS', expected a number of the OFFSET");
    EXPECT_EQ(messageWith("CHANNELS 3", "CHANNELS three"),
              "a.bvh:5:11: found 'three', expected the number of channels, 0 to 6");
    EXPECT_EQ(messageWith("CHANNELS 3", "CHANNELS 7"),
              "a.bvh:5:11: found '7', expected the number of channels, 0 to 6");
    EXPECT_EQ(messageWith("CHANNELS 3", "CHANNELS -1"),
              "a.bvh:5:11: found '-1', expected the number of channels, 0 to 6");
    EXPECT_EQ(messageWith("3 Xposition", "3 Xpos"),
              "a.bvh:5:13: found 'Xpos', expected channel 1 of 3: Xposition, Yposition, Zposition, "
              "Xrotation, Yrotation or Zrotation");
    EXPECT_EQ(messageWith("CHANNELS 3", "CHANNELS 4"),
              "a.bvh:6:2: found 'JOINT', expected channel 4 of 4: Xposition, Yposition, Zposition, "
              "Xrotation, Yrotation or Zrotation");
    EXPECT_EQ(
        messageWith("CHANNELS 3", "CHANNELS 2"),
        "a.bvh:5:33: found 'Xrotation', expected only the 2 channels that CHANNELS announces");
    EXPECT_EQ(messageWith("Xposition Zrotation", "Xrotation Zrotation"),
              "a.bvh:5:33: found 'Xrotation', expected each channel once in a joint");
    EXPECT_EQ(messageWith("\tOFFSET 0 1 0", "\tOFFSET 0 1 0 OFFSET 0 0 0"),
              "a.bvh:4:15: found a second OFFSET, expected one in joint 'Hips'");
    EXPECT_EQ(messageWith("\tEnd Site", "\tCHANNELS 0\n\tEnd Site"),
              "a.bvh:10:3: found a second CHANNELS, expected one in joint 'Left Knee'");
}

TEST(BvhHostile, NamesThePlaceInTheMotionSection) {
    EXPECT_EQ(messageWith("}\nMOTION", "}\n}\nMOTION"), "a.bvh:16:1: found '}', expected MOTION");
    EXPECT_EQ(
        messageWith("}\nMOTION", "MOTION"),
        "a.bvh:15:1: found 'MOTION', expected OFFSET, CHANNELS, JOINT, End Site or } in joint "
        "'Hips'");
    EXPECT_EQ(messageWith("Frames: 2", "Frames: two"),
              "a.bvh:17:9: found 'two', expected the number of frames");
    EXPECT_EQ(messageWith("Frame Time: 0.01", "Frame Time: 0,01"),
              "a.bvh:18:13: found '0,01', expected the frame time in seconds");
    EXPECT_EQ(messageWith("Frame Time: 0.01", "Frame Time: nan"),
              "a.bvh:18:13: found 'nan', expected the frame time in seconds");
    EXPECT_EQ(messageWith("Frame Time: 0.01\n", ""), "a.bvh:18:1: found '1', expected Frame Time:");
    const std::string expected = ", expected a finite number with a decimal point";
    EXPECT_EQ(messageWith("20.5", "abc"), "a.bvh:20:5: found 'abc'" + expected);
    EXPECT_EQ(messageWith("20.5", "20,5"), "a.bvh:20:5: found '20,5'" + expected);
    for (const std::string odd :
         {"nan", "NaN", "inf", "-Infinity", "1e999", "-1e999", "0x10", "1-2", "1.2.3", "--1", "+-1",
          "1e", ".", "-", "-1.#IND", "nan(1)", "1\x01", "1}", "{"}) {
        EXPECT_NE(messageWith("20.5", odd).find("a.bvh:20:5: found "), std::string::npos) << odd;
        EXPECT_NE(messageWith("20.5", odd).find(expected), std::string::npos) << odd;
    }
}

TEST(BvhHostile, CountsLinesAndColumnsAsEditorsDo) {
    const auto placeIn = [](const std::string& text) {
        try {
            readBvh(text, "a.bvh");
        } catch (const InputError& error) {
            return std::pair(error.line(), error.column());
        }
        return std::pair(0, 0);
    };
    EXPECT_EQ(placeIn("HIERARCHY\r\nROOT A\r\n{\r\n  X"), std::pair(4, 3));
    EXPECT_EQ(placeIn("HIERARCHY\rROOT A\r{\r  X"), std::pair(4, 3));
    EXPECT_EQ(placeIn("HIERARCHY\n\r\n\r\rROOT A\n{\n\tX"), std::pair(7, 2));
    EXPECT_EQ(placeIn("\xEF\xBB\xBFHIRARCHY"), std::pair(1, 1));
    EXPECT_EQ(placeIn("HIERARCHY ROOT 左足 { X"), std::pair(1, 21));
}

TEST(BvhHostile, RefusesWhatHoldsNoMotion) {
    EXPECT_EQ(messageFor(""), "a.bvh:1:1: found the end of the file, expected HIERARCHY");
    EXPECT_EQ(messageFor(" \n\t\n"), "a.bvh:3:1: found the end of the file, expected HIERARCHY");
    EXPECT_EQ(messageFor("HIERARCHY\n"), "a.bvh:2:1: found the end of the file, expected ROOT");
    EXPECT_EQ(messageFor(kHierarchy), "a.bvh:16:1: found the end of the file, expected MOTION");
    EXPECT_EQ(messageFor(kHierarchy + "MOTION\nFrames: 0\nFrame Time: 0.01\n"),
              "a.bvh:19:1: found 0 numbers after Frame Time, expected at least one frame of 5 "
              "numbers");
    EXPECT_EQ(messageFor(kHierarchy + "MOTION\nFrames: 1\nFrame Time: 0.01\n1 2 3 4"),
              "a.bvh:19:1: found 4 numbers after Frame Time, expected at least one frame of 5 "
              "numbers");
    EXPECT_EQ(messageFor("HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\n}\nMOTION\nFrames: 1\nFrame Time: "
                         "0.01\n"),
              "a.bvh:1:1: found a skeleton without any channel, expected CHANNELS");
}

TEST(BvhHostile, RefusesOtherFilesWithAReadableSentence) {
    EXPECT_EQ(messageFor(std::string("\xFF\xFEH\0I\0", 6)),
              "a.bvh:1:1: found UTF-16 text, expected plain text (save the file as UTF-8)");
    EXPECT_EQ(messageFor(std::string("PK\x03\x04\x14\0\0\0", 8)),
              "a.bvh:1:1: found 'PK\\x03\\x04\\x14\\x00\\x00\\x00', expected HIERARCHY");
    EXPECT_EQ(messageFor(std::string(1000, 'x')),
              "a.bvh:1:1: found '" + std::string(30, 'x') + "…', expected HIERARCHY");
}

TEST(BvhHostile, BelievesNoAbsurdFrameCount) {
    for (const std::string count :
         {"1000000000", "2147483648", "99999999999999999999999", "1e300"}) {
        std::string text = kValid;
        text.replace(text.find("Frames: 2"), 9, "Frames: " + count);
        const Recording recording = readBvh(text, "a.bvh");
        EXPECT_EQ(recording.motions.front()->frameCount, 2);
        EXPECT_LT(recording.motions.front()->channels.capacity(), 100U);
        EXPECT_EQ(recording.findings.size(), 1U);
    }
}

TEST(BvhHostile, LimitsTheNumberOfJoints) {
    std::string deep = "HIERARCHY\nROOT A\n{\n";
    for (int i = 0; i < 100'000; ++i)
        deep += "JOINT A\n{\n";
    EXPECT_EQ(messageFor(deep),
              "a.bvh:20002:8: found more joints than a skeleton can have, expected 10000 at most");
    std::string wide = "HIERARCHY\nROOT A\n{\n";
    for (int i = 0; i < 100'000; ++i)
        wide += "JOINT A\n{\nOFFSET 0 0 0\n}\n";
    EXPECT_NE(messageFor(wide).find("expected 10000 at most"), std::string::npos);
}

TEST(BvhHostile, ReadsTheDeepestChainThatIsAllowed) {
    std::string text = "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n";
    for (int i = 1; i < 10'000; ++i)
        text += "JOINT A\n{\nOFFSET 0 1 0\n";
    for (int i = 0; i < 10'000; ++i)
        text += "}\n";
    text += "MOTION\nFrames: 1\nFrame Time: 0.01\n5\n";
    const Recording recording = readBvh(text, "a.bvh");
    const Motion& motion = *recording.motions.front();
    EXPECT_EQ(motion.skeleton->jointCount(), 10'000);
    const std::string written = bvhText(motion, motion.frames(), motion.frameTime);
    EXPECT_LT(written.size(), 10'000'000U);
    EXPECT_EQ(readBvh(written, "again").motions.front()->skeleton->jointCount(), 10'000);
}

/// Reads hostile text: it must give a valid motion, or an error with a place in the text that a
/// user can read. Returns whether it was read.
bool survives(const std::string& text) {
    try {
        const Recording recording = readBvh(text, "a.bvh");
        EXPECT_FALSE(recording.motions.empty());
        for (const auto& motion : recording.motions) {
            motion->validate();
            EXPECT_GT(motion->frameCount, 0);
            EXPECT_GT(motion->skeleton->channelCount, 0);
        }
        return true;
    } catch (const InputError& error) {
        EXPECT_GE(error.line(), 1);
        EXPECT_GE(error.column(), 1);
        std::string_view message = error.what();
        EXPECT_NE(message.find(", expected "), std::string_view::npos) << message;
        while (!message.empty()) {
            const std::size_t length = utf8Length(message);
            EXPECT_GT(length, 0U) << "not UTF-8";
            EXPECT_GE(static_cast<unsigned char>(message.front()), 0x20) << "a control byte";
            message.remove_prefix(std::max<std::size_t>(length, 1));
        }
        return false;
    }
}

TEST(BvhHostile, SurvivesEveryTruncation) {
    for (std::size_t size = 0; size < kValid.size(); ++size)
        survives(kValid.substr(0, size));
    const std::string second = kValid + kValid;
    for (std::size_t size = 0; size < second.size(); ++size)
        survives(second.substr(0, size));
    // Cut behind the first frame, the first frame is there; cut before, there is nothing to read.
    const std::size_t firstFrame = kValid.find("1 2 3 4 5\n") + 9;
    for (std::size_t size = 0; size < kValid.size(); ++size) {
        EXPECT_EQ(survives(kValid.substr(0, size)), size >= firstFrame) << size;
    }
}

TEST(BvhHostile, SurvivesTruncatedRealFiles) {
    KUMITE_NEEDS_DATA();
    std::mt19937 random(2);
    for (const char* file : {"awkward/kick_37_joints.bvh", "awkward/two_roots.bvh"}) {
        const std::string text = readText(*dataFolder() / file);
        for (int i = 0; i < 300; ++i)
            survives(text.substr(0, random() % 20'000));
        for (int i = 0; i < 20; ++i)
            survives(text.substr(0, random() % text.size()));
    }
}

/// Changes bytes, copies and removes stretches, inserts words of the format.
std::string mutated(std::string text, std::mt19937& random) {
    static const std::vector<std::string> kWords = {
        "{",      "}",          "HIERARCHY", "ROOT x", "JOINT ",     "End Site", "OFFSET",
        "MOTION", "CHANNELS 6", "Frames:",   "nan",    "1e999",      "-",        "//",
        "#",      "\r",         "\n",        "\t",     "Frame Time", "0",        "999999999999"};
    const auto pick = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
    for (std::size_t changes = 1 + pick(4); changes > 0; --changes) {
        const std::size_t at = pick(text.size() + 1);
        switch (pick(5)) {
            case 0:
                if (at < text.size()) text[at] = static_cast<char>(random());
                break;
            case 1:
                if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << pick(8)));
                break;
            case 2:
                text.erase(at, pick(30));
                break;
            case 3:
                text.insert(at, kWords[pick(kWords.size())]);
                break;
            default:
                text.insert(at, text.substr(pick(text.size() + 1), pick(60)));
                break;
        }
    }
    return text;
}

TEST(BvhHostile, SurvivesMutations) {
    std::mt19937 random(3);
    int read = 0;
    constexpr int kRuns = 20'000;
    for (int i = 0; i < kRuns; ++i) {
        const std::string text = mutated(kValid, random);
        if (survives(text)) ++read;
        if (HasFailure()) FAIL() << "run " << i << ":\n" << text;
    }
    // Both ways are really taken.
    EXPECT_GT(read, kRuns / 50);
    EXPECT_LT(read, kRuns * 49 / 50);
}

TEST(BvhHostile, SurvivesRandomBytes) {
    std::mt19937 random(4);
    for (int i = 0; i < 2'000; ++i) {
        std::string text(random() % 200, ' ');
        for (char& c : text)
            c = static_cast<char>(random());
        EXPECT_FALSE(survives(text));
        EXPECT_FALSE(survives("HIERARCHY ROOT a { " + text));
    }
}

}  // namespace
}  // namespace kumite
