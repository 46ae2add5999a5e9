// kumite label with another sport's vocabulary, and with next to nothing to learn from.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "tests/cli/command_line.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::kumite;

constexpr char kFencing[] = R"({
  "vocabulary": 1, "name": "Fencing", "aspects": [
    {"id": "blade", "name": "Blade", "classifier": "msvm", "fallback": "rest", "limb": "right_wrist",
     "strike": "hit", "colour": "#d8573a", "key": "Q", "qualifiers": [
       {"id": "thrust", "name": "thrust", "colour": "#d8573a", "key": "1", "attack": true},
       {"id": "draw", "name": "drawn back", "colour": "#eaa18e", "key": "2"},
       {"id": "rest", "name": "at rest", "colour": "#8a8f98", "key": "0"}]},
    {"id": "parry", "name": "Parry", "classifier": "rule", "rule": "react", "fallback": "none",
     "colour": "#3a86d8", "key": "W", "qualifiers": [
       {"id": "hit", "name": "a hit", "colour": "#3a86d8", "key": "1"},
       {"id": "none", "name": "none", "colour": "#8a8f98", "key": "0"}]}]})";

class Sport : public testing::Test {
protected:
    test::TemporaryFolder folder;
    std::string project;

    void SetUp() override {
        const std::string out = (folder / "demo").string();
        ASSERT_EQ(kumite({"demo", "--out", out, "--seconds", "40", "--seed", "3"}).code, 0);
        project = out + "/demo.kumite";
        test::writeText(folder / "fencing.json", kFencing);
        ASSERT_EQ(
            kumite({"label", project, "--vocabulary", (folder / "fencing.json").string()}).code, 0);
    }
    /// Fencing's words for the demo bout's right punches: all labels of its truth.
    std::vector<std::string> fencingRows() {
        const auto truth = nlohmann::json::parse(test::readText(folder / "demo" / "truth.json"));
        const double rate = truth["rate"];
        std::vector<std::string> rows;
        for (int p = 0; p < 2; ++p) {
            for (const auto& action : truth["players"][p]["actions"]) {
                const std::string punch = action["label"].value("right_punch", "others");
                const char* blade = punch == "bwd"      ? "blade:draw"
                                    : punch == "others" ? "others"
                                                        : "blade:thrust";
                rows.push_back(std::to_string(p + 1) + "," +
                               fixed(action["begin"].get<double>() / rate, 4) + "," +
                               fixed(action["end"].get<double>() / rate, 4) + "," + blade);
            }
        }
        return rows;
    }
    void import(const std::vector<std::string>& rows, int step) {
        std::string csv = "player,begin_s,end_s,label\n";
        for (std::size_t i = 0; i < rows.size(); i += static_cast<std::size_t>(step))
            csv += rows[i] + "\n";
        test::writeText(folder / "labels.csv", csv);
        const auto result =
            kumite({"label", project, "--import", (folder / "labels.csv").string()});
        ASSERT_EQ(result.code, 0) << result.err;
    }
    nlohmann::json automatic() {
        const auto result = kumite({"label", project, "--auto", "--json"});
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    }
};

TEST_F(Sport, FencingFromVocabularyToAgreement) {
    const auto rows = fencingRows();
    import(rows, 2);
    EXPECT_GT(automatic()["expected_accuracy"].get<double>(), 0.7);
    const std::string eaf = (folder / "fencing.eaf").string();
    ASSERT_EQ(kumite({"labels", project, "--out", eaf}).code, 0);
    EXPECT_NE(test::readText(eaf).find("fighter 1 blade"), std::string::npos);
    // What the machine said of the other half, against the truth.
    std::string truth = "player,begin_s,end_s,label\n";
    for (const std::string& row : rows)
        truth += row + "\n";
    test::writeText(folder / "truth.csv", truth);
    const auto compared = kumite({"labels", project, "--compare", (folder / "truth.csv").string(),
                                  eaf, "--everybody", "--json"});
    ASSERT_EQ(compared.code, 0) << compared.err;
    const auto json = nlohmann::json::parse(compared.out);
    EXPECT_GT(json["aspects"]["blade"]["kappa"].get<double>(), 0.6) << compared.out;
    EXPECT_FALSE(json["aspects"].contains("left_kick"));
    // The kickboxing truth has no meaning here, and that is said.
    const auto wrong =
        kumite({"label", project, "--import", (folder / "demo" / "truth.json").string()});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.err.find("is no aspect of Fencing"), std::string::npos) << wrong.err;
}

TEST_F(Sport, NothingOneExampleAndOneClass) {
    EXPECT_EQ(automatic()["examples"], 0);
    const auto rows = fencingRows();
    std::vector<std::string> thrusts;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(thrusts),
                 [](const std::string& row) { return row.find("thrust") != std::string::npos; });
    import({thrusts.front()}, 1);
    EXPECT_EQ(automatic()["examples"], 1);
    import(thrusts, 1);
    const auto one = automatic();
    // All of one class were found right; so few prove no more: (n + 1) / (n + 2).
    const double examples = one["examples"];
    EXPECT_NEAR(one["expected_accuracy"].get<double>(), (examples + 1) / (examples + 2), 1e-6);
    // The rule of three: of n examples of one kind, others are rarer than 3 / n.
    ASSERT_EQ(kumite({"labels", project, "--out", (folder / "out.csv").string()}).code, 0);
    const std::string csv = test::readText(folder / "out.csv");
    EXPECT_EQ(csv.find("draw"), std::string::npos);
    const std::string sure = fixed(1 - 3.0 / one["examples"].get<double>(), 3);
    EXPECT_NE(csv.find("machine," + sure), std::string::npos) << csv;
}

}  // namespace
}  // namespace kumite
