// Choosing the next action: equation 12 and the draw.
#include "core/synthesis/choice.h"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "core/interaction/transition_model.h"
#include "core/synthesis/draw.h"

namespace kumite {
namespace {

/// Transitions and numbers drawn at random, learnt by the model of core/interaction and by the one
/// that bouts choose with.
struct Made {
    TransitionModel model;
    ChoiceModel choice;

    explicit Made(int actions = 300, CovarianceKind kind = CovarianceKind::SemiTied) {
        std::mt19937 random(5);
        const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
        const std::vector<std::string> labels = {"right_punch:fwd", "right_punch:bwd", "jump:up",
                                                 "left_kick:up", "left_kick:down+move:R-R"};
        LabelledTake take;
        for (int p = 0; p < 2; ++p) {
            LabelledStream stream{60, 0, 0, {}, {}};
            for (int i = 0, frame = 0; i < actions; ++i) {
                const int end = frame + 10 + static_cast<int>(40 * uniform());
                stream.actions.push_back({frame, end, (frame + end) / 2});
                stream.labels.push_back(parseLabel(
                    kickboxing(), labels[static_cast<std::size_t>(5 * uniform() * uniform())]));
                frame = end;
            }
            take.players.push_back(std::move(stream));
        }
        auto graph = std::make_shared<CoupledGraph>(coupledGraph(kickboxing(), std::vector{take}));
        const auto& transitions = graph->transitions[0];
        Eigen::MatrixXd rows(static_cast<Eigen::Index>(transitions.size()), 36);
        for (Eigen::Index i = 0; i < rows.rows(); ++i) {
            const double common = uniform();
            for (Eigen::Index j = 0; j < 36; ++j)
                rows(i, j) = 3 + uniform() + common +
                             0.3 * transitions[static_cast<std::size_t>(i)].nextNode;
        }
        GeometrySettings settings;
        settings.kind = kind;
        model = learnTransitionModel(graph, 0, LabelEstimator::Equ7, settings, rows);
        std::vector<int> indices;
        for (int i = 0; i < static_cast<int>(transitions.size()); ++i)
            indices.push_back(i);
        choice =
            ChoiceModel(model.labels, model.geometry, rows, labelTriples(transitions), indices, 12);
    }
    Eigen::VectorXd moment(int row) const {
        Eigen::VectorXd known = model.numbers.row(row).head(24).transpose();
        known[3] += 0.2;
        return known;
    }
};

TEST(Choice, FindsTheSameBestSamplesAsTheModelAsksOneByOne) {
    for (const auto kind : {CovarianceKind::SemiTied, CovarianceKind::Full}) {
        const Made made(300, kind);
        for (const int row : {0, 17, 101}) {
            const Eigen::VectorXd known = made.moment(row);
            const auto candidates =
                made.choice.candidates(row % 5, row % 3, known, ChoiceScore::BestSample);
            for (const NextLabel& slow : nextLabels(made.model, row % 5, row % 3, &known)) {
                const auto& fast = candidates[static_cast<std::size_t>(slow.node)];
                EXPECT_EQ(fast.transition, slow.bestTransition.value_or(-1));
                EXPECT_NEAR(fast.label, slow.label, 1e-12);
                EXPECT_NEAR(fast.geometry, slow.geometry, 1e-9);
                EXPECT_NEAR(fast.product, slow.product, 1e-9);
                EXPECT_NEAR(fast.logDensity, slow.logDensity, 1e-7);
            }
        }
    }
}

TEST(Choice, TheEvidenceIsTheIntegralOverWhateverComesNext) {
    // With a single next number the integral can be summed up.
    const Made made;
    const Eigen::MatrixXd rows = made.model.numbers.leftCols(25);
    const auto triples = labelTriples(made.model.graph->transitions[0]);
    std::vector<int> classes, indices;
    for (const LabelTriple& triple : triples) {
        classes.push_back(triple.next);
        indices.push_back(static_cast<int>(indices.size()));
    }
    const GeometryTerm geometry({}, rows, classes, made.model.labels.nodeCount());
    const ChoiceModel choice(made.model.labels, geometry, rows, triples, indices, 1);
    const Eigen::VectorXd known = made.moment(5);
    for (const auto& candidate : choice.candidates(0, 0, known)) {
        Eigen::VectorXd numbers(25);
        numbers.head(24) = known;
        double sum = 0;
        const double step = 0.002;
        for (numbers[24] = -10; numbers[24] < 20; numbers[24] += step)
            sum += step *
                   std::exp(geometry.logDensity(numbers, candidate.node) - candidate.logEvidence);
        EXPECT_NEAR(sum, 1, 1e-6) << candidate.node;
    }
}

TEST(Choice, ChancesAreProductsAndSumToOne) {
    const Made made;
    const Options options = optionsOf(made.choice.candidates(0, 0, made.moment(3)), {});
    double sum = 0;
    for (const Option& option : options.options) {
        EXPECT_NEAR(option.chance, option.candidate.product, 1e-12);
        sum += option.chance;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    for (std::size_t i = 1; i < options.options.size(); ++i)
        EXPECT_GE(options.options[i - 1].chance, options.options[i].chance);
}

TEST(Choice, TemperatureFlattensAndSharpens) {
    const Made made;
    const auto candidates = made.choice.candidates(0, 0, made.moment(3));
    ChoiceRules rules;
    const auto best = [&](double temperature) {
        rules.temperature = temperature;
        return optionsOf(candidates, rules).options.front().chance;
    };
    EXPECT_EQ(best(0), 1);
    EXPECT_GT(best(0.5), best(1));
    EXPECT_GT(best(1), best(10));
    EXPECT_NEAR(best(1e9), 1.0 / static_cast<double>(candidates.size()), 1e-6);
}

TEST(Choice, StanceGivesWayFirstThenTheCommandThenBansAndTheModeNever) {
    const Made made;
    const auto candidates = made.choice.candidates(0, 0, made.moment(3));
    const std::size_t nodes = candidates.size();
    ASSERT_EQ(nodes, 5u);
    const auto only = [&](std::initializer_list<int> list) {
        std::vector<char> mask(nodes, 0);
        for (const int node : list)
            mask[static_cast<std::size_t>(node)] = 1;
        return mask;
    };
    const auto shown = [](const Options& options) {
        std::set<int> list;
        for (const Option& option : options.options) {
            if (option.chance > 0) list.insert(option.candidate.node);
        }
        return list;
    };
    ChoiceRules rules;
    rules.mode = only({0, 1, 2});
    rules.command = only({1, 2, 3});
    rules.stance = only({2, 4});
    EXPECT_EQ(shown(optionsOf(candidates, rules)), (std::set<int>{2}));

    rules.stance = only({0, 4});
    Options options = optionsOf(candidates, rules);
    EXPECT_EQ(shown(options), (std::set<int>{1, 2}));
    EXPECT_TRUE(options.stanceGaveWay);
    EXPECT_FALSE(options.commandGaveWay);

    rules.command = only({3});
    options = optionsOf(candidates, rules);
    EXPECT_EQ(shown(options), (std::set<int>{0, 1, 2}));
    EXPECT_TRUE(options.commandGaveWay);

    rules.weights = {0, 0, 0, 1, 1};
    options = optionsOf(candidates, rules);
    EXPECT_EQ(shown(options), (std::set<int>{0, 1, 2})) << "no dead end by bans";
    EXPECT_TRUE(options.banGaveWay);

    rules.mode = only({});
    EXPECT_FALSE(optionsOf(candidates, rules).possible());
}

TEST(Choice, BansAndBoosts) {
    const Made made;
    const auto candidates = made.choice.candidates(0, 0, made.moment(3));
    const Options plain = optionsOf(candidates, {});
    ChoiceRules rules;
    rules.weights = {1, 1, 1, 1, 1};
    const int first = plain.options[0].candidate.node;
    const int second = plain.options[1].candidate.node;
    rules.weights[static_cast<std::size_t>(first)] = 0;
    EXPECT_EQ(optionsOf(candidates, rules).find(first)->barred, Barred::Ban);
    EXPECT_EQ(optionsOf(candidates, rules).options.front().candidate.node, second);
    rules.weights[static_cast<std::size_t>(first)] = 3;
    const Options boosted = optionsOf(candidates, rules);
    EXPECT_NEAR(boosted.find(first)->chance / boosted.find(second)->chance,
                3 * plain.find(first)->chance / plain.find(second)->chance, 1e-9);
}

TEST(Choice, DrawsInProportion) {
    const Made made;
    const Options options = optionsOf(made.choice.candidates(0, 0, made.moment(3)), {});
    std::vector<int> counts(5, 0);
    constexpr int kDraws = 20000;
    for (int i = 0; i < kDraws; ++i)
        ++counts[static_cast<std::size_t>(
            options.drawn(drawn(9, 0, static_cast<std::uint64_t>(i))).candidate.node)];
    for (const Option& option : options.options)
        EXPECT_NEAR(counts[static_cast<std::size_t>(option.candidate.node)] / double(kDraws),
                    option.chance, 0.015);
    EXPECT_GT(options.drawn(std::nextafter(1.0, 0.0)).chance, 0);
}

TEST(Draw, IsEvenAndDependsOnEachOfItsArguments) {
    double sum = 0;
    for (std::uint64_t i = 0; i < 10000; ++i) {
        const double number = drawn(3, 1, i);
        ASSERT_GE(number, 0);
        ASSERT_LT(number, 1);
        sum += number;
    }
    EXPECT_NEAR(sum / 10000, 0.5, 0.015);
    EXPECT_NE(drawn(1, 0, 0), drawn(2, 0, 0));
    EXPECT_NE(drawn(1, 0, 0), drawn(1, 1, 0));
    EXPECT_NE(drawn(1, 0, 0), drawn(1, 0, 1));
}

}  // namespace
}  // namespace kumite
