// How unexpected transitions are, and models of movers that are led by a target.
#include "core/interaction/surprise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/demo/random.h"

namespace kumite {
namespace {

constexpr int kActions = 240;
constexpr int kWrong = 100;  ///< action whose label is wrong, where there is one
const std::vector<std::string> kSpellings = {"move:L-L", "move:L-R", "move:R-R"};

/// A bout of three labels in no order, whose motions tell the label: its number is the place of the
/// next action's. `wrong`: one action carries another label than its motion has.
TransitionModel learnt(CovarianceKind kind, bool wrong, int targetless = 0) {
    demo::Random random(4);
    LabelledTake take;
    std::vector<int> kinds;
    for (int player = 0; player < 2; ++player) {
        LabelledStream stream{60, 0, 30 * kActions + 1, {}, {}};
        for (int i = 0; i < kActions; ++i) {
            stream.actions.push_back({30 * i, 30 * (i + 1), 30 * i + 15});
            const int label = random.pick(std::vector<double>{1, 1, 1});
            if (player == 0) kinds.push_back(label);
            const int said = wrong && player == 0 && i == kWrong ? (label + 1) % 3 : label;
            stream.labels.push_back(
                parseLabel(kickboxing(), kSpellings[static_cast<std::size_t>(said)]));
        }
        take.players.push_back(std::move(stream));
    }
    const auto graph =
        std::make_shared<const CoupledGraph>(coupledGraph(kickboxing(), std::vector{take}));
    // n¹ᵢ, n²ⱼ, a target and n¹ᵢ₊₁ of one number each would do; the sizes are those of k = 1.
    const auto count = static_cast<Eigen::Index>(graph->transitionsOf(0).size());
    Eigen::MatrixXd numbers(count, 26);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < 26; ++j)
            numbers(i, j) = random.normal(0, 1);
        const int next = graph->transitionsOf(0)[static_cast<std::size_t>(i)].next;
        const double place = 3.0 * kinds[static_cast<std::size_t>(next)];
        numbers(i, 16) = place + random.normal(0, 0.3);  // the target leads where the action goes
        numbers(i, 18) = place + random.normal(0, 0.5);
    }
    numbers.bottomRows(targetless).setConstant(std::numeric_limits<double>::quiet_NaN());
    GeometrySettings settings;
    settings.kind = kind;
    return learnTransitionModel(graph, 0, LabelEstimator::Equ7, settings, numbers);
}

/// The transition into an action of player 1.
std::size_t into(const TransitionModel& model, int action) {
    const auto& all = model.graph->transitionsOf(0);
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(),
                     [&](const Transition& t) { return t.next == action; }) -
        all.begin());
}

TEST(Surprise, AWrongLabelStandsOutSeenTheMotion) {
    for (const CovarianceKind kind :
         {CovarianceKind::SemiTied, CovarianceKind::Full, CovarianceKind::Diagonal}) {
        const TransitionModel model = learnt(kind, true);
        const std::vector<Surprise> all = surprises(model);
        const std::size_t wrong = into(model, kWrong);
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_GE(all[i].both, 0);
            if (i == wrong) continue;
            EXPECT_LT(all[i].both, all[wrong].both) << i;
        }
        // H and the axes of FULL saw the sample, which hides a part of it; those of DIAGONAL do not
        // turn.
        if (kind == CovarianceKind::Diagonal) {
            EXPECT_GT(all[wrong].both, 10 * uniformSurprise(model));
        }
        // The label term cannot know: labels follow each other at random.
        EXPECT_LT(all[wrong].label, 2 * std::log(3));
        const std::vector<Surprise> right = surprises(learnt(kind, false));
        EXPECT_LT(right[wrong].both, 0.05);
    }
}

