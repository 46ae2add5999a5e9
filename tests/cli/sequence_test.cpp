// Commands that string actions together: words in, output and exit code out.

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/formats/bvh.h"
#include "core/formats/recording.h"
#include "tests/cli/command_line.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::kumite;
using test::Result;

/// Two files of a body that swings an arm or a leg, 3 s at 60 Hz.
class SequenceCommands : public testing::Test {
protected:
    test::TemporaryFolder folder;
    std::string out = (folder / "out.bvh").string();

    void SetUp() override {
        std::filesystem::create_directories(folder / "lib");
        write("arm", 6 + 3 * 6);   // left shoulder
        write("leg", 6 + 3 * 12);  // left hip
    }
    void write(const std::string& name, int column) {
        const auto motion =
            test::makeMotion(test::makeHuman(), 181, 60, [column](int frame, int c) {
                if (c == 1) return test::kHumanRootHeight;
                const double t = frame / 60.0;
                return c == column ? 70 * (1 - std::cos(2 * M_PI * t)) / 2 : 2 * std::sin(3 * t);
            });
        test::writeText(folder / "lib" / (name + ".bvh"),
                        bvhText(*motion, motion->frames(), motion->frameTime));
    }
    std::string lib() { return (folder / "lib").string(); }
    nlohmann::json json(std::vector<std::string> words) {
        words.push_back("--json");
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    }
};

TEST_F(SequenceCommands, HelpHasAnExample) {
    for (const std::string command : {"clusters", "transition", "sequence"}) {
        const Result help = kumite({command, "--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_NE(help.out.find("Example: kumite " + command), std::string::npos) << help.out;
    }
}

TEST_F(SequenceCommands, ClustersSayWhatWasFound) {
    const auto report = json({"clusters", lib()});
    EXPECT_EQ(report["motions"], 2);
    EXPECT_EQ(report["frames"], 182);
    EXPECT_EQ(report["rate"], 30);
    EXPECT_GE(report["clusters"], 4);
    EXPECT_GE(report["clips"], report["clusters"]);
    EXPECT_GT(report["edges"], 0);
    EXPECT_GT(report["pairs_with_path"], 0);
    EXPECT_GE(report["seconds"]["threshold"], 0);
    EXPECT_GE(report["seconds"]["clustering"], 0);
    EXPECT_GE(report["seconds"]["paths"], 0);
    const auto coarse = json({"clusters", lib(), "--threshold", "50"});
    EXPECT_EQ(coarse["clusters"], 1);
    EXPECT_EQ(coarse["edges"], 0);
    EXPECT_EQ(kumite({"clusters", lib()}).code, 0);
}

TEST_F(SequenceCommands, ATransitionIsWrittenAsItIsSaid) {
    for (const std::string method : {"graph", "bezier", "linear"}) {
        const auto report = json({"transition", lib(), "--from", "arm@0:90", "--to", "leg@30:150",
                                  "--out", out, "--method", method, "--undirected", "--seed", "3"});
        EXPECT_EQ(report["method"], method);
        const Motion written = *readRecording(out).motions.front();
        EXPECT_EQ(written.frameCount, report["frames"]);
        EXPECT_EQ(rateOf(written.frameTime), 30);
        EXPECT_EQ(written.skeleton->joints.size(), test::makeHuman()->joints.size());
        EXPECT_LE(report["begin"], report["end"]);
        EXPECT_EQ(report["path"].empty(), method == "linear");
        EXPECT_TRUE(report["quality"].contains("foot_skate"));
    }
    const auto again = [&] {
        kumite({"transition", lib(), "--from", "arm", "--to", "leg", "--out", out, "--seed", "9"});
        return test::readText(out);
    };
    EXPECT_EQ(again(), again());
}

TEST_F(SequenceCommands, ASequenceListsItsPieces) {
    const auto report =
        json({"sequence", lib(), "--play", "arm", "leg@30:150", "arm@90:", "--out", out});
    ASSERT_EQ(report["pieces"].size(), 5u);
    int at = 0;
    for (const auto& piece : report["pieces"]) {
        EXPECT_EQ(piece["begin"], at);
        at = piece["end"];
    }
    EXPECT_EQ(at, report["frames"]);
    EXPECT_EQ(readRecording(out).motions.front()->frameCount, at);
    const Result text = kumite({"sequence", lib(), "--play", "arm", "leg", "--out", out});
    EXPECT_EQ(text.code, 0);
    EXPECT_NE(text.out.find("leg"), std::string::npos);
}

TEST_F(SequenceCommands, WrongUsageIsTwoAndFailureIsOne) {
    const std::vector<std::vector<std::string>> usage = {
        {"clusters"},
        {"clusters", lib(), "--rate", "0"},
        {"clusters", lib(), "--threshold", "-1"},
        {"clusters", lib(), "--threshold", "fine"},
        {"transition", lib(), "--from", "arm", "--out", out},
        {"transition", lib(), "--from", "arm", "--to", "leg"},
        {"transition", lib(), "--from", "arm", "--to", "leg", "--out", out, "--method", "magic"},
        {"transition", lib(), "--from", "arm", "--to", "leg", "--out", out, "--path", "-2"},
        {"transition", lib(), "--from", "arm", "--to", "leg", "--out", out, "--seed", "x"},
        {"sequence", lib(), "--out", out},
        {"sequence", lib(), "--play", "--out", out}};
    for (const auto& words : usage) {
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 2) << words[0] << " " << words.back() << result.err;
        EXPECT_NE(result.err, "");
    }
    const std::string own = (folder / "lib/arm.bvh").string();
    const std::vector<std::vector<std::string>> failing = {
        {"clusters", (folder / "absent").string()},
        {"clusters", (folder / "absent.bvh").string()},
        {"transition", lib(), "--from", "arm", "--to", "nobody", "--out", out},
        {"transition", lib(), "--from", "arm@9:3", "--to", "leg", "--out", out},
        {"transition", lib(), "--from", "arm", "--to", "leg", "--out", out, "--path", "99"},
        {"transition", own, "--from", "arm", "--to", "arm", "--out", own},
        {"transition", lib(), "--from", "arm", "--to", "leg", "--out",
         (folder / "no/such/folder.bvh").string()},
        {"sequence", lib(), "--play", "arm", "leg@0.1,1.2,x", "--out", out},
        {"sequence", lib(), "--play", "arm", "", "--out", out}};
    for (const auto& words : failing) {
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 1) << words[0] << " " << words.back() << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(SequenceCommands, TheLibraryIsNeverOverwritten) {
    const std::string own = (folder / "lib/leg.bvh").string();
    const std::string before = test::readText(own);
    const Result result =
        kumite({"transition", lib(), "--from", "arm", "--to", "leg", "--out", own});
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(test::readText(own), before);
}

}  // namespace
}  // namespace kumite
