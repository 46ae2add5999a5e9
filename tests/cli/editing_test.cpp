// kumite hit and kumite keyframes on a short demo bout.
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/formats/recording.h"
#include "core/motion/heading.h"
#include "core/motion/survey.h"
#include "tests/cli/command_line.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using Eigen::Vector3d;
using test::kumite;
using test::Result;

/// One labelled bout for all tests.
class EditingCommands : public testing::Test {
protected:
    static inline test::TemporaryFolder* folder = nullptr;
    static inline std::string project, player1;

    static void SetUpTestSuite() {
        folder = new test::TemporaryFolder;
        const std::string out = (*folder / "demo").string();
        ASSERT_EQ(kumite({"demo", "--out", out, "--seconds", "60", "--seed", "5"}).code, 0);
        project = out + "/demo.kumite";
        player1 = out + "/player1.bvh";
        ASSERT_EQ(kumite({"label", project, "--import", out + "/truth.json"}).code, 0);
    }
    static void TearDownTestSuite() {
        delete folder;
        folder = nullptr;
    }
    std::string path(const std::string& name) { return (*folder / name).string(); }
    nlohmann::json json(const std::vector<std::string>& words) {
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 0) << result.err;
        return result.code == 0 ? nlohmann::json::parse(result.out) : nlohmann::json();
    }
};

/// What a stranger sees in a written file: joint places, metres.
struct Written {
    std::shared_ptr<const Motion> motion;
    Survey survey;
    JointPositions positions;

    explicit Written(const std::string& file) {
        motion = readRecording(file).motions.front();
        survey = surveyMotion(*motion);
        positions = forwardKinematics(*motion, motion->frames(), survey.space);
    }
    Vector3d at(int frame, Role role) const {
        return positions.at(frame, *survey.roles.roles[role]).cast<double>();
    }
};

