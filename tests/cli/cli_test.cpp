// The command line as scripts see it: words in, output and exit code out.

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/formats/bvh.h"
#include "core/project/versions.h"
#include "tests/cli/command_line.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using test::kumite;
using test::Result;

class Cli : public testing::Test {
protected:
    test::TemporaryFolder folder;
    std::string red = (folder / "red.bvh").string();
    std::string blue = (folder / "blue.bvh").string();
    std::string project = (folder / "bout.kumite").string();

    void SetUp() override {
        for (const int player : {0, 1}) {
            const auto motion =
                test::bobbing(361, 60, [player](double t) { return test::boutHeight(player, t); });
            test::writeText(player == 0 ? red : blue,
                            bvhText(*motion, motion->frames(), motion->frameTime));
        }
    }
    void makeProject() {
        const Result made = kumite({"new", "--out", project, "--take", "round1", red, blue});
        ASSERT_EQ(made.code, 0) << made.err;
    }
    nlohmann::json segment(const std::vector<std::string>& more = {}) {
        std::vector<std::string> words = {"segment", project, "--json"};
        words.insert(words.end(), more.begin(), more.end());
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    }
    nlohmann::json player(int number, const std::vector<std::string>& more = {}) {
        return segment(more)["takes"][0]["players"][static_cast<std::size_t>(number - 1)];
    }
};

TEST_F(Cli, EveryCommandHasHelpWithAnExample) {
    const Result general = kumite({"--help"});
    EXPECT_EQ(general.code, 0);
    for (const std::string command :
         {"info", "joints", "new", "force", "segment", "correct", "export", "relink"}) {
        EXPECT_NE(general.out.find("  " + command + " "), std::string::npos);
        const Result help = kumite({command, "--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_NE(help.out.find("Example: kumite " + command), std::string::npos) << help.out;
        EXPECT_EQ(help.err, "");
    }
    EXPECT_EQ(kumite({"--version"}).out.substr(0, 7), "kumite ");
}

TEST_F(Cli, TheManualPageHasEveryCommandAndOptionOfTheHelp) {
    const Result manual = kumite({"--man"});
    ASSERT_EQ(manual.code, 0);
    EXPECT_NE(manual.out.find("\n.TH KUMITE 1 "), std::string::npos);
    const auto named = [&](std::string word) {
        for (std::size_t i = 0; (i = word.find('-', i)) != std::string::npos; i += 2)
            word.insert(i, "\\");
        return manual.out.find(word) != std::string::npos;
    };
    const std::string help = kumite({"--help"}).out;
    const std::regex command(R"(\n  (\w+) {2,})"), option(R"((--[a-z][a-z-]*))");
    int commands = 0;
    for (std::sregex_iterator c(help.begin(), help.end(), command), end; c != end; ++c) {
        const std::string name = (*c)[1];
        ++commands;
        EXPECT_NE(manual.out.find(".SS " + name + "\n"), std::string::npos) << name;
        const std::string own = kumite({name, "--help"}).out;
        for (std::sregex_iterator o(own.begin(), own.end(), option); o != end; ++o)
            EXPECT_TRUE(named((*o)[1])) << name << " " << (*o)[1];
    }
    EXPECT_GE(commands, 20);
    // Also where options exclude several others, which the library would name in any order.
    EXPECT_NE(kumite({"label", "--help"}).out.find("--simulate TEXT Excludes: --auto --import"),
              std::string::npos);
}

TEST_F(Cli, WrongUsageIsTwoAndFailureIsOne) {
    makeProject();
    const std::vector<std::vector<std::string>> usage = {
        {},
        {"dance"},
        {"info"},
        {"correct"},
        {"segment", project, "--cutoff", "fast"},
        {"segment", project, "--cutoff", "0"},
        {"segment", project, "--prominence", "-1"},
        {"segment", project, "--json", "--csv"},
        {"new", "--out", project, "--take", "--rate", "60"},
        {"new", "--out", project, "--take", "a", red, "--rate", "0"},
        {"force", project, "--out", "x", "--player", "3"},
        {"correct", project, "--take", "round1"},
        {"correct", project, "--remove", "1", "--add", "2"},
        {"correct", project, "--move", "12"},
        {"new"},
        {"new", "--out", project},
        {"new", "--out", project, "--take"},
        {"new", "--out", project, "--take", "a"},
        {"new", "--take", "a", red},
        {"new", "--out", project, "--take", "a", red, blue, red},
        {"new", "--out", project, "--take", "a", red, "--rate", "fast"},
        {"new", "--out", project, "--take", "a", red, "--units", "yards"},
        {"new", "--out", project, "--take", "a", red, "--nonsense"},
        {"new", "--out", project, "--take", "a", red, "--place", "1,2"},
        {"new", "--out", project, "--take", "a", red, "--trim", "9"},
        {"new", "--out", project, "--offset", "1", "--take", "a", red},
        {"joints", red, "--out", "x", "--frames", "7:3"},
        {"joints", red, "--out", "x", "--up", "w"}};
    for (const auto& words : usage) {
        const Result result = kumite(words);
        std::string line;
        for (const auto& word : words)
            line += " " + word;
        EXPECT_EQ(result.code, 2) << line << result.err;
        EXPECT_NE(result.err, "") << line;
    }
    const std::vector<std::vector<std::string>> failing = {
        {"info", "absent.bvh"},
        {"segment", "absent.kumite"},
        {"segment", red},
        {"force", project, "--take", "round9", "--out", "x"},
        {"correct", project, "--take", "round1", "--remove", "0"},
        {"export", project, "--take", "round1", "--out", (folder / "x.fbx").string()},
        {"joints", red, "--out", (folder / "j.csv").string(), "--frames", "0:9999"},
        {"new", "--out", project, "--take", "a", "absent.bvh"},
        {"new", "--out", project, "--take", "a", red, "--take", "a", blue}};
    for (const auto& words : failing) {
        const Result result = kumite(words);
        EXPECT_EQ(result.code, 1) << words[0] << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1)
            << "one sentence: " << result.err;
    }
}

TEST_F(Cli, InfoAsJson) {
    const auto info = nlohmann::json::parse(kumite({"info", red, "--json"}).out);
    EXPECT_EQ(info["joints"], 20);
    EXPECT_EQ(info["channels"], 63);
    EXPECT_EQ(info["frames"], 361);
    EXPECT_EQ(info["rate"], 60.0);
    EXPECT_EQ(info["metres_per_unit"], 0.01);
    EXPECT_EQ(info["up"], "y");
    EXPECT_NEAR(info["floor"].get<double>(), -0.02, 0.01);
    EXPECT_EQ(info["roles"]["left_knee"], "LeftKnee");
    EXPECT_TRUE(info["findings"].is_array());
    EXPECT_NE(kumite({"info", red}).out.find("361 frames at 60 Hz"), std::string::npos);
}

TEST_F(Cli, JointsSpeaksOfTheUntrimmedFile) {
    const std::string out = (folder / "j.csv").string();
    ASSERT_EQ(kumite({"joints", red, "--out", out, "--frames", "5:7"}).code, 0);
    const std::string csv = test::readText(out);
    EXPECT_EQ(csv.substr(0, 20), "frame,joint,x,y,z\n5,");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 20);
    ASSERT_EQ(kumite({"joints", red, "--out", out, "--frames", ":1", "--end-sites"}).code, 0);
    const std::string all = test::readText(out);
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 1 + 25);
}

