// kumite label and kumite labels on a short demo bout.
#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/command_line.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::kumite;
using test::Result;

class LabelCommand : public testing::Test {
protected:
    test::TemporaryFolder folder;
    std::string project, truth;

    void SetUp() override {
        const std::string out = (folder / "demo").string();
        ASSERT_EQ(kumite({"demo", "--out", out, "--seconds", "40", "--seed", "3"}).code, 0);
        project = out + "/demo.kumite";
        truth = out + "/truth.json";
    }
    nlohmann::json json(const std::vector<std::string>& words) {
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    }
    nlohmann::json simulate(const std::string& strategy) {
        return json({"label", project, "--simulate", truth, "--strategy", strategy, "--budget",
                     "0.25", "--json"});
    }
};

TEST_F(LabelCommand, SimulatesASession) {
    const std::string before = test::readText(project);
    const auto active = simulate("active");
    EXPECT_NEAR(active["labelled_share"].get<double>(), 0.25, 0.01);
    EXPECT_EQ(active["judged"].get<int>() + active["labelled"].get<int>(), active["actions"]);
    EXPECT_GT(active["limb_accuracy"].get<double>(), 0.8);
    EXPECT_GT(active["label_accuracy"].get<double>(),
              active["baseline_accuracy"].get<double>() + 0.3);
    for (const char* aspect :
         {"left_punch", "right_punch", "left_kick", "right_kick", "jump", "react", "move"}) {
        EXPECT_GT(active["aspects"][aspect]["accuracy"].get<double>(), 0.7) << aspect;
        EXPECT_TRUE(active["aspects"][aspect].contains("macro_f1"));
    }
    EXPECT_EQ(active["curve"].back()["labelled"], active["labelled"]);
    auto again = simulate("active");
    again["seconds"] = active["seconds"];
    EXPECT_EQ(again, active) << "the same seed gives the same session";
    EXPECT_TRUE(simulate("random").contains("curve"));
    EXPECT_EQ(test::readText(project), before) << "a simulation changes nothing";
}

TEST_F(LabelCommand, ImportsLearnsAndWrites) {
    const auto imported = json({"label", project, "--import", truth, "--json"});
    EXPECT_GT(imported["matched"].get<int>(), 0.8 * imported["read"].get<int>());
    const std::string csv = (folder / "labels.csv").string();
    ASSERT_EQ(kumite({"labels", project, "--out", csv}).code, 0);

    // Half of the table as a user's labels; the machine does the rest.
    std::istringstream lines(test::readText(csv));
    std::string line, half;
    for (int i = 0; std::getline(lines, line); ++i) {
        if (i % 2 == 0) half += line + "\n";
    }
    const std::string part = (folder / "half.csv").string();
    test::writeText(part, half);
    ASSERT_EQ(
        kumite({"demo", "--out", (folder / "demo").string(), "--seconds", "40", "--seed", "3"})
            .code,
        0);
    const auto some = json({"label", project, "--import", part, "--json"});
    EXPECT_EQ(some["matched"], some["read"]);
    const auto automatic = json({"label", project, "--auto", "--json"});
    EXPECT_EQ(automatic["labelled_by_hand"], some["matched"]);
    const std::string saved = test::readText(project);
    EXPECT_EQ(json({"label", project, "--auto", "--json"})["training_sha256"],
              automatic["training_sha256"]);
    EXPECT_EQ(test::readText(project), saved) << "retraining gives the same labels";
    for (const char* name : {"labels.csv", "labels.json", "labels.eaf"}) {
        ASSERT_EQ(kumite({"labels", project, "--out", (folder / name).string()}).code, 0);
    }
    const std::string all = test::readText(csv);
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n') - 1, automatic["actions"].get<int>());
    EXPECT_NE(all.find(",machine,"), std::string::npos);
    EXPECT_NE(all.find(",hand,"), std::string::npos);
}

