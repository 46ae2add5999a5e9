#include "core/labelling/learner.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "core/labelling/distances.h"
#include "core/labelling/query.h"
#include "core/labelling/reliability.h"
#include "core/labelling/scores.h"
#include "tests/support/made_actions.h"

namespace kumite {
namespace {

using test::MadeActions;

Predictions learn(const MadeActions& made, int examples, const LearningSettings& settings = {},
                  bool probabilities = false) {
    const TrainingSet set(kickboxing(), made.features, made.examples(0, examples), settings);
    return set.predict(defaultParameters(kickboxing()), probabilities);
}

TEST(Learner, FindsWhatItHasSeen) {
    const MadeActions made(400);
    EXPECT_GT(made.accuracy(learn(made, 150), 150), 0.95);
    LearningSettings limbFirst;
    limbFirst.limbFirst = true;
    EXPECT_GT(made.accuracy(learn(made, 150, limbFirst), 150), 0.9);
}

TEST(Learner, MirroredExamplesTeachTheOtherSide) {
    // Only left strikes are shown; right ones must be found.
    const MadeActions left(120, 1.0f, 3, {"others", "left_punch:fwd", "left_kick:up"});
    const MadeActions right(120, 1.0f, 4, {"others", "right_punch:fwd", "right_kick:up"});
    MadeActions both = left;
    both.features.conservativeResize(240, kFeatureCount);
    both.features.bottomRows(120) = right.features;
    both.truth.insert(both.truth.end(), right.truth.begin(), right.truth.end());
    EXPECT_GT(both.accuracy(learn(both, 120), 120), 0.95);
    LearningSettings plain;
    plain.mirrored = false;
    EXPECT_LT(both.accuracy(learn(both, 120, plain), 120), 0.75);
}

TEST(Learner, IsDeterministicAlsoWithProbabilities) {
    const MadeActions made(200, 2.0f);
    const Predictions first = learn(made, 80, {}, true);
    std::srand(99);
    const Predictions second = learn(made, 80, {}, true);
    for (std::size_t i = 0; i < first.values.size(); ++i) {
        EXPECT_EQ(first.values[i].qualifier, second.values[i].qualifier);
        EXPECT_EQ(first.values[i].margin, second.values[i].margin);
        EXPECT_EQ(first.values[i].confidence, second.values[i].confidence);
    }
}

TEST(Learner, ConfidencesAreCalibrated) {
    const MadeActions made(600, 4.5f);
    const Predictions predictions = learn(made, 250, {}, true);
    double stated = 0;
    int right = 0;
    for (int i = 250; i < 600; ++i) {
        for (int a = 0; a < 5; ++a) {
            stated += predictions.at(i, a).confidence;
            right += predictions.at(i, a).qualifier ==
                     made.truth[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)];
        }
    }
    EXPECT_NEAR(stated, right, 0.08 * 5 * 350);
}

TEST(Learner, TheSecondBestIsOftenRightWhereTheBestIsWrong) {
    const MadeActions made(600, 4.5f);
    for (const bool probabilities : {false, true}) {
        const Predictions predictions = learn(made, 250, {}, probabilities);
        int wrong = 0;
        int second = 0;
        for (int i = 250; i < 600; ++i) {
            for (int a = 0; a < 4; ++a) {
                const Prediction& said = predictions.at(i, a);
                EXPECT_NE(said.second, said.qualifier);
                EXPECT_EQ(said.secondConfidence > 0, probabilities);
                EXPECT_LE(said.confidence + said.secondConfidence, 1 + 1e-9);
                EXPECT_LE(said.secondConfidence, said.confidence) << "what is said is likelier";
                const int truth =
                    made.truth[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)];
                if (said.qualifier == truth) continue;
                ++wrong;
                second += said.second == truth;
            }
        }
        ASSERT_GT(wrong, 10) << "the case is hard enough";
        EXPECT_GT(second, wrong / 2);
    }
}

