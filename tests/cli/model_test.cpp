// kumite model and kumite why on a short demo bout.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/command_line.h"
#include "tests/cli/labelled_demo.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::kumite;
using test::Result;

class ModelCommand : public test::LabelledDemo {
protected:
    nlohmann::json json(const std::vector<std::string>& words) {
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    }
};

TEST_F(ModelCommand, WritesTablesPicturesAndTheGraph) {
    const std::string out = (*folder / "report").string();
    auto first = json({"model", project, "--seeds", "2", "--json", "--report", out});
    EXPECT_GT(first["labels"][0].get<int>(), 10);
    EXPECT_GT(first["transitions"][1].get<int>(), 20);
    EXPECT_GT(first["variance_covered"].get<double>(), 0.2);
    for (const char* name : {"EQU5", "EQU6", "EQU7", "UNIFORM"}) {
        for (const char* key : {"train", "validation", "validation_sd"})
            EXPECT_TRUE(first["label_term"][name][key].is_number()) << name << key;
    }
    for (const char* name : {"FULL", "FULL_RAW", "DIAGONAL", "SEMITIED"})
        EXPECT_TRUE(first["geometry_term"][name]["validation"].is_number()) << name;
    EXPECT_LT(first["label_term"]["UNIFORM"]["train"].get<double>(),
              first["label_term"]["EQU7"]["train"].get<double>());
    ASSERT_EQ(first["pca"].size(), 12u);
    EXPECT_EQ(first["pca"][2]["k"], 3);
    for (const char* name :
         {"report.md", "model.json", "table2.csv", "table3.csv", "fig11.csv", "table2.svg",
          "table3.svg", "fig11.svg", "next_player1.svg", "next_player2.svg", "graph.csv"}) {
        EXPECT_FALSE(test::readText(*folder / "report" / name).empty()) << name;
    }
    const auto graph = nlohmann::json::parse(test::readText(*folder / "report" / "graph.json"));
    EXPECT_EQ(graph["players"][0]["labels"].size(), first["labels"][0]);
    EXPECT_EQ(graph["players"][1]["transitions"].size(), first["transitions"][1]);
    const std::string xml = test::readText(*folder / "report" / "graph.graphml");
    EXPECT_NE(xml.find("</graphml>"), std::string::npos);

    auto second = json({"model", project, "--seeds", "2", "--json"});
    first.erase("seconds");
    second.erase("seconds");
    EXPECT_EQ(first, second) << "the same seeds give the same figures";
}

TEST_F(ModelCommand, WithoutShrinkageItIsThePlainMethod) {
    const auto plain = json({"model", project, "--seeds", "1", "--shrinkage", "0", "--json"});
    const auto usual = json({"model", project, "--seeds", "1", "--json"});
    EXPECT_EQ(plain["shrinkage_tau"], 0);
    EXPECT_EQ(plain["shrinkage"][0]["tau"], 0);
    // Labels seen once have no spread of their own, and nothing to borrow.
    EXPECT_EQ(plain["geometry_term"]["SEMITIED"]["train"], plain["shrinkage"][0]["train"]);
    EXPECT_GT(plain["geometry_term"]["SEMITIED"]["train"].get<double>(),
              usual["geometry_term"]["SEMITIED"]["train"].get<double>());
    EXPECT_LT(plain["geometry_term"]["SEMITIED"]["validation"].get<double>(),
              usual["geometry_term"]["SEMITIED"]["validation"].get<double>());
}

TEST_F(ModelCommand, AnAvatarsModelHasTwoDimensionsMore) {
    const auto plain = json({"model", project, "--seeds", "1", "--json"});
    const auto led = json({"model", project, "--seeds", "1", "--target", "--json"});
    EXPECT_EQ(plain["dimensions"], 36);
    EXPECT_EQ(led["dimensions"], 38);
    EXPECT_EQ(led["label_term"], plain["label_term"]);
    for (const char* name : {"FULL", "FULL_RAW", "DIAGONAL", "SEMITIED"}) {
        EXPECT_TRUE(led["geometry_term"][name]["validation"].is_number()) << name;
        EXPECT_NE(led["geometry_term"][name], plain["geometry_term"][name]);
    }
}

TEST_F(ModelCommand, SaysWhatToDoWithoutLabels) {
    const Result result = kumite({"model", bare});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("kumite label --auto"), std::string::npos) << result.err;
    EXPECT_EQ(kumite({"why", bare, "--frame", "100"}).code, 1);
    EXPECT_EQ(kumite({"model", project, "--split", "takes"}).code, 1) << "there is one take";
    EXPECT_EQ(kumite({"model", project, "--graph", (*folder / "g.txt").string()}).code, 1);
    EXPECT_EQ(kumite({"model", project, "--graph", project}).code, 1);
    EXPECT_EQ(kumite({"model", project, "--seeds", "0"}).code, 2);
}

TEST_F(ModelCommand, WhyRanksTheNextLabels) {
    const std::string graph = (*folder / "graph.json").string();
    ASSERT_EQ(kumite({"model", project, "--graph", graph}).code, 0);
    const auto known = nlohmann::json::parse(test::readText(graph));
    const auto& moment = known["players"][1]["transitions"][7];
    const std::string frame = std::to_string(moment["frame"].get<int>());
    const auto why = json({"why", project, "--frame", frame, "--mover", "2", "--json"});
    const auto& labels = known["players"][1]["labels"];
    EXPECT_EQ(why["own"], labels[moment["own"].get<std::size_t>()]["label"]);
    EXPECT_EQ(why["observed"], labels[moment["next"].get<std::size_t>()]["label"]);
    EXPECT_EQ(why["surprise"]["label"], moment["label_surprise"]);
    double product = 0, label = 0, geometry = 0;
    for (const auto& next : why["next"]) {
        product += next["product"].get<double>();
        label += next["label_term"].get<double>();
        geometry += next["geometry_term"].get<double>();
    }
    EXPECT_NEAR(product, 1, 1e-4);
    EXPECT_NEAR(label, 1, 1e-4);
    EXPECT_NEAR(geometry, 1, 1e-4);

    const auto alone = json({"why", project, "--mover", "2", "--own", why["own"], "--opponent",
                             why["opponent"], "--json"});
    EXPECT_FALSE(alone["next"][0].contains("geometry_term"));
    EXPECT_EQ(kumite({"why", project, "--frame", frame}).code, 0);
    EXPECT_EQ(kumite({"why", project}).code, 2);
    EXPECT_EQ(kumite({"why", project, "--frame", "1", "--own", "move:L-R"}).code, 2);
    EXPECT_EQ(kumite({"why", project, "--frame", "1000000"}).code, 1);
    EXPECT_EQ(kumite({"why", project, "--own", "jump:up+jump:down"}).code, 1);
}

}  // namespace
}  // namespace kumite
