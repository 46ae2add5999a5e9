// kumite bout in all modes on a short demo bout.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/formats/recording.h"
#include "tests/cli/command_line.h"
#include "tests/cli/labelled_demo.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::kumite;
using test::Result;

class BoutCommandLine : public test::LabelledDemo {
protected:
    static std::string out(const std::string& name) { return (*folder / name).string(); }
    static nlohmann::json log(const std::string& name) {
        return nlohmann::json::parse(test::readText(*folder / name / "log.json"));
    }
};

TEST_F(BoutCommandLine, WritesTwoMotionsAndTheLogAndSaysHowGoodItIs) {
    const Result result = kumite({"bout", project, "--seconds", "5", "--seed", "7", "--out",
                                  out("auto"), "--strips", out("strips.svg"), "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["frames"], 301);
    for (const char* key : {"us_per_frame", "choice_ms", "quality", "recording_quality"})
        EXPECT_TRUE(json.contains(key)) << key;
    for (const char* key :
         {"foot_skate", "penetration", "interpenetration", "penetration_cm", "interpenetration_cm",
          "join_acceleration_p99_ratio", "facing_error_deg", "hit_timing_ms", "variety"}) {
        EXPECT_TRUE(json["quality"].contains(key)) << key;
        EXPECT_TRUE(json["recording_quality"].contains(key)) << key;
    }
    for (const char* name : {"player1.bvh", "player2.bvh"}) {
        const Recording written = readRecording(*folder / "auto" / name);
        EXPECT_EQ(written.motions.front()->frameCount, 301);
        EXPECT_NEAR(rateOf(written.motions.front()->frameTime), 60, 1e-9);
    }
    const std::string strips = test::readText(*folder / "strips.svg");
    EXPECT_NE(strips.find("recorded: take demo"), std::string::npos);
    EXPECT_EQ(log("auto")["seed"], 7);
    EXPECT_EQ(log("auto")["choices"].size(), json["choices"].get<std::size_t>());
    const auto choice = log("auto")["choices"][0];
    double chances = 0;
    for (const auto& candidate : choice["candidates"])
        chances += candidate["chance"].get<double>();
    EXPECT_NEAR(chances, 1, 1e-4);

    ASSERT_EQ(
        kumite({"bout", project, "--seconds", "5", "--seed", "7", "--out", out("again")}).code, 0);
    for (const char* name : {"player1.bvh", "player2.bvh", "log.json"}) {
        EXPECT_EQ(test::readText(*folder / "auto" / name), test::readText(*folder / "again" / name))
            << name;
    }
}

TEST_F(BoutCommandLine, ReportsItsQualityBesideTheRecordings) {
    const Result result = kumite({"bout", project, "--seconds", "20", "--seed", "3", "--out",
                                  out("reported"), "--report", out("report"), "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto said = nlohmann::json::parse(result.out);
    const auto json = nlohmann::json::parse(test::readText(*folder / "report" / "quality.json"));
    EXPECT_EQ(json["quality"], said["quality"]);
    EXPECT_EQ(json["recording_quality"], said["recording_quality"]);
    EXPECT_EQ(json["seed"], 3);
    EXPECT_GT(json["quality"]["join_acceleration_p99_ratio_as_recorded"], 0);
    EXPECT_TRUE(json["recording_quality"]["join_acceleration_p99_ratio_as_recorded"].is_null());
    const std::string page = test::readText(*folder / "report" / "report.md");
    for (const char* words : {"feet skate", "as recorded", "| bout | recording |", "(strips.svg)"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
    const std::string strips = test::readText(*folder / "report" / "strips.svg");
    EXPECT_NE(strips.find("recorded: take demo"), std::string::npos);
}

TEST_F(BoutCommandLine, AnAvatarFollowsItsScript) {
    const auto script = *folder / "keys.json";
    test::writeText(script, R"({"kumite_script": 1, "commands": [
        {"at": 0.5, "act": "punch"}, {"at": 1, "target": [0.2, 0.4]},
        {"at": 2, "player": 2, "weigh": "jump:up", "factor": 0}]})");
    const Result result =
        kumite({"bout", project, "--mode", "avatar", "--avatar", "2", "--seconds", "6", "--script",
                script.string(), "--command-first", "--out", out("avatar")});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto json = log("avatar");
    EXPECT_EQ(json["commands"].size(), 3u);
    int commanded = 0;
    for (const auto& choice : json["choices"]) {
        if (!choice.contains("commanded")) continue;
        ++commanded;
        EXPECT_EQ(choice["player"], 2);
        EXPECT_NE(choice["chosen"].get<std::string>().find("punch"), std::string::npos);
    }
    EXPECT_EQ(commanded, 1);
}

TEST_F(BoutCommandLine, APassiveOneAnswersACapturedAttack) {
    const Result result =
        kumite({"bout", project, "--mode", "passive", "--attacker", "2", "--attack", "demo:300:900",
                "--seconds", "8", "--out", out("passive")});
    ASSERT_EQ(result.code, 0) << result.err;
    const auto json = log("passive");
    EXPECT_EQ(json["attacker"], 2);
    EXPECT_GT(json["attack"].size(), 3u);
    for (const auto& action : json["attack"]) {
        EXPECT_GE(action["begin"], 300);
        EXPECT_LT(action["begin"], 900);
    }
    for (const auto& choice : json["choices"]) {
        if (choice["player"] == 2) {
            EXPECT_EQ(choice["replayed"], true);
            continue;
        }
        const bool outside =
            choice["sample"]["end"].get<int>() <= json["attack"].front()["begin"].get<int>() ||
            choice["sample"]["begin"].get<int>() >= json["attack"].back()["end"].get<int>();
        EXPECT_TRUE(outside) << choice["sample"].dump();
    }
    EXPECT_EQ(
        kumite({"bout", project, "--mode", "passive", "--seconds", "2", "--out", out("busiest")})
            .code,
        0);
}

TEST_F(BoutCommandLine, SaysWhatIsWrong) {
    EXPECT_EQ(kumite({"bout", project}).code, 2) << "--out is needed";
    EXPECT_EQ(kumite({"bout", project, "--mode", "boxing", "--out", out("x")}).code, 2);
    EXPECT_EQ(kumite({"bout", project, "--attack", "demo:1:2", "--out", out("x")}).code, 2);
    EXPECT_EQ(
        kumite({"bout", project, "--mode", "passive", "--attack", "demo", "--out", out("x")}).code,
        2);
    const Result none = kumite({"bout", bare, "--out", out("x")});
    EXPECT_EQ(none.code, 1);
    EXPECT_NE(none.err.find("kumite label"), std::string::npos) << none.err;
    const auto script = *folder / "wrong.json";
    test::writeText(script, R"({"kumite_script": 1, "commands": [{"at": 1, "act": "headbutt"}]})");
    const Result wrong = kumite({"bout", project, "--mode", "avatar", "--script", script.string(),
                                 "--seconds", "1", "--out", out("x")});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.err.find("headbutt"), std::string::npos) << wrong.err;
    test::writeText(script, R"({"kumite_script": 1, "commands": [{"at": 1, "act": "kick"}]})");
    const Result steered =
        kumite({"bout", project, "--script", script.string(), "--seconds", "1", "--out", out("x")});
    EXPECT_EQ(steered.code, 1);
    EXPECT_NE(steered.err.find("avatar"), std::string::npos) << steered.err;
}

}  // namespace
}  // namespace kumite