TEST(Surprise, BothTermsAreBayesRule) {
    // Against a model that was really learnt without the transition: nearly the same, as only
    // standardising, H and W̄ saw it.
    const TransitionModel model = learnt(CovarianceKind::Diagonal, true);
    const std::vector<Surprise> all = surprises(model);
    for (const std::size_t i : {into(model, kWrong), std::size_t{20}, std::size_t{77}}) {
        auto rest = std::make_shared<CoupledGraph>(*model.graph);
        auto& transitions = rest->transitions[0];
        const Transition left = transitions[i];
        transitions.erase(transitions.begin() + static_cast<std::ptrdiff_t>(i));
        const auto row = static_cast<Eigen::Index>(i);
        Eigen::MatrixXd numbers(model.numbers.rows() - 1, model.numbers.cols());
        numbers << model.numbers.topRows(row),
            model.numbers.bottomRows(model.numbers.rows() - row - 1);
        GeometrySettings settings;
        settings.kind = CovarianceKind::Diagonal;
        const TransitionModel other =
            learnTransitionModel(rest, 0, LabelEstimator::Equ7, settings, numbers);
        std::vector<double> logs = other.labels.logProbabilities(left.ownNode, left.opponentNode);
        for (std::size_t label = 0; label < logs.size(); ++label) {
            logs[label] += other.geometry.logDensity(model.numbers.row(row).transpose(),
                                                     static_cast<int>(label));
        }
        const double expected = logSum(logs) - logs[static_cast<std::size_t>(left.nextNode)];
        EXPECT_NEAR(all[i].both, expected, 0.02 + 0.03 * expected) << i;
        EXPECT_NEAR(all[i].label,
                    -other.labels.logProbabilities(left.ownNode,
                                                   left.opponentNode)[std::size_t(left.nextNode)],
                    1e-9);
    }
}

TEST(Surprise, KindsAreTold) {
    const Surprise surprise{1, 2, 3};
    EXPECT_EQ(valueOf(surprise, SurpriseKind::Label), 1);
    EXPECT_EQ(valueOf(surprise, SurpriseKind::Geometry), 2);
    EXPECT_EQ(valueOf(surprise, SurpriseKind::Both), 3);
}

TEST(TargetModel, LeadsToTheLabelWhoseExamplesGoThere) {
    const TransitionModel model = learnt(CovarianceKind::SemiTied, false);
    EXPECT_EQ(model.geometry.dimensions(), 26);
    for (int label = 0; label < 3; ++label) {
        Eigen::VectorXd moment = Eigen::VectorXd::Zero(18);
        moment[16] = 3.0 * label;
        const std::vector<NextLabel> ranked = nextLabels(model, kAnyNode, kAnyNode, &moment);
        const std::string wanted =
            model.graph
                ->node(0, *model.graph->find(
                              0, parseLabel(kickboxing(), kSpellings[std::size_t(label)])))
                .text;
        EXPECT_EQ(model.graph->node(0, ranked[0].node).text, wanted);
        EXPECT_GT(ranked[0].product, 0.9);
    }
}

TEST(TargetModel, WithoutATargetATransitionTeachesItsLabelAlone) {
    constexpr int kMissing = 40;
    const TransitionModel whole = learnt(CovarianceKind::SemiTied, false);
    const TransitionModel model = learnt(CovarianceKind::SemiTied, false, kMissing);
    EXPECT_EQ(model.labels.probabilities(0, 1), whole.labels.probabilities(0, 1));
    const int known = static_cast<int>(model.numbers.rows()) - kMissing;
    Eigen::VectorXd moment = Eigen::VectorXd::Zero(18);
    for (double target = -1; target < 7; target += 0.5) {
        moment[16] = target;
        double sum = 0;
        for (const NextLabel& next : nextLabels(model, 0, 1, &moment)) {
            ASSERT_TRUE(next.bestTransition);
            EXPECT_LT(*next.bestTransition, known);
            sum += next.product;
        }
        EXPECT_NEAR(sum, 1, 1e-9);
    }
    const std::vector<Surprise> all = surprises(model);
    EXPECT_EQ(all.back().geometry, 0);
    EXPECT_EQ(all.back().both, all.back().label);
    EXPECT_NE(all.front().both, all.front().label);

    const TransitionModel none =
        learnt(CovarianceKind::SemiTied, false, static_cast<int>(model.numbers.rows()));
    EXPECT_FALSE(none.geometry.trained());
    for (const NextLabel& next : nextLabels(none, 0, 1, &moment))
        EXPECT_EQ(next.product, next.label);
}

}  // namespace
}  // namespace kumite
