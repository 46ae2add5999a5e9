// Clusters in the plane: distances are kept where a plane can keep them.

#include "core/transition/cluster_places.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace kumite {
namespace {

PoseClusters clustersAt(const std::vector<std::array<double, 3>>& points) {
    PoseClusters clusters;
    clusters.centres = PoseTree(MetricShape{3, {}});
    for (const auto& point : points)
        clusters.centres.add(point.data());
    return clusters;
}

TEST(ClusterPlaces, KeepDistancesOfWhatLiesInAPlane) {
    // Points of a tilted plane.
    std::vector<std::array<double, 3>> points;
    for (const auto& [u, v] :
         {std::pair{0.0, 0.0}, {3.0, 0.0}, {0.0, 1.0}, {3.0, 1.0}, {-2.0, 0.5}, {1.0, -1.0}})
        points.push_back({0.6 * u, v, 0.8 * u});
    const auto places = clusterPlaces(clustersAt(points));
    ASSERT_EQ(places.size(), points.size());
    const auto distance = [&](std::size_t a, std::size_t b) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            sum += (points[a][k] - points[b][k]) * (points[a][k] - points[b][k]);
        return std::sqrt(sum);
    };
    const double scale = (places[0] - places[1]).norm() / distance(0, 1);
    double farthest = 0;
    for (std::size_t a = 0; a < points.size(); ++a) {
        farthest = std::max(farthest, places[a].norm());
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_NEAR((places[a] - places[b]).norm(), scale * distance(a, b), 1e-6);
    }
    EXPECT_NEAR(farthest, 1, 1e-12);
}

TEST(ClusterPlaces, MoreThanAreSolvedForLieBesideTheNearest) {
    const auto places =
        clusterPlaces(clustersAt({{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {3.9, 0.1, 0}}), 3);
    EXPECT_EQ(places[3], places[1]);
    EXPECT_NE(places[0], places[1]);
}

TEST(ClusterPlaces, NoneOneAndEqualOnes) {
    EXPECT_TRUE(clusterPlaces(clustersAt({})).empty());
    EXPECT_EQ(clusterPlaces(clustersAt({{1, 2, 3}})).front(), Eigen::Vector2d::Zero());
    for (const Eigen::Vector2d& place : clusterPlaces(clustersAt({{1, 2, 3}, {1, 2, 3}})))
        EXPECT_EQ(place, Eigen::Vector2d::Zero());
}

}  // namespace
}  // namespace kumite