TEST_F(LabelCommand, FindsJudgesAndComparesActions) {
    ASSERT_EQ(kumite({"label", project, "--import", truth}).code, 0);
    const auto found = json({"labels", project, "--filter", "kick, by hand, player 2", "--json"});
    ASSERT_GT(found["count"].get<int>(), 0);
    EXPECT_EQ(found["filter"], "kick · by hand · fighter 2");
    for (const auto& each : found["actions"]) {
        EXPECT_EQ(each["player"], 2);
        EXPECT_EQ(each["source"], "hand");
        EXPECT_NE(each["label"].get<std::string>().find("kick:"), std::string::npos);
    }
    const Result text = kumite({"labels", project, "--filter", "kick, by hand, player 2"});
    EXPECT_EQ(std::count(text.out.begin(), text.out.end(), '\n'), found["count"].get<int>() + 1);

    const auto& first = found["actions"][0];
    const std::string name =
        first["take"].get<std::string>() + ":2:" + std::to_string(first["action"].get<int>());
    const auto similar =
        json({"labels", project, "--similar", name, "--count", "4", "--json"})["similar"];
    ASSERT_EQ(similar.size(), 4u);
    EXPECT_LE(similar[0]["distance"], similar[3]["distance"]);

    const auto judged = json({"labels", project, "--curve", "--json"});
    EXPECT_GT(judged["aspects"]["left_punch"]["accuracy"].get<double>(), 0.8);
    EXPECT_GT(judged["curve"].size(), 3u);
    EXPECT_EQ(kumite({"labels", project, "--filter", "kik"}).code, 1);
    EXPECT_EQ(kumite({"labels", project}).code, 2);
    EXPECT_EQ(kumite({"labels", project, "--similar", "12"}).code, 2);
    EXPECT_EQ(kumite({"labels", project, "--similar", "none:1:1"}).code, 1);
    EXPECT_EQ(kumite({"labels", project, "--judge", "--filter", "kick"}).code, 2);
}

TEST_F(LabelCommand, ComparesAndMergesTwoPeople) {
    ASSERT_EQ(kumite({"label", project, "--import", truth}).code, 0);
    const std::string eaf = (folder / "mine.eaf").string();
    ASSERT_EQ(kumite({"labels", project, "--out", eaf}).code, 0);
    const auto same = json({"labels", project, "--compare", eaf, "--json"});
    EXPECT_EQ(same["kappa"], 1.0);
    EXPECT_EQ(same["both"], same["same"]);
    EXPECT_TRUE(same["differences"].empty());

    // Somebody else saw the first left punch the other way.
    std::string other = test::readText(eaf);
    const auto at = other.find("<ANNOTATION_VALUE>fwd</");
    ASSERT_NE(at, std::string::npos);
    other.replace(at + 18, 3, "bwd");
    const std::string theirs = (folder / "theirs.eaf").string();
    test::writeText(theirs, other);
    const std::string table = (folder / "differences.csv").string();
    const auto compared =
        json({"labels", project, "--compare", theirs, "--differences", table, "--json"});
    EXPECT_EQ(compared["differences"].size(), 1u);
    EXPECT_LT(compared["kappa"].get<double>(), 1.0);
    EXPECT_EQ(compared["differences"][0]["first"], "fwd");
    EXPECT_EQ(compared["differences"][0]["second"], "bwd");
    const std::string rows = test::readText(table);
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2);
    EXPECT_EQ(
        json({"labels", project, "--compare", theirs, eaf, "--json"})["differences"][0]["first"],
        "bwd");
    EXPECT_EQ(json({"labels", project, "--compare", project, "--json"})["kappa"], 1.0);

    const std::string before = test::readText(project);
    const Result merged = kumite({"label", project, "--import", theirs, "--merge"});
    EXPECT_EQ(merged.code, 0) << merged.err;
    EXPECT_NE(merged.out.find("1 value differs"), std::string::npos) << merged.out;
    EXPECT_EQ(test::readText(project), before) << "my labels stay";
    EXPECT_EQ(kumite({"label", project, "--import", theirs}).code, 0);
    EXPECT_NE(test::readText(project), before) << "without --merge the file wins";
    EXPECT_EQ(kumite({"labels", project, "--compare", theirs, "--out", table}).code, 2);
    EXPECT_EQ(kumite({"labels", project}).code, 2);
    EXPECT_EQ(kumite({"labels", project, "--compare", theirs, "--differences", theirs}).code, 1);
}

TEST_F(LabelCommand, SaysWhatIsWrong) {
    EXPECT_EQ(kumite({"label", project}).code, 2);
    EXPECT_EQ(kumite({"label", project, "--auto", "--import", truth}).code, 2);
    EXPECT_EQ(kumite({"label", project, "--simulate", truth, "--budget", "2"}).code, 2);
    EXPECT_EQ(kumite({"label", project, "--budget", "0.1", "--auto"}).code, 2);
    EXPECT_EQ(kumite({"labels", project, "--out", (folder / "l.txt").string()}).code, 1);
    EXPECT_EQ(kumite({"labels", project, "--out", project}).code, 1);
    EXPECT_EQ(kumite({"label", project, "--import", (folder / "none.csv").string()}).code, 1);
}

}  // namespace
}  // namespace kumite
