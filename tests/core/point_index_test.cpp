// The nearest points, as looking at all of them gives.
#include "core/editing/point_index.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace kumite {
namespace {

using Eigen::Vector3d;

TEST(PointIndex, FindsWhatLookingAtAllFinds) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> draw(-6, 6);  // few values: many ties
    const auto point = [&] { return Vector3d(draw(random), draw(random), draw(random)); };
    for (const int size : {1, 2, 3, 7, 300}) {
        std::vector<Vector3d> points;
        for (int i = 0; i < size; ++i)
            points.push_back(point());
        const PointIndex index(points);
        for (int query = 0; query < 50; ++query) {
            const Vector3d place = point() + Vector3d(0.25, 0, 0);
            std::vector<std::pair<double, int>> all;
            for (int i = 0; i < size; ++i)
                all.emplace_back((points[std::size_t(i)] - place).squaredNorm(), i);
            std::sort(all.begin(), all.end());
            const auto found = index.nearest(place, 5);
            ASSERT_EQ(found.size(), std::min<std::size_t>(5, points.size()));
            for (std::size_t i = 0; i < found.size(); ++i)
                EXPECT_EQ(found[i], all[i].second);
        }
    }
}

TEST(PointIndex, OfNothingFindsNothing) {
    EXPECT_TRUE(PointIndex{}.nearest({0, 0, 0}, 3).empty());
    EXPECT_TRUE(PointIndex({Vector3d::Zero()}).nearest({0, 0, 0}, 0).empty());
}

}  // namespace
}  // namespace kumite
