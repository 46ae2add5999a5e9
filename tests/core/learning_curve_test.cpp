#include "core/labelling/learning_curve.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/labelling/distances.h"
#include "tests/support/made_actions.h"

namespace kumite {
namespace {

using test::MadeActions;

OrderCurves curvesOf(const MadeActions& made, int count, const Progress& progress = {}) {
    return orderCurves(kickboxing(), made.features, made.examples(0, count), {},
                       defaultParameters(kickboxing()), progress);
}

TEST(OrderCurves, AskingIsAheadWhereMostActionsAreOfOneKind) {
    const MadeActions made(100, 1.0f);
    const OrderCurves curves = curvesOf(made, 100);
    EXPECT_EQ(curves.examples, 100);
    ASSERT_GE(curves.points.size(), 5u);
    double asked = 0, random = 0;
    int before = 0;
    for (const OrderPoint& point : curves.points) {
        EXPECT_GT(point.labelled, before);
        before = point.labelled;
        EXPECT_GE(point.asked, 0);
        EXPECT_LE(point.asked, 1);
        asked += point.asked;
        random += point.random;
    }
    EXPECT_LE(before, 80) << "a fifth is held out";
    EXPECT_GT(asked, random);
    const auto gain = orderGain(curves);
    ASSERT_TRUE(gain);
    EXPECT_LT(gain->asked, gain->random);
    // With everything labelled both orders are the same machines.
    EXPECT_NEAR(curves.points.back().asked, curves.points.back().random, 0.03);
}

TEST(OrderCurves, AreDeterministicNeedSomeLabelsAndCanBeCancelled) {
    const MadeActions made(40, 2.0f);
    const OrderCurves first = curvesOf(made, 30);
    const OrderCurves second = curvesOf(made, 30);
    ASSERT_EQ(first.points.size(), second.points.size());
    for (std::size_t i = 0; i < first.points.size(); ++i) {
        EXPECT_EQ(first.points[i].asked, second.points[i].asked);
        EXPECT_EQ(first.points[i].random, second.points[i].random);
    }
    EXPECT_TRUE(curvesOf(made, kFewestForCurves - 1).points.empty());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(curvesOf(made, 30, {{}, stop.get_token()}), Cancelled);
}

TEST(OrderCurves, GainIsReadFromTheFarthestPoint) {
    OrderCurves curves;
    curves.points = {{5, 0.5, 0.4}, {10, 0.8, 0.5}, {15, 0.85, 0.7}, {20, 0.85, 0.8}};
    EXPECT_EQ(orderGain(curves)->asked, 10);
    EXPECT_EQ(orderGain(curves)->random, 20);
    curves.points = {{5, 0.3, 0.4}, {10, 0.4, 0.5}};
    EXPECT_FALSE(orderGain(curves));
    EXPECT_FALSE(orderGain({}));
}

TEST(CrossValidation, AnswersEveryExampleByAMachineThatHadNotSeenIt) {
    const MadeActions made(60);
    auto examples = made.examples(0, 60);
    // One example with a label of its own kind cannot be found by machines without it.
    examples[7].label = parseLabel(kickboxing(), "jump:down");
    const ParameterSet parameters = defaultParameters(kickboxing());
    const TrainingSet set(kickboxing(), made.features, examples, {});
    const std::vector<Label> answers = set.crossValidate(parameters);
    ASSERT_EQ(answers.size(), 60u);
    EXPECT_NE(answers[7][4], examples[7].label[4]);
    int right = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        right += learntAspectsMatch(kickboxing(), examples[i].label, answers[i]);
        EXPECT_EQ(answers[i][6], kUnknown) << "rules are not learnt";
    }
    EXPECT_DOUBLE_EQ(right / 60.0, set.expectedAccuracy(parameters, set.predict(parameters, false)))
        << "no row is left that no hand labelled";
}

TEST(ActionDistances, NearestFirstAlsoInTheMirror) {
    const MadeActions made(60, 0.3f, 5, {"others", "left_kick:up", "right_kick:up", "jump:up"});
    const ActionDistances mirrored(made.features, true);
    const ActionDistances plain(made.features, false);
    for (int row = 1; row < 60; row += 2) {
        const auto near = mirrored.nearest(row, 2);
        ASSERT_EQ(near.size(), 2u);
        for (std::size_t i = 0; i < near.size(); ++i) {
            EXPECT_NE(near[i].row, row);
            EXPECT_GE(near[i].distance, near[0].distance);
            const Label& label = made.truth[static_cast<std::size_t>(near[i].row)];
            const Label& own = made.truth[static_cast<std::size_t>(row)];
            EXPECT_EQ(near[i].mirrored ? mirroredLabel(kickboxing(), label) : label, own);
        }
        for (const auto& each : plain.nearest(row, 1))
            EXPECT_EQ(made.truth[static_cast<std::size_t>(each.row)],
                      made.truth[static_cast<std::size_t>(row)]);
    }
    EXPECT_EQ(plain.nearest(0, 500).size(), 59u);
    const double distance = plain.nearest(0, 1).front().distance;
    const int nearest = plain.nearest(0, 1).front().row;
    EXPECT_NEAR(plain.squaredTo(0)[static_cast<std::size_t>(nearest)],
                distance * distance * kFeatureCount, 1e-2);
}

}  // namespace
}  // namespace kumite