Vector3d pointOf(const nlohmann::json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

TEST_F(EditingCommands, HitsATargetAndMeasuresWhatIsWritten) {
    for (const auto& [strike, role] :
         {std::pair("right_punch", Role::RightWrist), std::pair("left_kick", Role::LeftToe)}) {
        const std::string out = path("hit.bvh");
        // The middle of what the examples hit.
        const auto first = json({"hit", project, "--strike", strike, "--player", "1", "--target",
                                 "0,1.2,0.7", "--out", out, "--json"});
        ASSERT_GT(first["examples"].size(), 2u) << strike;
        Vector3d target = Vector3d::Zero();
        for (const auto& example : first["examples"])
            target += pointOf(example["point"]) / static_cast<double>(first["examples"].size());
        const std::string words = std::to_string(target.x()) + "," + std::to_string(target.y()) +
                                  "," + std::to_string(target.z());
        for (const char* method : {"full", "partial", "best"}) {
            const auto hit =
                json({"hit", project, "--strike", strike, "--player", "1", "--target=" + words,
                      "--out", out, "--method", method, "--json"});
            EXPECT_NEAR((pointOf(hit["target"]) - target).norm(), 0, 1e-4);
            const Written written(out);
            const Vector3d reached = written.at(hit["frame"], role);
            EXPECT_NEAR((reached - pointOf(hit["reached"])).norm(), 0, 1e-4) << strike << method;
            EXPECT_NEAR(100 * (reached - target).norm(), hit["error_cm"].get<double>(), 0.02);
            EXPECT_EQ(hit["frames"].get<int>(), written.motion->frameCount);
            if (std::string(method) == "best") {
                EXPECT_LT(hit["error_cm"].get<double>(), 3) << strike;
                EXPECT_TRUE(hit["hits"].get<bool>());
            }
            // The file begins in the striker's frame.
            const Vector3d pelvis = written.at(0, Role::Pelvis);
            EXPECT_NEAR(std::hypot(pelvis.x(), pelvis.z()), 0, 1e-4);
            EXPECT_NEAR(headings(*written.motion, {0, 1}, written.survey.space,
                                 written.survey.roles.roles)[0],
                        0, 1e-3);
            for (const char* box : {"natural_region", "extended_box"}) {
                for (std::size_t axis = 0; axis < 3; ++axis)
                    EXPECT_LE(hit[box]["low"][axis].get<double>(),
                              hit[box]["high"][axis].get<double>());
            }
        }
    }
}

TEST_F(EditingCommands, AnUnreachableTargetIsSaid) {
    const std::string out = path("far.bvh");
    const Result result = kumite(
        {"hit", project, "--strike", "right_punch", "--target", "0,1,9", "--out", out, "--json"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.err.find("cannot be reached"), std::string::npos) << result.err;
    const auto hit = nlohmann::json::parse(result.out);
    EXPECT_FALSE(hit["hits"].get<bool>());
    EXPECT_GT(hit["error_cm"].get<double>(), 500);
    EXPECT_GT(pointOf(hit["reached"]).z(), 0.4) << "it reaches out all the same";
    EXPECT_FALSE(test::readText(out).empty());
}

TEST_F(EditingCommands, AStrikeAtATargetIsABlockOfASequence) {
    const auto hit = json({"hit", project, "--strike", "right_punch", "--player", "1", "--target",
                           "0,1.2,0.7", "--out", path("hit.bvh"), "--json"});
    const std::string name = hit["examples"][0]["name"];
    const Vector3d point = pointOf(hit["examples"][0]["point"]);
    const std::string at = "@" + std::to_string(point.x()) + "," + std::to_string(point.y()) + "," +
                           std::to_string(point.z());
    const auto made = json({"sequence", project, "--play", "demo:1:2", name + at, "demo:1:4",
                            "--out", path("sequence.bvh"), "--json"});
    EXPECT_TRUE(std::any_of(made["pieces"].begin(), made["pieces"].end(),
                            [&](const auto& piece) { return piece["clip"] == name + at; }));
    EXPECT_EQ(Written(path("sequence.bvh")).motion->frameCount, made["frames"].get<int>());
    const Result far = kumite({"sequence", project, "--play", "demo:1:2", name + "@0,1,9", "--out",
                               path("sequence.bvh")});
    EXPECT_EQ(far.code, 1);
    EXPECT_NE(far.err.find("cannot be reached: the nearest"), std::string::npos) << far.err;
}

TEST_F(EditingCommands, HitFindsTheStrikesOfAnUnlabelledFile) {
    const auto hit = json({"hit", player1, "--strike", "player1", "--limb", "right_hand",
                           "--target", "0,1.3,0.6", "--out", path("bare.bvh"), "--json"});
    EXPECT_GT(hit["examples"].size(), 3u);
    EXPECT_EQ(hit["limb"], "right_hand");
}

TEST_F(EditingCommands, HitRefusesWhatItCannotDo) {
    const std::string out = path("no.bvh");
    const auto code = [&](std::vector<std::string> words) {
        std::vector<std::string> all = {"hit", project, "--out", out};
        all.insert(all.end(), words.begin(), words.end());
        const Result result = kumite(all);
        EXPECT_FALSE(result.err.empty());
        return result.code;
    };
    EXPECT_EQ(code({"--strike", "right_punch", "--target", "0,1"}), 2);
    EXPECT_EQ(code({"--strike", "right_punch", "--target", "0,1,x"}), 2);
    EXPECT_EQ(code({"--strike", "right_punch", "--target", "0,1,1e9"}), 2);
    EXPECT_EQ(code({"--strike", "right_punch", "--target", "0,1,1", "--method", "magic"}), 2);
    EXPECT_EQ(code({"--strike", "right_punch", "--target", "0,1,1", "--limb", "tail"}), 2);
    EXPECT_EQ(code({"--target", "0,1,1"}), 2);
    EXPECT_EQ(code({"--strike", "headbutt", "--target", "0,1,1"}), 1);
    EXPECT_EQ(code({"--strike", "right_punch:bwdfwd,x", "--target", "0,1,1"}), 1);
    EXPECT_EQ(
        kumite({"hit", player1, "--strike", "player1", "--target", "0,1,1", "--out", player1}).code,
        1)
        << "a recording is never replaced";
}

TEST_F(EditingCommands, KeyPosesBecomeAMotion) {
    const std::string keys = path("keys.json"), out = path("keys.bvh");
    test::writeText(path("keys.json"), R"({"key_poses": 1, "rate": 60, "keys": [
        {"frame": 0, "clip": "player1", "at": 300}, {"frame": 20, "clip": "player1", "at": 320},
        {"frame": 40, "clip": "player1", "at": 340}, {"frame": 60, "clip": "player1", "at": 360},
        {"frame": 80, "clip": "player1", "at": 380}]})");
    const auto made = json({"keyframes", player1, "--keys", keys, "--out", out, "--json"});
    EXPECT_EQ(made["frames"], 81);
    EXPECT_EQ(made["keys"], 5);
    EXPECT_EQ(made["assembly"], "adjusted");
    EXPECT_EQ(made["body"]["clip"], "player1");
    EXPECT_EQ(made["body"]["mismatches"], 0);
    for (std::size_t k = 0; k < 5; ++k)
        EXPECT_NEAR(made["body"]["frames"][k].get<int>(), 300 + 20 * static_cast<int>(k), 1);
    EXPECT_EQ(Written(out).motion->frameCount, 81);

    const auto parts = json({"keyframes", project, player1, "--keys", keys, "--out", out, "--parts",
                             "right_arm=demo:2,left_arm=own,trunk=body", "--direct", "--json"});
    EXPECT_EQ(parts["assembly"], "direct");
    EXPECT_EQ(parts["parts"]["right_arm"]["clip"], "demo:2");
    EXPECT_EQ(parts["parts"]["trunk"], "body");
    EXPECT_FALSE(parts["junctions"].empty());
    EXPECT_EQ(kumite({"keyframes", player1, "--keys", keys, "--out", out}).code, 0);
}