TEST_F(Cli, TheWholeJob) {
    makeProject();
    auto before = player(1);
    ASSERT_GE(before["minima"].size(), 6u);
    EXPECT_EQ(before["frames"], 361);
    EXPECT_EQ(before["rate"], 60.0);
    EXPECT_EQ(before["mass_coverage"], 1.0);
    EXPECT_EQ(before["actions"].front()["begin"], 0);
    EXPECT_EQ(before["actions"].back()["end"], 360);
    EXPECT_EQ(before["actions"].size(), before["minima"].size() + 1);
    EXPECT_NEAR(before["actions"][1]["begin_s"].get<double>() * 60,
                before["actions"][1]["begin"].get<double>(), 1e-3);

    const int spurious = before["minima"][2]["frame"];
    const std::string frame = std::to_string(spurious);
    Result result =
        kumite({"correct", project, "--take", "round1", "--player", "1", "--remove", frame});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out.substr(0, 15), "Remove boundary");
    auto after = player(1);
    EXPECT_EQ(after["actions"].size(), before["actions"].size() - 1);
    EXPECT_EQ(after["minima"][2]["kept"], false);
    EXPECT_EQ(player(2)["actions"], segment()["takes"][0]["players"][1]["actions"]);
    EXPECT_EQ(kumite({"correct", project, "--remove", "9999"}).code, 1);

    ASSERT_EQ(kumite({"correct", project, "--restore", frame}).code, 0);
    EXPECT_EQ(player(1)["actions"], before["actions"]);
    const std::string to = std::to_string(spurious + 5);
    ASSERT_EQ(kumite({"correct", project, "--move", frame + ":" + to}).code, 0);
    EXPECT_EQ(player(1)["minima"][2]["moved_to"], spurious + 5);
    const std::string added = std::to_string(spurious + 15);
    ASSERT_EQ(kumite({"correct", project, "--add", added}).code, 0);
    EXPECT_EQ(player(1)["added"], nlohmann::json::array({spurious + 15}));
    EXPECT_EQ(kumite({"correct", project, "--add", added}).out, "Nothing to change.\n");

    // Corrections survive another cutoff, which this run alone uses.
    EXPECT_EQ(player(1, {"--cutoff", "5"})["added"], nlohmann::json::array({spurious + 15}));
    EXPECT_EQ(segment()["cutoff_hz"], 6.0);
    EXPECT_EQ(segment({"--cutoff", "5", "--save"})["cutoff_hz"], 5.0);
    EXPECT_EQ(segment()["cutoff_hz"], 5.0);

    const std::string csv = (folder / "actions.csv").string();
    ASSERT_EQ(kumite({"export", project, "--take", "round1", "--out", csv}).out, csv + "\n");
    EXPECT_NE(test::readText(csv).find("round1,2,0,0,"), std::string::npos);
}

