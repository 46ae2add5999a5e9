#include "core/project/label_judgement.h"

#include <gtest/gtest.h>

#include "core/project/label_search.h"
#include "core/project/vocabulary_change.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

struct Bout {
    Project project = test::makeBout();
    Analysis analysis = analyse(project);

    void hand(FighterAddress fighter, std::vector<int> actions, const std::string& label) {
        project =
            setWholeLabel(project, analysis, fighter, actions, parseLabel(kickboxing(), label))
                ->project;
    }
    Proposals proposals() const {
        const ActionTable table = actionTable(project, analysis);
        const TrainingSet set(kickboxing(), table.features, handExamples(project, analysis, table),
                              project.labelling.learning);
        return propose(project, analysis, table,
                       set.predict(defaultParameters(kickboxing()), true));
    }
    std::vector<FoundAction> find(const std::string& typed, const Proposals& beside = {}) const {
        return findActions(project, analysis, parseLabelFilter(filterWords(project), typed),
                           beside.fighters);
    }
};

TEST(LabelSearch, FindsHandLabelsAndProposalsApart) {
    Bout bout;
    const std::size_t all = bout.find("").size();
    ASSERT_GT(all, 10u);
    EXPECT_EQ(bout.find("unlabelled").size(), all);
    bout.hand({0, 0}, {2, 4}, "left_kick:up");
    bout.hand({0, 1}, {3}, "jump:up");
    const auto kicks = bout.find("kick");
    ASSERT_EQ(kicks.size(), 2u);
    EXPECT_EQ(kicks[1].action, 4);
    EXPECT_EQ(kicks[1].label(), parseLabel(kickboxing(), "left_kick:up"));
    const Action& action = bout.analysis.at({0, 0}).segmentation->actions[4];
    EXPECT_DOUBLE_EQ(kicks[1].begin, action.begin / 60.0);
    EXPECT_EQ(bout.find("player 2, labelled").size(), 1u);
    EXPECT_TRUE(bout.find("machine").empty()) << "nothing was proposed yet";
    const Proposals proposals = bout.proposals();
    EXPECT_EQ(bout.find("left kick, by hand", proposals).size(), 2u);
    EXPECT_EQ(bout.find("unlabelled", proposals).size(), all - 3)
        << "proposals do not stand in the project";
    EXPECT_EQ(bout.find("jump or jump none, machine", proposals).size(), all - 3);
    // Proposals of another segmentation are not used.
    Proposals stale = proposals;
    for (FighterLabels& fighter : stale.fighters)
        fighter.labels.pop_back();
    EXPECT_TRUE(bout.find("machine", stale).empty());
}

TEST(HandJudgement, HoldsRulesAndMachinesAgainstHands) {
    Bout bout;
    const auto actions = bout.analysis.at({0, 0}).segmentation->actions.size();
    for (int i = 0; i < static_cast<int>(actions); ++i)
        bout.hand({0, 0}, {i}, i % 2 == 0 ? "left_kick:up+move:F-F" : "move:F-F");
    const Proposals proposals = bout.proposals();
    const ActionTable table = actionTable(bout.project, bout.analysis);
    const HandJudgement judged = judgeHandLabels(bout.project, bout.analysis, table,
                                                 defaultParameters(kickboxing()), proposals);
    ASSERT_EQ(judged.actions.size(), actions);
    const int move = *kickboxing().find("move");
    const auto& reasons = proposals.reasons.front();
    int same = 0;
    for (const JudgedAction& each : judged.actions) {
        EXPECT_EQ(each.fighter, (FighterAddress{0, 0}));
        const std::string symbol = reasons[static_cast<std::size_t>(each.action)].move.symbol();
        EXPECT_EQ(each.answer[static_cast<std::size_t>(move)], kickboxing()[move].find(symbol))
            << "what the rule says, not what the hand said";
        EXPECT_NE(each.answer[2], kUnknown);
        same += each.answer[2] == each.hand[2];
    }
    EXPECT_DOUBLE_EQ(judged.scores.aspects[2].accuracy, same / static_cast<double>(actions));
    std::size_t inCells = 0;
    const int qualifiers = static_cast<int>(kickboxing()[2].qualifiers.size());
    for (int hand = 0; hand < qualifiers; ++hand) {
        for (int answer = -1; answer < qualifiers; ++answer) {
            const auto cell = judged.cell(2, hand, answer);
            inCells += cell.size();
            const auto column = static_cast<std::size_t>(answer < 0 ? qualifiers : answer);
            EXPECT_EQ(static_cast<int>(cell.size()),
                      judged.scores.aspects[2].confusion[static_cast<std::size_t>(hand)][column]);
        }
    }
    EXPECT_EQ(inCells, actions);
}

TEST(VocabularyChange, TellsWhatWouldBeLost) {
    Bout bout;
    bout.hand({0, 0}, {2, 4}, "left_kick:up");
    bout.hand({0, 1}, {3}, "jump:up");
    EXPECT_TRUE(lostBy(bout.project, kickboxing()).empty());
    Vocabulary other = kickboxing();
    other.aspects.erase(other.aspects.begin() + 4);  // jump
    other.aspects[2].qualifiers[0].id = "rising";    // left kick up
    const auto losses = lostBy(bout.project, other);
    ASSERT_EQ(losses.size(), 2u);
    EXPECT_EQ(losses[0], (VocabularyLoss{"Left kick", "up", 2, 0}));
    EXPECT_EQ(losses[1], (VocabularyLoss{"Jump", "", 3, 0})) << "what is none counts as well";
    EXPECT_EQ(lossText(losses[0]), "Left kick up: 2 labels by hand");
    // It is what setVocabulary really drops.
    int before = 0, after = 0;
    const auto known = [](const Project& project) {
        int count = 0;
        for (const Fighter& fighter : project.takes[0].fighters) {
            for (const ActionLabel& label : *fighter.labels) {
                for (const AspectValue& value : label.aspects)
                    count += value.known();
            }
        }
        return count;
    };
    before = known(bout.project);
    after = known(setVocabulary(bout.project, other)->project);
    EXPECT_EQ(before - after, 5);
}

TEST(RuleChanges, CountActionsThatGetAnotherQualifier) {
    Bout bout;
    const Proposals before = bout.proposals();
    for (const RuleChange& change : ruleChanges(kickboxing(), before, before)) {
        EXPECT_EQ(change.changed, 0);
        EXPECT_EQ(change.actions, static_cast<int>(bout.find("").size()));
    }
    Proposals after = before;
    const auto move = static_cast<std::size_t>(*kickboxing().find("move"));
    AspectValue& value = after.fighters[0].labels[1].aspects[move];
    value.qualifier = static_cast<std::int8_t>((value.qualifier + 1) % 9);
    const auto changes = ruleChanges(kickboxing(), before, after);
    ASSERT_EQ(changes.size(), 2u) << "react and move";
    EXPECT_EQ(changes[0].changed, 0);
    EXPECT_EQ(changes[1].changed, 1);
}

}  // namespace
}  // namespace kumite