TEST(Learner, NothingOneExampleAndOneClass) {
    const MadeActions made(30, 1.0f, 7, {"others"});
    EXPECT_EQ(learn(made, 0).at(3, 0).qualifier, kUnknown);
    for (const int count : {1, 20}) {
        const Predictions predictions = learn(made, count, {}, true);
        for (int a = 0; a < 5; ++a) {
            EXPECT_EQ(predictions.at(25, a).qualifier, kickboxing()[a].fallback);
            // One class in n examples: others are rarer than 3 / n.
            EXPECT_NEAR(predictions.at(25, a).confidence, count == 1 ? 0 : 1 - 3.0 / 20, 1e-12);
            EXPECT_TRUE(predictions.at(25, a).blind);
        }
        EXPECT_EQ(predictions.at(25, 6).qualifier, kUnknown) << "rules are not learnt";
    }
    const TrainingSet set(kickboxing(), made.features, made.examples(0, 20), {});
    EXPECT_EQ(set.searchParameters(), defaultParameters(kickboxing()));
    // All 20 alike were answered right: (20 + 1) / (20 + 2).
    EXPECT_DOUBLE_EQ(set.expectedAccuracy(defaultParameters(kickboxing()), learn(made, 20)),
                     21.0 / 22);
    LearningSettings limbFirst;
    limbFirst.limbFirst = true;
    EXPECT_EQ(learn(made, 20, limbFirst).at(25, 0).qualifier, kickboxing()[0].fallback);
}

TEST(Learner, OpenAspectsDoNotTrain) {
    MadeActions made(60);
    std::vector<Example> examples = made.examples(0, 40);
    for (Example& example : examples)
        example.label[4] = kUnknown;
    const TrainingSet set(kickboxing(), made.features, examples, {});
    const Predictions predictions = set.predict(defaultParameters(kickboxing()), false);
    EXPECT_EQ(predictions.at(50, 4).qualifier, kUnknown);
    EXPECT_NE(predictions.at(50, 0).qualifier, kUnknown);
}

TEST(Learner, AspectsThatExcludeEachOtherAreNotBothFound) {
    const MadeActions made(400, 6.0f);
    const Predictions predictions = learn(made, 60);
    for (int i = 0; i < 400; ++i) {
        Label label;
        for (int a = 0; a < 7; ++a)
            label.push_back(predictions.at(i, a).qualifier);
        EXPECT_TRUE(conflicts(kickboxing(), label).empty());
    }
}

TEST(Learner, TheSearchIsRepeatableAndCanBeCancelled) {
    const MadeActions made(200, 3.0f);
    const TrainingSet set(kickboxing(), made.features, made.examples(0, 80), {});
    const ParameterSet found = set.searchParameters();
    EXPECT_EQ(set.searchParameters(), found);
    EXPECT_GE(made.accuracy(set.predict(found, false), 80) + 0.05,
              made.accuracy(set.predict(defaultParameters(kickboxing()), false), 80));
    // What is found by chance among noise moves nothing.
    MadeActions noise(120, 1.0f, 5, {"others"});
    for (std::size_t i = 0; i < noise.truth.size(); i += 3)
        noise.truth[i] = parseLabel(kickboxing(), i % 2 ? "left_punch:fwd" : "jump:up");
    EXPECT_EQ(
        TrainingSet(kickboxing(), noise.features, noise.examples(0, 100), {}).searchParameters(),
        defaultParameters(kickboxing()));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(set.searchParameters({{}, stop.get_token()}), Cancelled);
}

TEST(Learner, ExpectedAccuracyIsNearTheRealOne) {
    const MadeActions made(800, 5.0f);
    const TrainingSet set(kickboxing(), made.features, made.examples(0, 200), {});
    const ParameterSet parameters = defaultParameters(kickboxing());
    const Predictions predictions = set.predict(parameters, false);
    EXPECT_NEAR(set.expectedAccuracy(parameters, predictions), made.accuracy(predictions, 200),
                0.08);
}