TEST_F(Cli, SegmentListsMinimaBelowTheThresholdOnRequest) {
    makeProject();
    const auto some = player(1, {"--prominence", "0.3"});
    const auto all = player(1, {"--prominence", "0.3", "--all-minima"});
    EXPECT_LT(some["minima"].size(), all["minima"].size());
    for (const auto& minimum : all["minima"]) {
        EXPECT_EQ(minimum["kept"].get<bool>(), minimum["prominence"].get<double>() >= 0.3);
    }
    EXPECT_EQ(some["actions"], all["actions"]);
}

TEST_F(Cli, ForceTable) {
    makeProject();
    const std::string out = (folder / "f.csv").string();
    ASSERT_EQ(kumite({"force", project, "--take", "round1", "--player", "2", "--out", out}).code,
              0);
    const std::string csv = test::readText(out);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "frame,time,com_x,com_y,com_z,fx,fy,fz,norm");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 361);
    EXPECT_NE(csv.find("\n60,1.000000,"), std::string::npos);
}

TEST_F(Cli, NewGroupsOptionsWithWhatStandsBeforeThem) {
    const Result made =
        kumite({"new",        "--out",   project,  //
                "--take",     "one",     red,     "--offset", "0.5",       blue,      "--place",
                "1,-2,90deg", "--units", "inch",  "--rate",   "50",        "--trim",  "10:300",
                "--take",     "two",     blue,    "--role",   "head=Neck", "--floor", "0.1"});
    ASSERT_EQ(made.code, 0) << made.err;
    const auto json = nlohmann::json::parse(test::readText(project));
    const auto& one = json["takes"][0]["fighters"];
    EXPECT_EQ(one[0]["offset_s"], 0.5);
    EXPECT_EQ(one[1]["offset_s"], 0.0);
    EXPECT_EQ(one[1]["placement"]["z_m"], -2.0);
    EXPECT_NEAR(one[1]["placement"]["yaw_rad"].get<double>(), M_PI / 2, 1e-12);
    EXPECT_EQ(one[0]["metres_per_unit"], 0.01);
    EXPECT_EQ(one[1]["metres_per_unit"], 0.0254);
    EXPECT_EQ(one[0]["rate_hz"], 50.0);
    EXPECT_EQ(one[1]["rate_hz"], 50.0);
    EXPECT_EQ(one[0]["frames"], (nlohmann::json{10, 300}));
    const auto& two = json["takes"][1]["fighters"];
    EXPECT_EQ(two.size(), 1u);
    EXPECT_EQ(two[0]["rate_hz"], 60.0);
    EXPECT_EQ(two[0]["roles"]["head"][1], "Neck");
    EXPECT_EQ(two[0]["floor_m"], 0.1);
}

