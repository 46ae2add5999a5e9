#include "core/project/labels.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/labelling.h"
#include "core/project/project_file.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

constexpr FighterAddress kRed{0, 0};
constexpr FighterAddress kBlue{0, 1};

/// A bout under edit: project and analysis go together.
struct Bout {
    Project project = test::makeBout();
    Analysis analysis = analyse(project);

    bool apply(const MaybeEdit& edit) {
        if (!edit) return false;
        project = edit->project;
        analysis = analyse(project, analysis);
        return true;
    }
    const std::vector<Action>& actions(FighterAddress fighter = kRed) const {
        return analysis.at(fighter).segmentation->actions;
    }
    std::string label(int action, FighterAddress fighter = kRed) const {
        const auto labels = actionLabels(fighterAt(project, fighter), analysis.at(fighter), 7);
        return labelText(kickboxing(), labels[static_cast<std::size_t>(action)].label(), true);
    }
    bool hand(std::vector<int> actions, const std::string& label, FighterAddress fighter = kRed) {
        return apply(
            setWholeLabel(project, analysis, fighter, actions, parseLabel(kickboxing(), label)));
    }
};

const char* kOpen = "left_punch:?+right_punch:?+left_kick:?+right_kick:?+jump:?+react:?";

TEST(ActionLabels, AreOpenAtFirst) {
    const Bout bout;
    EXPECT_EQ(bout.label(0), kOpen);
}

TEST(SetLabel, OfOneAspectAndOfSeveralActions) {
    Bout bout;
    EXPECT_TRUE(bout.apply(setLabel(bout.project, bout.analysis, kRed, {{1, 3}}, 4, 0)));
    for (const int action : {1, 3}) {
        EXPECT_EQ(bout.label(action),
                  "left_punch:?+right_punch:?+left_kick:?+right_kick:?+jump:up+react:?");
    }
    EXPECT_EQ(bout.label(2), kOpen);
    EXPECT_FALSE(bout.apply(setLabel(bout.project, bout.analysis, kRed, {{1, 3}}, 4, 0)))
        << "nothing changed";
    EXPECT_TRUE(bout.apply(clearLabel(bout.project, bout.analysis, kRed, {{1}}, 4)));
    EXPECT_EQ(bout.label(1), kOpen);
    EXPECT_TRUE(bout.apply(clearLabel(bout.project, bout.analysis, kRed, {{3}})));
    EXPECT_TRUE(bout.project.takes[0].fighters[0].labels->empty());
    EXPECT_THROW(setLabel(bout.project, bout.analysis, kRed, {{999}}, 4, 0), Error);
    EXPECT_THROW(setLabel(bout.project, bout.analysis, kRed, {{0}}, 7, 0), Error);
    EXPECT_THROW(setLabel(bout.project, bout.analysis, kRed, {{0}}, 4, 3), Error);
}

TEST(SetLabels, OfBothFightersAreOneStep) {
    Bout bout;
    const auto answer = [](FighterAddress fighter, int action, const char* label) {
        return ActionAnswer{fighter, action, parseLabel(kickboxing(), label)};
    };
    const std::vector<ActionAnswer> answers = {answer(kRed, 1, "jump:up"),
                                               answer(kBlue, 2, "left_kick:up")};
    const MaybeEdit edit = setLabels(bout.project, bout.analysis, answers);
    ASSERT_TRUE(edit);
    EXPECT_EQ(edit->name, "Label 2 actions");
    bout.apply(edit);
    EXPECT_EQ(bout.label(1), "jump:up");
    EXPECT_EQ(bout.label(2, kBlue), "left_kick:up");
    EXPECT_EQ(bout.label(0), kOpen);
    EXPECT_FALSE(setLabels(bout.project, bout.analysis, answers)) << "nothing changed";
    EXPECT_FALSE(setLabels(bout.project, bout.analysis, {}));
}

TEST(Labels, StayWithThePeakWhenBoundariesMove) {
    Bout bout;
    for (int i = 0; i < 5; ++i)
        bout.hand({i}, i % 2 == 0 ? "left_punch:fwd" : "right_kick:up");
    const Action first = bout.actions()[1];
    // Moved a little: the same labels.
    ASSERT_TRUE(
        bout.apply(moveBoundary(bout.project, bout.analysis, kRed, first.end, first.end - 2)));
    EXPECT_EQ(bout.label(1), "right_kick:up");
    EXPECT_EQ(bout.label(2), "left_punch:fwd");
    // Split beside the peak: the half with the peak keeps the label.
    const int peak = bout.actions()[2].peak;
    ASSERT_TRUE(bout.apply(addBoundary(bout.project, bout.analysis, kRed, peak - 3)));
    EXPECT_EQ(bout.label(2), kOpen);
    EXPECT_EQ(bout.label(3), "left_punch:fwd");
}

