// The basic data structure, the coupled graph, and both on projects.
#include "core/project/interaction.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/interaction/surprise.h"
#include "core/project/edits.h"
#include "tests/support/builders.h"

namespace kumite {
namespace {

/// Actions between boundaries, peaks in the middle, all labelled by the spellings given in turn.
LabelledStream stream(const std::vector<int>& boundaries, const std::vector<std::string>& labels,
                      double rate = 60, double offset = 0) {
    LabelledStream made{rate, offset, boundaries.back() + 1, {}, {}};
    for (std::size_t i = 0; i + 1 < boundaries.size(); ++i) {
        made.actions.push_back(
            {boundaries[i], boundaries[i + 1], (boundaries[i] + boundaries[i + 1]) / 2});
        const std::string& text = labels[i % labels.size()];
        made.labels.push_back(text.empty() ? Label() : parseLabel(kickboxing(), text));
    }
    return made;
}

const std::vector<std::string> kPunches = {"right_punch:fwd+move:L-R", "right_punch:bwd+move:R-L"};
const std::vector<std::string> kKicks = {"left_kick:up+move:R-R", "left_kick:down+move:R-R",
                                         "move:R-L"};

TEST(BasicStructure, TheOpponentsActionInProgressHoldsTheFrameBefore) {
    const LabelledTake take{"a",
                            {stream({0, 20, 40, 60}, kPunches), stream({0, 19, 40, 60}, kKicks)}};
    const BasicStructure all = basicStructure(std::vector{take});
    ASSERT_EQ(all[0].size(), 3u);
    EXPECT_EQ(all[0][0].inProgress, -1) << "nothing was before the take";
    EXPECT_EQ(all[0][1].inProgress, 1) << "frame 19 belongs to the action that begins there";
    EXPECT_EQ(all[0][2].inProgress, 1) << "at a simultaneous change each sees the old one";
    EXPECT_EQ(all[1][2].inProgress, 1);
    EXPECT_EQ(all[1][1].inProgress, 0);
    EXPECT_EQ(all[0][0].next, 1);
    EXPECT_EQ(all[0][2].next, -1);
}

TEST(BasicStructure, OnTheTakesClockWhateverTheRates) {
    // The opponent at 30 Hz, begun 0.5 s later: its boundaries are at 0.5, 1 and 1.5 s.
    const LabelledTake take{
        "a", {stream({0, 20, 60, 61, 90, 120}, kPunches), stream({0, 15, 30}, kKicks, 30, 0.5)}};
    const BasicStructure all = basicStructure(std::vector{take});
    EXPECT_EQ(all[0][1].inProgress, -1) << "at 0.33 s the opponent is not there yet";
    EXPECT_EQ(all[0][2].inProgress, 0) << "both change at 1 s";
    EXPECT_EQ(all[0][3].inProgress, 1) << "a frame later";
    EXPECT_EQ(all[0][4].inProgress, 1) << "1.5 s is the opponent's last moment";
    EXPECT_EQ(all[1][1].inProgress, 1);
    EXPECT_DOUBLE_EQ(all[1][1].beginSeconds, 1.0);
}

TEST(CoupledGraph, GroupsTransitionsAndRepertoire) {
    const LabelledTake take{
        "a", {stream({0, 20, 40, 60, 80}, kPunches), stream({0, 30, 50, 80}, kKicks)}};
    const CoupledGraph graph = coupledGraph(kickboxing(), std::vector{take});
    ASSERT_EQ(graph.nodeCount(0), 2);
    ASSERT_EQ(graph.nodeCount(1), 3);
    const int fwd = *graph.find(0, parseLabel(kickboxing(), kPunches[0]));
    const int bwd = *graph.find(0, parseLabel(kickboxing(), kPunches[1]));
    EXPECT_EQ(graph.node(0, fwd).actions, (std::vector{0, 2}));
    EXPECT_EQ(graph.node(0, fwd).text, kPunches[0]);
    EXPECT_EQ(graph.find(0, parseLabel(kickboxing(), kKicks[0])), std::nullopt);
    ASSERT_EQ(graph.transitionsOf(0).size(), 3u);
    const Transition& second = graph.transitionsOf(0)[1];
    EXPECT_EQ(second.own, 1);
    EXPECT_EQ(second.next, 2);
    EXPECT_EQ(second.opponent, 1) << "at frame 40 the opponent is in its second action";
    EXPECT_EQ(second.ownNode, bwd);
    EXPECT_EQ(second.nextNode, fwd);
    const int punch = *kickboxing().find("right_punch");
    const int qualifier = *kickboxing()[punch].find("bwd");
    EXPECT_EQ(
        graph.repertoire[0][static_cast<std::size_t>(punch)][static_cast<std::size_t>(qualifier)],
        std::vector{bwd});
    const TransitionCounts counts = transitionCounts(graph, 0);
    EXPECT_EQ(counts.own(fwd, bwd), 2);
    EXPECT_EQ(counts.own.sum(), 3);
    EXPECT_EQ(counts.opponent.sum(), 3);
    EXPECT_EQ(counts.next(bwd), 2);
    EXPECT_EQ(transitionsBehind(graph, 0, {fwd, kAnyNode, bwd}), (std::vector{0, 2}));
    EXPECT_EQ(transitionsBehind(graph, 0, {}).size(), 3u);
    const TransitionPlace place = placeOf(graph, 0, second);
    EXPECT_EQ(place.frame, 40);
    EXPECT_EQ(place.mover, (FrameRange{20, 61}));
    EXPECT_EQ(place.opponent, (FrameRange{30, 51}));
    EXPECT_DOUBLE_EQ(place.beginSeconds, 20 / 60.0);
    EXPECT_EQ(transitionAt(graph, 0, 0, 45), 1);
    EXPECT_EQ(transitionAt(graph, 0, 0, 19), std::nullopt);
}

TEST(CoupledGraph, TakesAreNeverChained) {
    const LabelledTake one{"a", {stream({0, 20, 40}, kPunches), stream({0, 30, 40}, kKicks)}};
    const CoupledGraph graph = coupledGraph(kickboxing(), std::vector{one, one, one});
    for (const int mover : {0, 1}) {
        ASSERT_EQ(graph.transitionsOf(mover).size(), 3u) << "one a take";
        for (const Transition& t : graph.transitionsOf(mover)) {
            const int take = graph.action(mover, t.own).take;
            EXPECT_EQ(graph.action(mover, t.next).take, take);
            EXPECT_EQ(graph.action(1 - mover, t.opponent).take, take);
        }
    }
}

TEST(CoupledGraph, SwappingThePlayersSwapsTheGraph) {
    const LabelledTake take{
        "a", {stream({0, 20, 40, 60, 80}, kPunches), stream({0, 20, 50, 80}, kKicks)}};
    const LabelledTake swapped{"a", {take.players[1], take.players[0]}};
    const CoupledGraph a = coupledGraph(kickboxing(), std::vector{take});
    const CoupledGraph b = coupledGraph(kickboxing(), std::vector{swapped});
    for (const std::size_t player : {0, 1}) {
        EXPECT_EQ(a.actions[player], b.actions[1 - player]);
        EXPECT_EQ(a.nodes[player], b.nodes[1 - player]);
        EXPECT_EQ(a.transitions[player], b.transitions[1 - player]);
        EXPECT_EQ(a.repertoire[player], b.repertoire[1 - player]);
    }
}

TEST(CoupledGraph, WhatIsNotLabelledIsLeftOutWithItsTransitions) {
    const LabelledTake take{"a",
                            {stream({0, 20, 40, 60, 80}, {"move:L-L", "", "move:L-L", "move:L-R"}),
                             stream({0, 80}, {"move:L-L"})}};
    const CoupledGraph graph = coupledGraph(kickboxing(), std::vector{take});
    ASSERT_EQ(graph.transitionsOf(0).size(), 1u);
    EXPECT_EQ(graph.transitionsOf(0)[0].own, 2);
    EXPECT_EQ(graph.action(0, 1).node, -1);
    const LabelledTake alone{"b", {stream({0, 20, 40}, kPunches)}};
    const CoupledGraph single = coupledGraph(kickboxing(), std::vector{alone});
    EXPECT_EQ(single.nodeCount(0), 2);
    EXPECT_TRUE(single.transitionsOf(0).empty());
    EXPECT_TRUE(single.transitionsOf(1).empty());
}

/// A project whose actions all have labels said by a hand, in turn.
Project labelledBout(int every = 1) {
    Project project = test::makeBout();
    const Analysis analysis = analyse(project);
    for (const int player : {0, 1}) {
        const FighterAddress fighter{0, player};
        const int count = static_cast<int>(analysis.at(fighter).segmentation->actions.size());
        for (int i = 0; i < count; i += every) {
            const auto& labels = i % 3 == 2 ? kKicks : kPunches;
            const auto edit =
                setWholeLabel(project, analysis, fighter, std::vector{i},
                              parseLabel(kickboxing(), labels[static_cast<std::size_t>(i % 2)]));
            if (edit) project = edit->project;
        }
    }
    return project;
}

TEST(Interaction, FollowsTheProject) {
    const Project project = labelledBout();
    const Analysis analysis = analyse(project);
    const Interaction interaction = deriveInteraction(project, analysis);
    EXPECT_EQ(whyNoModel(project, interaction), std::nullopt);
    EXPECT_TRUE(interaction.findings.empty());
    for (const int mover : {0, 1}) {
        const auto& actions = analysis.at({0, mover}).segmentation->actions;
        EXPECT_NEAR(interaction.graph->transitionsOf(mover).size(), actions.size() - 1, 1);
        const TransitionModel& model = *interaction.models[static_cast<std::size_t>(mover)];
        EXPECT_EQ(model.mover, mover);
        const Transition& t = interaction.graph->transitionsOf(mover)[2];
        const auto ranked = nextLabels(model, t.ownNode, t.opponentNode);
        double sum = 0;
        int examples = 0;
        for (std::size_t i = 0; i < ranked.size(); ++i) {
            sum += ranked[i].product;
            examples += ranked[i].examples;
            EXPECT_LE(ranked[i].product, ranked[i > 0 ? i - 1 : 0].product);
            EXPECT_LE(ranked[i].examples, ranked[i].ownExamples);
        }
        EXPECT_NEAR(sum, 1, 1e-12);
        EXPECT_EQ(examples,
                  transitionsBehind(*interaction.graph, mover, {t.ownNode, t.opponentNode}).size());
        for (const Surprise& surprise : surprises(model))
            EXPECT_TRUE(std::isfinite(surprise.geometry) && surprise.label > 0 &&
                        surprise.both >= 0);
    }
    const Interaction again = deriveInteraction(project, analysis, {}, interaction);
    EXPECT_EQ(again.graph, interaction.graph);
    EXPECT_EQ(again.models, interaction.models);
}

/// A labelled bout whose fighters stand 2 m apart, face to face.
Project facingBout() {
    Project project = labelledBout();
    project.takes[0].fighters[1].placement = {0.1, 2, 3.0};
    return project;
}

TEST(Interaction, SwappingTheFilesSwapsTheModels) {
    const Project project = facingBout();
    Project swapped = project;
    std::swap(swapped.takes[0].fighters[0], swapped.takes[0].fighters[1]);
    const Interaction a = deriveInteraction(project, analyse(project));
    const Interaction b = deriveInteraction(swapped, analyse(swapped));
    for (const std::size_t p : {0, 1}) {
        EXPECT_EQ(a.graph->nodes[p], b.graph->nodes[1 - p]);
        EXPECT_EQ(a.graph->transitions[p], b.graph->transitions[1 - p]);
        const TransitionModel& one = *a.models[p];
        const TransitionModel& other = *b.models[1 - p];
        EXPECT_NEAR((one.numbers - other.numbers).norm(), 0, 1e-6);
        const auto surprise = surprises(one), same = surprises(other);
        ASSERT_EQ(surprise.size(), same.size());
        for (std::size_t i = 0; i < same.size(); ++i)
            EXPECT_NEAR(surprise[i].label, same[i].label, 1e-9);
    }
}

TEST(Interaction, DoesNotChangeWhenBothAreMovedAndTurnedTogether) {
    const Project project = facingBout();
    Project turned = project;
    for (Fighter& fighter : turned.takes[0].fighters) {
        const double c = std::cos(2.4), s = std::sin(2.4);
        const Placement was = fighter.placement;
        fighter.placement = {c * was.x + s * was.z + 3.5, c * was.z - s * was.x - 1.25,
                             was.yaw + 2.4};
    }
    const Interaction a = deriveInteraction(project, analyse(project));
    const Interaction b = deriveInteraction(turned, analyse(turned));
    for (const std::size_t p : {0, 1}) {
        EXPECT_NEAR((a.models[p]->numbers - b.models[p]->numbers).norm(), 0, 1e-8);
        EXPECT_GT(a.models[p]->numbers.norm(), 1);
    }
}

TEST(Interaction, AfterAnEditOnlyWhatChangedIsNew) {
    const Project project = facingBout();
    const Analysis analysis = analyse(project);
    const Interaction before = deriveInteraction(project, analysis);
    const auto same = [](const Interaction& x, const Interaction& y) {
        for (const std::size_t p : {0, 1}) {
            EXPECT_EQ(x.graph->transitions[p], y.graph->transitions[p]);
            EXPECT_EQ(x.models[p]->numbers, y.models[p]->numbers);
            EXPECT_EQ(x.models[p]->nextTurned, y.models[p]->nextTurned);
        }
    };
    const Project relabelled = setWholeLabel(project, analysis, {0, 0}, std::vector{3},
                                             parseLabel(kickboxing(), "jump:up+move:L-F"))
                                   ->project;
    const Interaction label = deriveInteraction(relabelled, analysis, {}, before);
    EXPECT_EQ(label.poses, before.poses);
    EXPECT_NE(label.graph, before.graph);
    same(label, deriveInteraction(relabelled, analysis));

    const int frame = analysis.at({0, 1}).segmentation->boundaries[4].frame;
    const Project cut = removeBoundary(project, analysis, {0, 1}, frame)->project;
    const Analysis after = analyse(cut, analysis);
    const Interaction boundary = deriveInteraction(cut, after, {}, before);
    EXPECT_EQ(boundary.poses, before.poses);
    same(boundary, deriveInteraction(cut, after));

    Project moved = project;
    moved.takes[0].fighters[1].placement.x += 0.5;
    const Interaction elsewhere = deriveInteraction(moved, analyse(moved, analysis), {}, before);
    EXPECT_EQ(elsewhere.graph, before.graph);
    EXPECT_NE(elsewhere.models, before.models) << "where they stand is part of the numbers";
}

TEST(Interaction, MomentsFollowTheRuleOfWhatIsInProgress) {
    const Project project = facingBout();
    const Analysis analysis = analyse(project);
    const Interaction interaction = deriveInteraction(project, analysis);
    for (const int mover : {0, 1}) {
        const auto& transitions = interaction.graph->transitionsOf(mover);
        const TransitionModel& model = *interaction.models[static_cast<std::size_t>(mover)];
        for (std::size_t i = 0; i < transitions.size(); ++i) {
            const int frame = placeOf(*interaction.graph, mover, transitions[i]).frame;
            const Moment moment = momentAt(analysis, interaction, 0, frame, mover);
            EXPECT_EQ(moment.transition, static_cast<int>(i));
            EXPECT_EQ(moment.ownAction, transitions[i].own);
            EXPECT_EQ(moment.opponentAction, transitions[i].opponent);
            ASSERT_EQ(moment.numbers.size(), 24);
            const auto row = model.numbers.row(static_cast<Eigen::Index>(i));
            EXPECT_NEAR((moment.numbers - row.head(24).transpose()).norm(), 0, 1e-9);
            double sum = 0;
            for (const NextLabel& next : nextLabels(interaction, mover, moment))
                sum += next.product;
            EXPECT_NEAR(sum, 1, 1e-9);
        }
        const Moment begin = momentAt(analysis, interaction, 0, 0, mover);
        EXPECT_GE(begin.ownAction, 0);
        EXPECT_EQ(begin.transition, std::nullopt);
    }
}

TEST(Interaction, AnAvatarsNumbersHoldItsTarget) {
    const Project project = facingBout();
    const Analysis analysis = analyse(project);
    const Interaction plain = deriveInteraction(project, analysis);
    InteractionSettings settings;
    settings.numbers = TransitionNumbers::WithTarget;
    const Interaction led = deriveInteraction(project, analysis, settings, plain);
    EXPECT_EQ(led.graph, plain.graph);
    EXPECT_EQ(led.poses, plain.poses);
    for (const std::size_t mover : {0, 1}) {
        const Eigen::MatrixXd& rows = led.models[mover]->numbers;
        ASSERT_EQ(rows.cols(), 38);
        const int last = analysis.at({0, int(mover)}).frameCount() - 31;  // half a second is left
        int unknown = 0;
        for (Eigen::Index i = 0; i < rows.rows(); ++i) {
            const Transition& t = led.graph->transitions[mover][std::size_t(i)];
            const int frame = placeOf(*led.graph, int(mover), t).frame;
            const auto& ground = led.numbers->grounds[mover][std::size_t(i)];
            const Moment moment = momentAt(analysis, led, 0, frame, int(mover));
            EXPECT_EQ(ground.target.has_value(), frame <= last);
            if (!ground.target) {
                EXPECT_TRUE(rows.row(i).hasNaN());
                EXPECT_EQ(moment.numbers.size(), 0);
                ++unknown;
                continue;
            }
            const auto same = plain.models[mover]->numbers.row(i);
            EXPECT_EQ(rows.row(i).head(24), same.head(24));
            EXPECT_EQ(rows.row(i).segment<2>(24), ground.target->transpose());
            EXPECT_EQ(rows.row(i).tail(12), same.tail(12));
            ASSERT_EQ(moment.numbers.size(), 26);
            EXPECT_NEAR((moment.numbers.transpose() - rows.row(i).head(26)).norm(), 0, 1e-9);
        }
        EXPECT_GT(unknown, 0);
        EXPECT_EQ(led.models[mover]->geometry.dimensions(), 38);
    }
}

TEST(Interaction, SaysWhatIsMissing) {
    const Project bare = test::makeBout();
    const auto why = whyNoModel(bare, deriveInteraction(bare, analyse(bare)));
    ASSERT_TRUE(why);
    EXPECT_NE(why->find("kumite label --auto"), std::string::npos);

    const Project some = labelledBout(4);
    const Interaction interaction = deriveInteraction(some, analyse(some));
    ASSERT_EQ(interaction.findings.size(), 2u);
    EXPECT_NE(interaction.findings[0].text.find("have no label"), std::string::npos);
    EXPECT_TRUE(whyNoModel(some, interaction));

    Project alone = labelledBout();
    alone.takes[0].fighters.pop_back();
    const auto single = whyNoModel(alone, deriveInteraction(alone, analyse(alone)));
    EXPECT_EQ(single, "A model of two fighters needs a take with two of them.");

    Project missing = labelledBout();
    missing.takes[0].fighters[1].motion = nullptr;
    EXPECT_TRUE(whyNoModel(missing, deriveInteraction(missing, analyse(missing))));
    const Project empty;
    EXPECT_TRUE(whyNoModel(empty, deriveInteraction(empty, analyse(empty))));
}

TEST(Interaction, RulesFillWhatAHandLeftOpen) {
    Project project = test::makeBout();
    const Analysis analysis = analyse(project);
    const int punch = *kickboxing().find("right_punch");
    project = setLabel(project, analysis, {0, 0}, std::vector{1}, punch, 0)->project;
    const auto labels = effectiveLabels(project, analysis);
    ASSERT_EQ(labels.size(), 2u);
    const ActionLabel& filled = labels[0].labels[1];
    const auto at = [&](const char* aspect) {
        return filled.aspects[static_cast<std::size_t>(*kickboxing().find(aspect))];
    };
    EXPECT_TRUE(at("right_punch").byHand());
    EXPECT_TRUE(at("move").known());
    EXPECT_EQ(at("move").source, LabelSource::Rule);
    EXPECT_TRUE(at("react").known());
    EXPECT_FALSE(at("jump").known()) << "what must be learnt is not made up";
    EXPECT_FALSE(labels[0].labels[2].anyKnown()) << "nobody said anything of this one";
}

}  // namespace
}  // namespace kumite