TEST_F(Cli, NewKeepsAProjectThatIsThere) {
    makeProject();
    ASSERT_EQ(kumite({"correct", project, "--add", "200"}).code, 0);
    const std::string old = test::readText(project);
    const Result again = kumite({"new", "--out", project, "--take", "other", red});
    EXPECT_EQ(again.code, 0);
    EXPECT_NE(again.err.find("kept as"), std::string::npos);
    const auto kept = keptVersions(project);
    ASSERT_FALSE(kept.empty());
    EXPECT_EQ(test::readText(kept.front().file), old);
}

TEST_F(Cli, VersionsAreListedAndRestored) {
    makeProject();
    const std::string first = test::readText(project);
    EXPECT_NE(kumite({"versions", project}).out.find("No earlier version"), std::string::npos);
    ASSERT_EQ(kumite({"correct", project, "--add", "200"}).code, 0);
    ASSERT_EQ(kumite({"correct", project, "--add", "100"}).code, 0);
    const std::string last = test::readText(project);
    const auto list = nlohmann::json::parse(kumite({"versions", project, "--json"}).out);
    ASSERT_EQ(list["versions"].size(), 2u);
    EXPECT_EQ(list["versions"][0]["corrections"], 1);
    EXPECT_EQ(list["versions"][1]["corrections"], 0);
    EXPECT_EQ(kumite({"versions", project, "--restore", "3"}).code, 1);
    ASSERT_EQ(kumite({"versions", project, "--restore", "2"}).code, 0);
    EXPECT_EQ(test::readText(project), first);
    EXPECT_EQ(test::readText(keptVersions(project).front().file), last) << "nothing is lost";
}

TEST_F(Cli, AnEmptyJointTakesARoleAway) {
    ASSERT_EQ(kumite({"new", "--out", project, "--take", "a", red, "--role", "left_toe="}).code, 0);
    const auto json = nlohmann::json::parse(test::readText(project));
    EXPECT_FALSE(json["takes"][0]["fighters"][0]["roles"].contains("left_toe"));
    EXPECT_TRUE(json["takes"][0]["fighters"][0]["roles"].contains("right_toe"));
}

TEST_F(Cli, NoOutputReplacesWhatIsRead) {
    makeProject();
    const std::string recording = test::readText(red);
    const std::string saved = test::readText(project);
    const std::vector<std::vector<std::string>> attempts = {
        {"joints", red, "--out", red},
        {"force", project, "--out", project},
        {"force", project, "--out", red},
        {"export", project, "--out", (folder / "bout.kumite").string()},
        {"new", "--out", red, "--take", "a", red}};
    for (const auto& words : attempts)
        EXPECT_EQ(kumite(words).code, 1) << words[0];
    EXPECT_EQ(test::readText(red), recording);
    EXPECT_EQ(test::readText(project), saved);
}

TEST_F(Cli, RelinkAcceptsAMovedOrChangedRecording) {
    makeProject();
    const std::string moved = (folder / "elsewhere.bvh").string();
    test::writeText(moved, test::readText(red) + "\n");
    std::filesystem::remove(red);
    EXPECT_NE(kumite({"segment", project}).err.find("missing"), std::string::npos);
    ASSERT_EQ(kumite({"relink", project, "--player", "1", "--file", moved}).code, 0);
    EXPECT_EQ(kumite({"segment", project}).err, "");
    EXPECT_EQ(kumite({"relink", project, "--file", moved}).out, "Nothing to change.\n");
    test::writeText(moved,
                    "HIERARCHY\nROOT tail\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}\n"
                    "MOTION\nFrames: 1\nFrame Time: 0.1\n0\n");
    EXPECT_EQ(kumite({"relink", project, "--file", moved}).code, 1) << "another skeleton";
}

TEST_F(Cli, SaysThatACutoffAboveHalfTheRateSmoothsNothing) {
    makeProject();
    EXPECT_NE(kumite({"segment", project, "--cutoff", "30"}).err.find("smooths nothing"),
              std::string::npos);
    EXPECT_EQ(kumite({"segment", project, "--cutoff", "29"}).err, "");
}

TEST_F(Cli, AFullDiskIsAFailure) {
    std::ostringstream err;
    std::ofstream full("/dev/full");
    if (!full) GTEST_SKIP() << "this system has no /dev/full";
    EXPECT_EQ(cli::run({"info", red}, full, err), 1);
    EXPECT_NE(err.str().find("standard output"), std::string::npos);
}

TEST_F(Cli, ABrokenRecordingIsNamedWithItsPlace) {
    test::writeText(red, "HIERARCHY\nROOT a\n{\n  OFFSET 0 0 zero\n");
    const Result result = kumite({"info", red});
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err.substr(0, 8 + red.size() + 6), "kumite: " + red + ":4:14:");
}

