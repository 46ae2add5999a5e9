#include "core/interaction/row_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace kumite {
namespace {

TEST(RowOrder, PutsSimilarRowsBesideEachOtherAndEndsGroups) {
    Eigen::MatrixXd rows(5, 3);
    rows << 0.9, 0.1, 0.0,  //
        0.0, 0.1, 0.9,      //
        0.8, 0.2, 0.0,      //
        0.0, 0.2, 0.8,      //
        0.85, 0.15, 0.0;
    const RowOrder order = orderBySimilarity(rows);
    std::vector<int> left(order.order.begin(), order.order.begin() + 3);
    std::sort(left.begin(), left.end());
    EXPECT_EQ(left, (std::vector<int>{0, 2, 4}));
    ASSERT_EQ(order.joins.size(), 5U);
    for (const int inside : {1, 2, 4})
        EXPECT_LT(order.joins[std::size_t(inside)], 0.2) << inside;
    EXPECT_GT(order.joins[3], 0.7) << "the groups have little in common";
}

TEST(RowOrder, HoldsEveryRowOnceAndDoesNotDependOnTheOrderOfRows) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const int count = 40;
    Eigen::MatrixXd rows(count, 12);
    for (Eigen::Index i = 0; i < rows.size(); ++i)
        rows(i) = uniform(random);
    const RowOrder order = orderBySimilarity(rows);
    std::vector<int> sorted = order.order;
    std::sort(sorted.begin(), sorted.end());
    for (int i = 0; i < count; ++i)
        EXPECT_EQ(sorted[std::size_t(i)], i);

    const Eigen::MatrixXd turned = rows.colwise().reverse();
    const RowOrder other = orderBySimilarity(turned);
    // The same groups, maybe read from the other end.
    std::vector<int> back;
    for (const int row : other.order)
        back.push_back(count - 1 - row);
    const auto neighbours = [](const std::vector<int>& list) {
        std::vector<std::pair<int, int>> pairs;
        for (std::size_t i = 1; i < list.size(); ++i)
            pairs.push_back(std::minmax(list[i - 1], list[i]));
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    };
    EXPECT_EQ(neighbours(order.order), neighbours(back));
}

TEST(RowOrder, EmptyAndEqualRowsAreNoTrouble) {
    EXPECT_TRUE(orderBySimilarity(Eigen::MatrixXd(0, 4)).order.empty());
    EXPECT_EQ(orderBySimilarity(Eigen::MatrixXd::Zero(1, 4)).order, std::vector<int>{0});
    const RowOrder equal = orderBySimilarity(Eigen::MatrixXd::Zero(6, 4));
    EXPECT_EQ(equal.order.size(), 6U);
    for (std::size_t i = 1; i < equal.joins.size(); ++i)
        EXPECT_EQ(equal.joins[i], 0.0);
}

}  // namespace
}  // namespace kumite