TEST(Learner, HardExamplesDoNotMakeTheRestLookHard) {
    // The hand labelled what has the smallest margins, as a session does.
    const MadeActions made(600, 4.0f);
    const ParameterSet parameters = defaultParameters(kickboxing());
    const Predictions first = learn(made, 60);
    std::vector<int> rows(600);
    std::iota(rows.begin(), rows.end(), 0);
    std::stable_sort(rows.begin() + 60, rows.end(), [&](int a, int b) {
        return smallestMargin(first, a) < smallestMargin(first, b);
    });
    std::vector<Example> examples = made.examples(0, 60);
    for (std::size_t i = 60; i < 160; ++i)
        examples.push_back(made.examples(rows[i], rows[i] + 1).front());
    const TrainingSet set(kickboxing(), made.features, examples, {});
    const Predictions predictions = set.predict(parameters, false);
    const std::vector<Label> answers = set.crossValidate(parameters);
    double amongHard = 0, ofTheRest = 0;
    for (std::size_t i = 0; i < examples.size(); ++i)
        amongHard += learntAspectsMatch(kickboxing(), examples[i].label, answers[i]);
    amongHard /= static_cast<double>(examples.size());
    for (std::size_t i = 160; i < rows.size(); ++i) {
        Label answer;
        for (int a = 0; a < 7; ++a)
            answer.push_back(predictions.at(rows[i], a).qualifier);
        ofTheRest +=
            learntAspectsMatch(kickboxing(), made.truth[static_cast<std::size_t>(rows[i])], answer);
    }
    ofTheRest /= 440;
    ASSERT_GT(ofTheRest, amongHard + 0.05) << "else it says nothing";
    const double expected = set.expectedAccuracy(parameters, predictions);
    EXPECT_LT(std::abs(expected - ofTheRest), std::abs(amongHard - ofTheRest) / 2);
}

TEST(Learner, OfVeryManyExamplesSomeTakePartAndRareOnesStay) {
    MadeActions made(2600, 3.0f, 9, {"others", "left_kick:up", "right_punch:fwd"});
    const Label rare = parseLabel(kickboxing(), "jump:up");
    for (const std::size_t row : {11u, 900u, 1700u})
        made.truth[row] = rare;
    const TrainingSet set(kickboxing(), made.features, made.examples(0, 2600), {});
    EXPECT_LE(set.examples().size(), 2010u);
    EXPECT_GE(set.examples().size(), 1990u);
    EXPECT_EQ(std::count_if(set.examples().begin(), set.examples().end(),
                            [&](const Example& example) { return example.label == rare; }),
              3);
    EXPECT_TRUE(std::is_sorted(set.examples().begin(), set.examples().end(),
                               [](const Example& a, const Example& b) { return a.row < b.row; }));
}

TEST(Reliability, RisesWithTheMarginAndTrustsFewAnswersLittle) {
    EXPECT_EQ(Reliability({}).at(3), 0.5);
    // Worked out by hand: the wrong one at 2 is pooled with the right one at 1.
    const std::vector<JudgedAnswer> answers = {
        {4, true}, {2, false}, {1, true}, {0, false}, {3, true}};
    const Reliability reliability(answers);
    EXPECT_DOUBLE_EQ(reliability.at(-5), 1.0 / 3) << "0 of 1";
    EXPECT_DOUBLE_EQ(reliability.at(0), 1.0 / 3);
    EXPECT_DOUBLE_EQ(reliability.at(1), 2.0 / 4) << "1 of 2";
    EXPECT_DOUBLE_EQ(reliability.at(2.5), 2.0 / 4);
    EXPECT_DOUBLE_EQ(reliability.at(3), 3.0 / 4) << "2 of 2";
    EXPECT_DOUBLE_EQ(reliability.at(100), 3.0 / 4);
}