TEST_F(Cli, EveryFileOfTheRecordingsOpens) {
    KUMITE_NEEDS_DATA();
    int opened = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*test::dataFolder())) {
        const std::string suffix = entry.path().extension().string();
        if (suffix != ".bvh" && suffix != ".amc") continue;
        const Result info = kumite({"info", entry.path().string(), "--json"});
        ASSERT_EQ(info.code, 0) << info.err;
        const bool human = entry.path().filename() != "sinusoidal_noEndSite.bvh";
        const auto json = nlohmann::json::parse(info.out);
        EXPECT_EQ(json["roles"].contains("left_knee"), human) << entry.path();
        ASSERT_EQ(kumite({"new", "--out", project, "--take", "t", entry.path().string()}).code, 0);
        const auto values = player(1);
        EXPECT_EQ(values["actions"].back()["end"], values["frames"].get<int>() - 1);
        EXPECT_EQ(values["mass_coverage"].get<double>(), human ? 1.0 : 0.0) << entry.path();
        ++opened;
    }
    EXPECT_GE(opened, 20);
}

TEST_F(Cli, DemoMakesABoutThatTheOtherCommandsTake) {
    const std::string out = (folder / "demo").string();
    const Result made =
        kumite({"demo", "--out", out, "--seconds", "5", "--fps", "50", "--seed", "7"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.out, out + "/demo.kumite\n");
    const auto truth = nlohmann::json::parse(test::readText(out + "/truth.json"));
    EXPECT_EQ(truth["rate"], 50);
    ASSERT_EQ(truth["players"].size(), 2u);
    for (const char* key : {"boundaries", "spurious", "actions"}) {
        EXPECT_TRUE(truth["players"][0].contains(key)) << key;
    }
    const auto& label = truth["players"][1]["actions"][0]["label"];
    for (const char* aspect :
         {"left_punch", "right_punch", "left_kick", "right_kick", "jump", "react", "move"}) {
        EXPECT_TRUE(label.contains(aspect)) << aspect;
    }
    const Result cut = kumite({"segment", out + "/demo.kumite", "--json"});
    ASSERT_EQ(cut.code, 0) << cut.err;
    const auto players = nlohmann::json::parse(cut.out)["takes"][0]["players"];
    ASSERT_EQ(players.size(), 2u);
    EXPECT_EQ(players[0]["frames"], 250);
    // The same seed, the same bytes.
    const std::string again = (folder / "again").string();
    ASSERT_EQ(kumite({"demo", "--out", again, "--seconds", "5", "--fps", "50", "--seed", "7"}).code,
              0);
    for (const char* name : {"/player1.bvh", "/player2.bvh", "/truth.json"}) {
        EXPECT_EQ(test::readText(out + name), test::readText(again + name)) << name;
    }
}

TEST_F(Cli, DemoSaysWhatItCannotMake) {
    const Result tooShort = kumite({"demo", "--out", (folder / "x").string(), "--seconds", "0.2"});
    EXPECT_EQ(tooShort.code, 1);
    EXPECT_NE(tooShort.err.find("from 1 second"), std::string::npos) << tooShort.err;
    const Result tooFast = kumite({"demo", "--out", (folder / "x").string(), "--fps", "500"});
    EXPECT_EQ(tooFast.code, 1);
    EXPECT_EQ(kumite({"demo"}).code, 2);
    test::writeText(folder / "file", "");
    const Result noFolder = kumite({"demo", "--out", (folder / "file" / "x").string()});
    EXPECT_EQ(noFolder.code, 1);
    EXPECT_NE(noFolder.err.find("cannot be made"), std::string::npos) << noFolder.err;
}

TEST_F(Cli, WithoutAProjectACommandTakesTheDemoBout) {
    setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
    const Result cut = kumite({"segment", "--json"});
    EXPECT_EQ(cut.code, 0) << cut.err;
    EXPECT_NE(cut.err.find("demo bout"), std::string::npos) << cut.err;
    EXPECT_EQ(nlohmann::json::parse(cut.out)["takes"][0]["name"], "demo");
    const Result force = kumite({"force", "--player", "2", "--out", (folder / "f.csv").string()});
    EXPECT_EQ(force.code, 0) << force.err;
    EXPECT_EQ(kumite({"segment", "--cutoff", "7", "--save"}).code, 2);
    unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace kumite
