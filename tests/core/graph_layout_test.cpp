#include "core/interaction/graph_layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kumite {
namespace {

/// Two rings that one weak edge ties together.
LayoutGraph twoRings(int each) {
    LayoutGraph graph;
    for (int i = 0; i < 2 * each; ++i) {
        graph.nodes.push_back("label " + std::to_string(i));
        graph.weights.push_back(1 + i % 3);
        const int ring = i / each * each;
        graph.edges.push_back({i, ring + (i - ring + 1) % each, 1.0});
    }
    graph.edges.push_back({0, each, 0.01});
    return graph;
}

double distance(const GraphLayout& layout, int a, int b) {
    return (layout.places[std::size_t(a)] - layout.places[std::size_t(b)]).norm();
}

TEST(GraphLayout, NeighboursAreNearAndNobodyCoversAnother) {
    const LayoutGraph graph = twoRings(8);
    const GraphLayout layout = layOutGraph(graph);
    double near = 0;
    double far = 0;
    double nearest = 9;
    for (int i = 0; i < 8; ++i) {
        near += distance(layout, i, (i + 1) % 8) / 8;
        for (int j = 8; j < 16; ++j)
            far += distance(layout, i, j) / 64;
        for (int j = 0; j < i; ++j)
            nearest = std::min(nearest, distance(layout, i, j));
    }
    EXPECT_LT(near, 0.6 * far);
    EXPECT_GT(nearest, 0.1);
    for (const auto& place : layout.places)
        EXPECT_LE(place.norm(), 1 + 1e-9);
}

TEST(GraphLayout, IsTheSameEveryTime) {
    const LayoutGraph graph = twoRings(6);
    const GraphLayout a = layOutGraph(graph);
    const GraphLayout b = layOutGraph(graph);
    for (std::size_t i = 0; i < a.places.size(); ++i)
        EXPECT_EQ(a.places[i], b.places[i]);
}

TEST(GraphLayout, AnEditMovesNodesALittleOnly) {
    LayoutGraph graph = twoRings(8);
    const GraphLayout before = layOutGraph(graph);
    graph.nodes.insert(graph.nodes.begin(), "new");
    graph.weights.insert(graph.weights.begin(), 5);
    for (auto& edge : graph.edges) {
        ++edge.from;
        ++edge.to;
    }
    graph.edges.push_back({0, 1, 1.0});
    graph.edges.push_back({0, 2, 1.0});
    const GraphLayout after = layOutGraph(graph, &before);
    for (const std::string& node : before.nodes) {
        EXPECT_LE((*after.find(node) - *before.find(node)).norm(), kLayoutStep + 1e-9) << node;
    }
    const Eigen::Vector2d neighbours = 0.5 * (*after.find("label 0") + *after.find("label 1"));
    EXPECT_LT((*after.find("new") - neighbours).norm(), 0.35) << "it appears among its neighbours";
    EXPECT_EQ(after.find("nobody"), nullptr);
}

TEST(GraphLayout, OneNodeAndNodesWithoutEdgesAreNoTrouble) {
    EXPECT_TRUE(layOutGraph({}).places.empty());
    EXPECT_TRUE(layOutGraph({{"one"}, {1.0}, {{0, 0, 1.0}}}).places.front().allFinite());
    const GraphLayout layout = layOutGraph({{"a", "b", "c"}, {1, 1, 1}, {}});
    for (const auto& place : layout.places)
        EXPECT_TRUE(place.allFinite());
    EXPECT_GT(distance(layout, 0, 1), 0.3);
}

}  // namespace
}  // namespace kumite