TEST(Learner, TheHashKnowsExamplesSettingsAndParameters) {
    const MadeActions made(40);
    const auto examples = made.examples(0, 20);
    const ParameterSet parameters = defaultParameters(kickboxing());
    const std::string hash = trainingHash(made.features, examples, {}, parameters);
    EXPECT_EQ(trainingHash(made.features, examples, {}, parameters), hash);
    auto other = examples;
    other[3].label[0] = (other[3].label[0] + 1) % 5;
    EXPECT_NE(trainingHash(made.features, other, {}, parameters), hash);
    EXPECT_NE(trainingHash(made.features, made.examples(0, 19), {}, parameters), hash);
    LearningSettings settings;
    settings.mirrored = false;
    EXPECT_NE(trainingHash(made.features, examples, settings, parameters), hash);
}

TEST(StratifiedFolds, SpreadEveryClassEvenly) {
    std::vector<int> classes(103, 0);
    for (int i = 0; i < 20; ++i)
        classes[static_cast<std::size_t>(5 * i)] = 1;
    const auto folds = stratifiedFolds(classes, 5, 1);
    for (int fold = 0; fold < 5; ++fold) {
        int ones = 0, all = 0;
        for (std::size_t i = 0; i < classes.size(); ++i) {
            all += folds[i] == fold;
            ones += folds[i] == fold && classes[i] == 1;
        }
        EXPECT_EQ(ones, 4);
        EXPECT_NEAR(all, 20.6, 1);
    }
    EXPECT_NE(stratifiedFolds(classes, 5, 2), folds);
}

TEST(Queries, AskTheLeastCertainButNotTheSameTenTimes) {
    // Row 0 … 19 are copies of one uncertain action, 20 … 39 differ and are nearly as uncertain.
    MadeActions made(40, 1.0f);
    for (int i = 1; i < 20; ++i)
        made.features.row(i) = made.features.row(0);
    Predictions predictions{7, std::vector<Prediction>(7 * 40)};
    for (int i = 0; i < 40; ++i)
        predictions.at(i, 0) = {0, i < 20 ? 0.01 : 0.02, 0, false};
    QueryQueue queue(made.features, {10, 0.2, true, 0});
    const auto batch = queue.next(std::vector<bool>(40, false), &predictions);
    ASSERT_EQ(batch.size(), 10u);
    EXPECT_EQ(std::set<int>(batch.begin(), batch.end()).size(), 10u);
    EXPECT_EQ(std::count_if(batch.begin(), batch.end(), [](int row) { return row < 20; }), 1);
    // The certain are not asked while there are uncertain ones (but for exploration).
    for (int i = 20; i < 40; ++i)
        predictions.at(i, 0).margin = i == 33 ? 0.001 : 5.0;
    EXPECT_EQ(queue.next(std::vector<bool>(40, false), &predictions).front(), 33);
}

TEST(Queries, MarginsCountOnceEnoughIsLabelled) {
    const MadeActions made(80);
    Predictions predictions{7, std::vector<Prediction>(7 * 80)};
    for (int i = 0; i < 80; ++i)
        predictions.at(i, 0) = {0, i == 77 ? 0.01 : 3.0, 0, false};
    QueryQueue queue(made.features, {5, 0.2, true, 20});
    std::vector<bool> answered(80, false);
    const auto before = queue.next(answered, &predictions);
    EXPECT_EQ(before, queue.next(answered)) << "what stands for most, whatever the margins";
    std::fill(answered.begin(), answered.begin() + 20, true);
    EXPECT_EQ(queue.next(answered, &predictions).front(), 77);
}

TEST(Queries, NeverAskTwiceAndEndWhenAllIsAnswered) {
    const MadeActions made(23);
    QueryQueue queue(made.features, {10, 0.2, true, 0});
    std::vector<bool> answered(23, false);
    for (const std::size_t size : {10u, 10u, 3u, 0u}) {
        const auto batch = queue.next(answered);
        ASSERT_EQ(batch.size(), size);
        for (const int row : batch) {
            EXPECT_FALSE(answered[static_cast<std::size_t>(row)]);
            answered[static_cast<std::size_t>(row)] = true;
        }
    }
    EXPECT_TRUE(randomQueries(answered, 5, 1).empty());
}