TEST_F(EditingCommands, KeyframesRefusesWhatItCannotDo) {
    const std::string out = path("no.bvh");
    const auto run = [&](const std::string& text, std::vector<std::string> words = {}) {
        test::writeText(path("bad.json"), text);
        std::vector<std::string> all = {"keyframes",      player1, "--keys",
                                        path("bad.json"), "--out", out};
        all.insert(all.end(), words.begin(), words.end());
        return kumite(all);
    };
    const std::string good =
        R"({"key_poses": 1, "keys": [{"frame": 0, "clip": "player1", "at": 9}]})";
    EXPECT_EQ(run(good).code, 0) << "one key alone";
    EXPECT_EQ(run("").code, 1);
    EXPECT_EQ(run(R"({"key_poses": 1, "keys": [{"frame": 0, "clip": "nobody"}]})").code, 1);
    const Result late =
        run(R"({"key_poses": 1, "keys": [{"frame": 0, "clip": "player1", "at": 999999}]})");
    EXPECT_EQ(late.code, 1);
    EXPECT_NE(late.err.find("frames 0 to"), std::string::npos) << late.err;
    EXPECT_EQ(run(good, {"--parts", "tail=player1"}).code, 2);
    EXPECT_EQ(run(good, {"--parts", "left_arm"}).code, 2);
    EXPECT_EQ(run(good, {"--parts", "left_arm=nobody"}).code, 1);
    EXPECT_EQ(run(good, {"--direct", "--adjusted"}).code, 2);
    EXPECT_EQ(run(good, {"--meet", "7"}).code, 2);
    EXPECT_EQ(kumite({"keyframes", player1, "--keys", path("none.json"), "--out", out}).code, 1);
    EXPECT_EQ(
        kumite({"keyframes", player1, "--keys", path("bad.json"), "--out", path("bad.json")}).code,
        1);
}

TEST_F(EditingCommands, APageToRateHoldsEveryKindAndTheSameSeedMakesItAgain) {
    const auto make = [&](const std::string& name) {
        const Result result = kumite(
            {"rate", project, "--strike", "right_punch", "--clips", "3", "--out", path(name)});
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_NE(result.out.find("12 clips to rate"), std::string::npos) << result.out;
        std::ifstream file(path(name));
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_EQ(make("a.html"), make("b.html"));
    const Result none =
        kumite({"rate", project, "--strike", "left_elbow", "--out", path("none.html")});
    EXPECT_NE(none.code, 0);
    EXPECT_NE(none.err.find("left_elbow"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace kumite
