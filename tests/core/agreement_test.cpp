#include "core/project/agreement.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/label_files.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

constexpr FighterAddress kRed{0, 0};
constexpr FighterAddress kBlue{0, 1};

/// The first actions of a fighter with these labels by hand; "" stays open.
FighterLabels said(const Project& project, const Analysis& analysis, FighterAddress fighter,
                   const std::vector<std::string>& texts) {
    FighterLabels labels{fighter, actionLabels(fighterAt(project, fighter), analysis.at(fighter),
                                               kickboxing().size())};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (texts[i].empty()) continue;
        const Label label = parseLabel(kickboxing(), texts[i]);
        for (std::size_t a = 0; a < label.size(); ++a) {
            if (label[a] == kUnknown) continue;
            labels.labels[i].aspects[a] = {static_cast<std::int8_t>(label[a]), LabelSource::Hand,
                                           1.0f};
        }
    }
    return labels;
}

struct TwoPeople {
    Project project = test::makeBout();
    Analysis analysis = analyse(project);
    std::vector<FighterLabels> first = {
        said(project, analysis, kRed,
             {"left_punch:fwd", "left_punch:fwd", "left_punch:bwd", "others", "jump:up", ""}),
        said(project, analysis, kBlue, {"right_kick:up", "others"})};
    std::vector<FighterLabels> second = {
        said(project, analysis, kRed,
             {"left_punch:fwd", "left_punch:bwd", "left_punch:bwd", "left_punch:fwd",
              "left_punch:?+jump:up", "others"})};
};

TEST(Agreement, KappaWorkedOutOnPaper) {
    const TwoPeople two;
    ASSERT_GE(two.first[0].labels.size(), 6u);
    const Agreement agreement = compareLabels(two.project, two.analysis, two.first, two.second);
    EXPECT_EQ(agreement.both, 5);
    EXPECT_EQ(agreement.same, 3) << "actions 0, 2 and, as far as both judged it, 4";
    EXPECT_EQ(agreement.onlyFirst, 2) << "the other fighter";
    EXPECT_EQ(agreement.onlySecond, 1);
    ASSERT_EQ(agreement.additions.size(), 6u) << "the learnt aspects of one action";
    EXPECT_EQ(agreement.additions[0].action, 5);
    EXPECT_EQ(agreement.additions[0].first, kUnknown);
    // Left punch over four actions: first fwd 2, bwd 1, others 1; second fwd 2, bwd 2; two agree.
    const AspectAgreement& punch = agreement.aspects[0];
    EXPECT_EQ(punch.both, 4);
    EXPECT_EQ(punch.same, 2);
    const double chance = (2.0 * 2 + 1.0 * 2) / 16;
    EXPECT_NEAR(*punch.kappa, (0.5 - chance) / (1 - chance), 1e-12);
    EXPECT_EQ(punch.counts[0][1], 1) << "fwd, called bwd by the other";
    // Jump: up once and others four times by both.
    EXPECT_EQ(agreement.aspects[4].kappa, 1.0);
    EXPECT_EQ(agreement.aspects[6].kappa, std::nullopt) << "nobody judged the footsteps";
    // Pooled: punch 4, jump 5 and four aspects of 5 that are always others.
    const double byChance = 4 * chance + 5 * (16.0 + 1) / 25 + 20;
    EXPECT_NEAR(*agreement.kappa, (2 + 5 + 20 - byChance) / (29 - byChance), 1e-12);
}

TEST(Agreement, DifferencesCanBeTakenOver) {
    TwoPeople two;
    two.project = importLabels(two.project, two.analysis, two.first)->project;
    const Agreement agreement =
        compareLabels(two.project, two.analysis, ownLabels(two.project, two.analysis), two.second);
    const int fwd = 0, bwd = 1, others = *kickboxing()[0].fallback;
    EXPECT_EQ(
        agreement.differences,
        (std::vector<LabelDifference>{
            {kRed, 1, 0, fwd, bwd}, {kRed, 3, 0, others, fwd}, {kRed, 4, 0, others, kUnknown}}));
    EXPECT_FALSE(agreement.differences[2].conflict());
    const std::string csv = differencesCsv(two.project, two.analysis, agreement.differences);
    EXPECT_NE(csv.find(",1,3,"), std::string::npos);
    EXPECT_NE(csv.find(",left_punch,fwd,bwd\n"), std::string::npos);
    EXPECT_NE(csv.find(",left_punch,others,\n"), std::string::npos);

    const auto one = takeOverLabels(two.project, two.analysis, {{agreement.differences[1]}});
    ASSERT_TRUE(one);
    const auto left = compareLabels(one->project, two.analysis,
                                    ownLabels(one->project, two.analysis), two.second);
    EXPECT_EQ(left.differences.size(), 2u);
    EXPECT_FALSE(takeOverLabels(two.project, two.analysis, {{agreement.differences[2]}}))
        << "the second said nothing there";
    EXPECT_FALSE(takeOverLabels(two.project, two.analysis, {}));
    const auto added = takeOverLabels(two.project, two.analysis, agreement.additions);
    ASSERT_TRUE(added);
    const auto both = compareLabels(added->project, two.analysis,
                                    ownLabels(added->project, two.analysis), two.second);
    EXPECT_TRUE(both.additions.empty());
    EXPECT_EQ(both.both, agreement.both + 1);
    EXPECT_EQ(both.same, agreement.same + 1);
    EXPECT_EQ(both.differences, agreement.differences) << "what both judged stays";
    EXPECT_THROW(takeOverLabels(two.project, two.analysis, {{{kRed, 99, 0, 0, 1}}}), Error);
}

TEST(Agreement, MergingFillsInAndKeepsWhatAHandSaid) {
    TwoPeople two;
    two.project = importLabels(two.project, two.analysis, two.first)->project;
    const auto merged = mergeLabels(two.project, two.analysis, two.second);
    ASSERT_TRUE(merged);
    const auto labels = ownLabels(merged->project, two.analysis);
    EXPECT_EQ(labelText(kickboxing(), labels[0].labels[1].label()), "left_punch:fwd");
    EXPECT_EQ(labelText(kickboxing(), labels[0].labels[5].label(), true), "others");
    EXPECT_FALSE(mergeLabels(merged->project, two.analysis, two.second));
}

TEST(Agreement, MachinesDoNotCountUnlessAsked) {
    TwoPeople two;
    for (ActionLabel& label : two.second[0].labels) {
        for (AspectValue& value : label.aspects)
            value.source = LabelSource::Machine;
    }
    const auto people = compareLabels(two.project, two.analysis, two.first, two.second);
    EXPECT_EQ(people.both, 0);
    EXPECT_EQ(people.kappa, std::nullopt);
    EXPECT_TRUE(people.differences.empty());
    EXPECT_EQ(
        compareLabels(two.project, two.analysis, two.first, two.second, Compared::Anybody).both, 5);
    two.second[0].labels.pop_back();
    EXPECT_THROW(compareLabels(two.project, two.analysis, two.first, two.second), Error);
}

}  // namespace
}  // namespace kumite