TEST(Queries, AtRandomBySeed) {
    const std::vector<bool> open(100, false);
    EXPECT_EQ(randomQueries(open, 10, 5), randomQueries(open, 10, 5));
    EXPECT_NE(randomQueries(open, 10, 5), randomQueries(open, 10, 6));
}

TEST(Queries, StopWhenItIsGoodOrDoesNotGetBetter) {
    EXPECT_FALSE(mayStop({}));
    std::vector<double> good(10, 0.98);
    EXPECT_TRUE(mayStop(good));
    good.pop_back();
    EXPECT_FALSE(mayStop(good)) << "too early to tell";
    std::vector<double> rising;
    for (int i = 0; i < 30; ++i)
        rising.push_back(0.4 + 0.01 * i);
    EXPECT_FALSE(mayStop(rising));
    // It trembles by five percent around what it has reached.
    std::vector<double> level = rising;
    for (int i = 0; i < 10; ++i)
        level.push_back(i % 2 ? 0.74 : 0.64);
    EXPECT_FALSE(mayStop(level)) << "better than ten rounds ago";
    for (int i = 0; i < 10; ++i)
        level.push_back(i % 2 ? 0.74 : 0.64);
    EXPECT_TRUE(mayStop(level));
}

TEST(Scores, WorkedOutOnPaper) {
    const Vocabulary& v = kickboxing();
    const auto labels = [&](std::vector<std::string> texts) {
        std::vector<Label> list;
        for (const auto& text : texts)
            list.push_back(parseLabel(v, text + "+move:L-L"));
        return list;
    };
    const auto truth = labels({"left_punch:fwd", "left_punch:bwd", "right_kick:up", "jump:up",
                               "react:others", "react:others"});
    const auto answers = labels({"left_punch:fwd", "left_punch:fwd", "left_kick:up", "jump:up",
                                 "react:others", "left_punch:fwd"});
    const Scores scores = judge(v, truth, answers);
    EXPECT_DOUBLE_EQ(scores.labelAccuracy, 3.0 / 6);
    EXPECT_DOUBLE_EQ(scores.limbAccuracy, 2.0 / 3) << "the jump is no strike";
    EXPECT_DOUBLE_EQ(scores.baselineAccuracy, 2.0 / 6);
    EXPECT_DOUBLE_EQ(scores.aspects[0].accuracy, 4.0 / 6);
    // fwd: 1 hit, 2 false alarms: F1 = 2/4; bwd: 0; others: 3 hits, 1 missed: F1 = 6/7.
    EXPECT_DOUBLE_EQ(scores.aspects[0].macroF1, (0.5 + 0.0 + 6.0 / 7) / 3);
    EXPECT_EQ(scores.aspects[0].confusion[1][0], 1);
}

TEST(Scores, CohensKappa) {
    // 20 actions, both yes 10, both no 5, first only 3, second only 2.
    const JudgementTable table = {{5, 2}, {3, 10}};
    const double chance = 13.0 / 20 * 12 / 20 + 7.0 / 20 * 8 / 20;
    EXPECT_NEAR(*cohensKappa({{table}}), (0.75 - chance) / (1 - chance), 1e-12);
    EXPECT_EQ(cohensKappa({}), std::nullopt);
    EXPECT_EQ(cohensKappa({{JudgementTable{{0, 0}, {0, 0}}}}), std::nullopt);
    EXPECT_EQ(cohensKappa({{JudgementTable{{7, 0}, {0, 0}}}}), 1.0) << "the same single thing";
    // A second aspect of 10 actions: 6 and 3 the same, 1 differs; by chance 0.7 * 0.6 + 0.3 * 0.4.
    const JudgementTable second = {{6, 1}, {0, 3}};
    const double byChance = 20 * chance + 10 * (0.7 * 0.6 + 0.3 * 0.4);
    EXPECT_NEAR(*cohensKappa({{table, second}}), (15 + 9 - byChance) / (30 - byChance), 1e-12);
}

}  // namespace
}  // namespace kumite
