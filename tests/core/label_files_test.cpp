#include "core/project/label_files.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/eaf.h"
#include "core/formats/tables.h"
#include "core/project/simulation.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

constexpr FighterAddress kRed{0, 0};
constexpr FighterAddress kBlue{0, 1};

struct Labelled {
    Project project = test::makeBout();
    Analysis analysis = analyse(project);

    Labelled() {
        project.takes[0].name = "round, \"one\"";
        hand(kRed, {1, 2}, "left_punch:fwd+move:L-R");
        hand(kRed, {4}, "jump:up+react:?");
        hand(kBlue, {0}, "move:F-F");
        FighterLabels machine{kBlue,
                              actionLabels(project.takes[0].fighters[1], analysis.at(kBlue), 7)};
        machine.labels[3].aspects = std::vector<AspectValue>(7, {0, LabelSource::Machine, 0.75f});
        machine.labels[3].aspects[5] = {1, LabelSource::Rule, 0.75f};
        machine.labels[3].aspects[6] = {5, LabelSource::Rule, 0.75f};
        apply(acceptLabels(project, analysis, {{machine}}));
    }
    void apply(const MaybeEdit& edit) {
        ASSERT_TRUE(edit);
        project = edit->project;
        analysis = analyse(project, analysis);
    }
    void hand(FighterAddress fighter, std::vector<int> actions, const std::string& label) {
        apply(setWholeLabel(project, analysis, fighter, actions, parseLabel(kickboxing(), label)));
    }
    Project bare() const {
        Project bare = project;
        for (Fighter& fighter : bare.takes[0].fighters)
            fighter.labels = LabelTrack();
        return bare;
    }
};

TEST(LabelTables, CsvAndJsonGoOutAndComeBack) {
    const Labelled made;
    const auto csv =
        parseLabelsCsv(labelsCsv(made.project, made.analysis), "labels.csv", kickboxing());
    const auto json =
        parseLabelsJson(labelsJson(made.project, made.analysis), "labels.json", kickboxing());
    for (const auto& labels : {csv, json}) {
        EXPECT_EQ(labels.size(), 5u);
        const Project bare = made.bare();
        const MatchedLabels matched = matchLabels(bare, made.analysis, labels);
        EXPECT_EQ(matched.matched, 5);
        EXPECT_TRUE(matched.unmatched.empty());
        const auto edit = importLabels(bare, made.analysis, matched.fighters);
        ASSERT_TRUE(edit);
        EXPECT_EQ(edit->project, made.project);
    }
}

TEST(LabelTables, FindTheirActionsAgainAfterAnotherSegmentation) {
    Labelled made;
    const std::string text = labelsCsv(made.project, made.analysis);
    const auto wanted = made.analysis.at(kRed).segmentation->actions;
    Project other = made.bare();
    other.segmentation.cutoff = 5.5;
    const Analysis analysis = analyse(other);
    const auto matched =
        matchLabels(other, analysis, parseLabelsCsv(text, "labels.csv", kickboxing()));
    EXPECT_EQ(matched.matched, 5);
    const auto edit = importLabels(other, analysis, matched.fighters);
    const auto& track = *edit->project.takes[0].fighters[0].labels;
    ASSERT_EQ(track.size(), 3u);
    EXPECT_NEAR(track[0].peak, wanted[1].peak, 3);
    EXPECT_NEAR(track[2].peak, wanted[4].peak, 3);
}

TEST(LabelTables, ReportWhatFindsNoAction) {
    const Labelled made;
    const char* text =
        "label,begin_s,end_s,player\r\n"
        "left_kick:up,0.0,5.9,1\r\n"
        "left_kick:up,100,101,1\r\n"
        "\r\n"
        "left_kick:up,0.1,0.4,2\r\n"
        "jump:up,0.11,0.39,2\r\n";
    const Project bare = made.bare();
    const auto matched =
        matchLabels(bare, made.analysis, parseLabelsCsv(text, "l.csv", kickboxing()));
    EXPECT_EQ(matched.matched, 2);
    ASSERT_EQ(matched.unmatched.size(), 2u);
    EXPECT_EQ(matched.unmatched[0].text, "line 3 (100.00–101.00 s, fighter 1): no action there.");
    EXPECT_EQ(matched.unmatched[1].text,
              "line 6 (0.11–0.39 s, fighter 2): its action takes the label of line 5.");
}

TEST(LabelTables, AnImportedMachineLabelNeverReplacesAHand) {
    const Labelled made;
    const auto& action = made.analysis.at(kRed).segmentation->actions[1];
    const std::string text = "begin_s,end_s,label,source\n" + std::to_string(action.begin / 60.0) +
                             "," + std::to_string(action.end / 60.0) + ",right_kick:up,machine\n";
    const auto matched =
        matchLabels(made.project, made.analysis, parseLabelsCsv(text, "l.csv", kickboxing()));
    EXPECT_EQ(matched.matched, 1);
    const auto edit = importLabels(made.project, made.analysis, matched.fighters);
    EXPECT_FALSE(edit) << "every aspect of that action was set by hand";
}