TEST(Labels, OfAMergedActionAreThoseOfTheHigherPeakAndComeBack) {
    Bout bout;
    bout.hand({1}, "left_punch:fwd");
    bout.hand({2}, "right_kick:up");
    const auto& curve = bout.analysis.at(kRed).force->force.curve;
    const auto force = [&](int action) {
        return curve[static_cast<std::size_t>(
            bout.actions()[static_cast<std::size_t>(action)].peak)];
    };
    const std::string higher = force(1) >= force(2) ? "left_punch:fwd" : "right_kick:up";
    const int between = bout.actions()[1].end;
    const Project before = bout.project;
    ASSERT_TRUE(bout.apply(removeBoundary(bout.project, bout.analysis, kRed, between)));
    EXPECT_EQ(bout.label(1), higher);
    ASSERT_TRUE(bout.apply(restoreBoundary(bout.project, bout.analysis, kRed, between)));
    EXPECT_EQ(bout.label(1), "left_punch:fwd");
    EXPECT_EQ(bout.label(2), "right_kick:up");
    EXPECT_EQ(bout.project, before);
    // Cleared while merged: nothing hidden comes to light afterwards.
    bout.apply(removeBoundary(bout.project, bout.analysis, kRed, between));
    bout.apply(clearLabel(bout.project, bout.analysis, kRed, {{1}}));
    EXPECT_EQ(bout.label(1), kOpen);
    bout.apply(restoreBoundary(bout.project, bout.analysis, kRed, between));
    EXPECT_EQ(bout.label(1), kOpen);
    EXPECT_EQ(bout.label(2), kOpen);
}

TEST(Labels, SurviveAnotherCutoff) {
    Bout bout;
    for (int i = 0; i < static_cast<int>(bout.actions().size()); ++i)
        bout.hand({i}, i % 2 == 0 ? "left_punch:fwd" : "right_kick:up");
    const auto count = bout.actions().size();
    ASSERT_TRUE(bout.apply(setSegmentation(bout.project, {5.7, 0.05, ForceCurve::Norm})));
    ASSERT_EQ(bout.actions().size(), count);
    for (int i = 0; i < static_cast<int>(count); ++i)
        EXPECT_EQ(bout.label(i), i % 2 == 0 ? "left_punch:fwd" : "right_kick:up") << i;
}

TEST(AcceptLabels, NeverTouchesWhatAHandSet) {
    Bout bout;
    bout.hand({2}, "left_punch:fwd+jump:?");
    FighterLabels proposal{
        kRed, actionLabels(bout.project.takes[0].fighters[0], bout.analysis.at(kRed), 7)};
    for (ActionLabel& label : proposal.labels) {
        for (AspectValue& value : label.aspects)
            value = {1, LabelSource::Machine, 0.8f};
    }
    proposal.labels[4].aspects[0].confidence = 0.4f;
    ASSERT_TRUE(bout.apply(acceptLabels(bout.project, bout.analysis, {{proposal}}, 0.5)));
    const auto labels = actionLabels(bout.project.takes[0].fighters[0], bout.analysis.at(kRed), 7);
    EXPECT_EQ(labels[2].aspects[0], (AspectValue{0, LabelSource::Hand, 1.0f}));
    EXPECT_EQ(labels[2].aspects[4], (AspectValue{1, LabelSource::Machine, 0.8f}));
    EXPECT_FALSE(labels[4].aspects[0].known()) << "less sure than asked for";
    EXPECT_EQ(labels[5].aspects[3], (AspectValue{1, LabelSource::Machine, 0.8f}));
    // A hand overrules the machine.
    ASSERT_TRUE(bout.apply(setLabel(bout.project, bout.analysis, kRed, {{5}}, 3, 0)));
    EXPECT_EQ(bout.project.takes[0].fighters[0].labels->size(), bout.actions().size());
}

TEST(LabelsInTheFile, ReadBackTheSameWithSettingsAndVocabulary) {
    Bout bout;
    bout.hand({1, 4}, "left_punch:fwd+move:L-R");
    bout.hand({0}, "jump:?+right_kick:down", kBlue);
    const AutoLabels automatic = labelAutomatically(bout.project, bout.analysis);
    bout.apply(acceptLabels(bout.project, bout.analysis, automatic.proposals.fighters));
    bout.apply(setModel(bout.project, automatic.model));
    RuleSettings rules;
    rules.contacts.height = 0.06;
    rules.closingSpeed = 1.25;
    bout.apply(setRules(bout.project, rules));
    LearningSettings learning;
    learning.limbFirst = true;
    bout.apply(setLearning(bout.project, learning));

    const auto reread = [](const Project& project) {
        const std::string text = projectText(project, "/recordings");
        Project read = parseProject(text, "bout.kumite", "/recordings");
        EXPECT_EQ(projectText(read, "/recordings"), text);
        return read;
    };
    Project read = reread(bout.project);
    EXPECT_EQ(read.takes[0].fighters[0].labels, bout.project.takes[0].fighters[0].labels);
    EXPECT_EQ(read.takes[0].fighters[1].labels, bout.project.takes[0].fighters[1].labels);
    EXPECT_EQ(read.labelling, bout.project.labelling);

    Vocabulary vocabulary = kickboxing();
    vocabulary.name = "Boxing";
    for (const std::size_t punch : {0u, 1u}) {
        auto& qualifiers = vocabulary.aspects[punch].qualifiers;
        std::swap(qualifiers[0], qualifiers[1]);
        std::swap(qualifiers[0].mirror, qualifiers[1].mirror);
    }
    bout.apply(setVocabulary(bout.project, parseVocabulary(vocabularyText(vocabulary), "boxing")));
    EXPECT_EQ(labelText(*bout.project.labelling.vocabulary,
                        (*bout.project.takes[0].fighters[0].labels)[1].label())
                  .substr(0, 14),
              "left_punch:fwd")
        << "by id, not by index";
    read = reread(bout.project);
    EXPECT_EQ(read.labelling, bout.project.labelling);
}

TEST(LabelsInTheFile, AreNotThereWhereNothingIsLabelled) {
    const std::string text = projectText(test::makeBout(), "/recordings");
    EXPECT_EQ(text.find("label"), std::string::npos);
}

TEST(LabelsInTheFile, SayWhatIsWrong) {
    Bout bout;
    bout.hand({1}, "left_punch:fwd");
    const std::string good = projectText(bout.project, "/recordings");
    const auto messageFor = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        const auto at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        text.replace(at, what.size(), instead);
        try {
            parseProject(text, "b", "/recordings");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("read");
    };
    EXPECT_NE(messageFor("\"left_punch\"", "\"left_head\"").find("no aspect of the vocabulary"),
              std::string::npos);
    EXPECT_NE(messageFor("\"fwd\"", "\"sideways\"").find("no qualifier of left_punch"),
              std::string::npos);
    EXPECT_NE(messageFor("\"peak\": ", "\"peak\": -").find("cannot be negative"),
              std::string::npos);
}

TEST(Propose, RulesSpeakWithoutAnyExample) {
    const Bout bout;
    const AutoLabels result = labelAutomatically(bout.project, bout.analysis);
    EXPECT_EQ(result.examples, 0);
    ASSERT_EQ(result.proposals.fighters.size(), 2u);
    for (std::size_t f = 0; f < 2; ++f) {
        for (std::size_t i = 0; i < result.proposals.fighters[f].labels.size(); ++i) {
            const ActionLabel& label = result.proposals.fighters[f].labels[i];
            EXPECT_FALSE(label.aspects[0].known());
            EXPECT_EQ(label.aspects[6].qualifier, 0) << "bobbing on both feet: L-L";
            EXPECT_EQ(label.aspects[6].source, LabelSource::Rule);
            EXPECT_FALSE(result.proposals.reasons[f][i].moves.empty());
        }
    }
}

TEST(Propose, HandsStayAndOneClassIsPredictedWithoutConfidence) {
    Bout bout;
    bout.hand({2}, "left_punch:fwd+react:kick+move:F-F");
    const AutoLabels result = labelAutomatically(bout.project, bout.analysis);
    EXPECT_EQ(result.examples, 1);
    const auto& labels = result.proposals.fighters[0].labels;
    EXPECT_EQ(labelText(kickboxing(), labels[2].label()), "left_punch:fwd+react:kick+move:F-F");
    EXPECT_TRUE(labels[2].aspects[6].byHand());
    EXPECT_EQ(labels[3].aspects[2], (AspectValue{3, LabelSource::Machine, 0.0f}));
}

TEST(AutoLabels, KeepTheirParametersWhileNothingChanges) {
    Bout bout;
    bout.hand({0, 2, 4, 6}, "left_punch:fwd+move:L-L");
    bout.hand({1, 3, 5, 7}, "right_kick:up+move:L-L");
    const AutoLabels first = labelAutomatically(bout.project, bout.analysis);
    ModelRecord record = first.model;
    bout.apply(setModel(bout.project, record));
    const AutoLabels second = labelAutomatically(bout.project, bout.analysis);
    EXPECT_EQ(second.model, record);
    for (std::size_t i = 0; i < first.proposals.fighters[1].labels.size(); ++i) {
        EXPECT_EQ(first.proposals.fighters[1].labels[i], second.proposals.fighters[1].labels[i]);
    }
    bout.hand({0}, "jump:up+move:L-L");
    EXPECT_NE(labelAutomatically(bout.project, bout.analysis).model.trainingHash,
              record.trainingHash);
}

}  // namespace
}  // namespace kumite