TEST(LabelTables, SayWhatIsWrongAndWhere) {
    const auto messageFor = [](const std::string& text) -> std::string {
        try {
            parseLabelsCsv(text, "l.csv", kickboxing());
        } catch (const InputError& error) {
            return error.what();
        }
        return "read";
    };
    EXPECT_EQ(messageFor(""), "l.csv: is empty.");
    EXPECT_EQ(messageFor("begin_s,end_s\n"),
              "l.csv:1: has no column label; a label table needs begin_s, end_s and label.");
    const std::string header = "begin_s,end_s,label,player,source,confidence\n";
    EXPECT_EQ(messageFor(header + "1,2,left_kick:up,3,,\n"), "l.csv:2: player is 1 or 2.");
    EXPECT_EQ(messageFor(header + "1,x,left_kick:up,1,,\n"), "l.csv:2: end_s is not a number.");
    EXPECT_EQ(messageFor(header + "2,1,left_kick:up,1,,\n"), "l.csv:2: end_s lies before begin_s.");
    EXPECT_EQ(messageFor(header + "1,2,left_kick:out,1,,\n"),
              "l.csv:2: \"left_kick:out\" names no qualifier of left_kick.");
    EXPECT_EQ(messageFor(header + "1,2,others,1,oracle,\n"),
              "l.csv:2: source is hand, rule, machine or hand+rule.");
    EXPECT_EQ(messageFor(header + "1,2,others,1,machine,7\n"),
              "l.csv:2: confidence is a number from 0 to 1.");
    EXPECT_EQ(messageFor(header + "1,2,\"others,1,,\n"),
              "l.csv:2: has a quote that is not closed.");
    EXPECT_THROW(parseLabelsJson("{}", "l.json", kickboxing()), InputError);
    // A third fighter; ends before beginnings; times that no double holds.
    EXPECT_THROW(parseLabelsJson(R"({"rate": 60, "players": [{"actions": []}, {"actions": []},
                                     {"actions": []}]})",
                                 "l.json", kickboxing()),
                 InputError);
    EXPECT_THROW(parseLabelsJson(R"({"kumite_labels": 1, "takes": [{"name": "a", "players":
                                     [{"labels": []}, {"labels": []}, {"labels": []}]}]})",
                                 "l.json", kickboxing()),
                 InputError);
    for (const char* action : {R"("begin": 9, "end": 3)", R"("begin": 0, "end": 2000000000)"}) {
        EXPECT_THROW(parseLabelsJson(std::string(R"({"rate": 1e-305, "players": [{"actions": [{)") +
                                         action + R"(, "label": {}}]}]})",
                                     "l.json", kickboxing()),
                     InputError);
    }
    EXPECT_THROW(readLabels("labels.txt", kickboxing()), Error);
}

TEST(Csv, QuotesLinesAndByteOrderMarks) {
    const auto lines = parseCsv(
        "\xEF\xBB\xBF"
        "a,\"b, \"\"c\"\"\"\r\n\n\"two\nlines\",d",
        "x");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].fields, (std::vector<std::string>{"a", "b, \"c\""}));
    EXPECT_EQ(lines[1].fields, (std::vector<std::string>{"two\nlines", "d"}));
    EXPECT_EQ(lines[1].number, 3);
}

TEST(LabelTables, ElanDocumentsGoOutAndComeBack) {
    Labelled made;
    made.project.takes[0].fighters[1].offset = -0.5;
    const std::string text = labelsEaf(made.project, made.analysis, 0);
    const EafDocument eaf = parseEaf(text, "l.eaf");
    ASSERT_EQ(eaf.tiers.size(), 2u * 8);
    EXPECT_EQ(eaf.tiers[1].id, "fighter 1 left_punch");
    EXPECT_EQ(eaf.tiers[1].parent, "fighter 1");
    // Fighter 1's frame 0 stands 0.5 s after the document's begin.
    const auto& action = made.analysis.at(kRed).segmentation->actions[1];
    ASSERT_EQ(eaf.tiers[1].annotations.size(), 2u) << "what is others has no annotation";
    EXPECT_NEAR(eaf.tiers[1].annotations[0].begin, 0.5 + action.begin / 60.0, 0.0006);
    EXPECT_EQ(eaf.tiers[1].annotations[0].value, "fwd");
    EXPECT_EQ(eaf.tiers[0].annotations.size(), made.analysis.at(kRed).segmentation->actions.size());

    const auto labels = parseLabelsEaf(text, "l.eaf", kickboxing());
    Project bare = made.bare();
    const MatchedLabels matched = matchLabels(bare, made.analysis, labels);
    EXPECT_EQ(matched.matched, 5);
    EXPECT_TRUE(matched.unmatched.empty());
    const auto edit = importLabels(bare, made.analysis, matched.fighters);
    ASSERT_TRUE(edit);
    EXPECT_EQ(edit->project, made.project);
}

TEST(LabelTables, AnActionTakesEachAspectFromTheLabelThatOverlapsItLongest) {
    const Labelled made;
    const Action& action = made.analysis.at(kRed).segmentation->actions[1];
    const auto label = [&](double begin, double end, const char* text, const char* place) {
        TimedLabel each;
        each.begin = (action.begin + begin * (action.end - action.begin)) / 60.0;
        each.end = (action.begin + end * (action.end - action.begin)) / 60.0;
        each.place = place;
        for (const int q : parseLabel(kickboxing(), text))
            each.aspects.push_back({static_cast<std::int8_t>(q), LabelSource::Hand, 1.0f});
        return each;
    };
    const auto matched = matchLabels(made.bare(), made.analysis,
                                     {label(0.0, 0.7, "left_punch:fwd+jump:?", "one"),
                                      label(0.0, 0.8, "left_punch:?+jump:up", "two"),
                                      label(0.0, 0.6, "left_punch:bwd+jump:?", "three")});
    EXPECT_EQ(labelText(kickboxing(), matched.fighters[0].labels[1].label()),
              "left_punch:fwd+jump:up");
    EXPECT_EQ(matched.matched, 2);
}

TEST(LabelTables, KnowWhatAHandSaidBesideTheRules) {
    Labelled made;
    FighterLabels rules{kRed,
                        actionLabels(made.project.takes[0].fighters[0], made.analysis.at(kRed), 7)};
    rules.labels[1].aspects[5] = {1, LabelSource::Rule, 0.5f};
    Project mixed = made.bare();
    EXPECT_EQ(
        spokenLabel(kickboxing(), parseLabel(kickboxing(), "left_punch:fwdbwd+right_kick:up")),
        "left punch forward and back, right kick up");
    EXPECT_EQ(spokenLabel(kickboxing(), othersLabel(kickboxing())), "nothing");
    const Label punch = parseLabel(kickboxing(), "left_punch:fwd+react:?");
    mixed = setWholeLabel(mixed, made.analysis, kRed, {{1}}, punch)->project;
    mixed = acceptLabels(mixed, made.analysis, {{rules}})->project;
    const std::string csv = labelsCsv(mixed, made.analysis);
    EXPECT_NE(csv.find(",hand+rule,0.500"), std::string::npos);
    for (const auto& labels :
         {parseLabelsCsv(csv, "l.csv", kickboxing()),
          parseLabelsEaf(labelsEaf(mixed, made.analysis, 0), "l.eaf", kickboxing())}) {
        ASSERT_EQ(labels.size(), 1u);
        EXPECT_TRUE(labels[0].aspects[0].byHand());
        EXPECT_EQ(labels[0].aspects[5], (AspectValue{1, LabelSource::Rule, 0.5f}));
    }
}

TEST(Simulation, TheUserCorrectsTheCutThenAnswers) {
    // Truth: the first fighter's cut without its third boundary, with one more in its last action.
    Labelled made;
    const Project bare = made.bare();
    Truth truth;
    for (const int player : {0, 1}) {
        std::vector<int> cuts;
        for (const Boundary& boundary : made.analysis.at({0, player}).segmentation->boundaries)
            cuts.push_back(boundary.frame);
        if (player == 0) {
            cuts.erase(cuts.begin() + 3);
            const Action last = made.analysis.at(kRed).segmentation->actions.back();
            cuts.insert(cuts.end() - 1, (last.begin + last.end) / 2);
        }
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            TimedLabel label;
            label.player = player + 1;
            label.begin = cuts[i] / 60.0;
            label.end = cuts[i + 1] / 60.0;
            for (const int qualifier : parseLabel(kickboxing(), "move:L-L"))
                label.aspects.push_back(
                    {static_cast<std::int8_t>(qualifier), LabelSource::Hand, 1.0f});
            truth.labels.push_back(label);
        }
    }
    const CorrectedProject corrected = correctFromTruth(bare, 0, truth);
    EXPECT_EQ(corrected.removed, 1);
    EXPECT_EQ(corrected.added, 1);
    EXPECT_EQ(corrected.analysis.at(kRed).segmentation->actions.size(),
              made.analysis.at(kRed).segmentation->actions.size());
    for (const bool active : {true, false}) {
        SimulationSettings settings;
        settings.active = active;
        settings.budget = 0.5;
        const Simulation result = simulateSession(bare, 0, truth, settings);
        EXPECT_EQ(result.labelled, std::lround(0.5 * result.actions));
        EXPECT_EQ(result.scores.actions, result.actions - result.labelled);
        EXPECT_EQ(result.scores.labelAccuracy, 1.0) << "all others, standing on both feet";
        EXPECT_EQ(result.scores.baselineAccuracy, 1.0);
        EXPECT_EQ(result.curve.back().labelled, result.labelled);
        const Simulation again = simulateSession(bare, 0, truth, settings);
        EXPECT_EQ(again.model, result.model);
    }
}

}  // namespace
}  // namespace kumite
