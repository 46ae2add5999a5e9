#include "core/transition/candidate_paths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace kumite {
namespace {

struct RandomGraph {
    int nodes = 0;
    std::vector<PathEdge> edges;

    explicit RandomGraph(std::mt19937& random, int most) {
        nodes = 2 + static_cast<int>(random() % static_cast<unsigned>(most - 1));
        const unsigned density = 10 + random() % 70;
        for (int i = 0; i < nodes; ++i) {
            for (int j = 0; j < nodes; ++j) {
                if (i != j && random() % 100 < density)
                    edges.push_back({i, j, 1 + (random() % 100000) / 777.0});
            }
        }
    }

    /// All loopless paths that cost less than `limit`, cheapest first.
    std::vector<CandidatePath> listed(int source, int target, double limit) const {
        std::vector<CandidatePath> all;
        CandidatePath path{0, {source}};
        const std::function<void()> walk = [&] {
            const int at = path.nodes.back();
            if (at == target) {
                if (path.cost < limit) all.push_back(path);
                return;
            }
            for (const PathEdge& e : edges) {
                if (e.source != at ||
                    std::find(path.nodes.begin(), path.nodes.end(), e.target) != path.nodes.end())
                    continue;
                path.nodes.push_back(e.target);
                path.cost += e.cost;
                walk();
                path.cost -= e.cost;
                path.nodes.pop_back();
            }
        };
        walk();
        std::sort(all.begin(), all.end(),
                  [](const auto& a, const auto& b) { return a.cost < b.cost; });
        return all;
    }
};

TEST(CandidatePaths, TheCheapestOfAllThatThereAre) {
    std::mt19937 random(11);
    int compared = 0;
    for (int trial = 0; trial < 120; ++trial) {
        const RandomGraph graph(random, 7);
        const double limit = trial % 3 == 0 ? 200 : 1e9;
        const int count = 1 + trial % 8;
        PathSearch search(graph.nodes, graph.edges, {count, limit});
        for (int target = 0; target < graph.nodes; ++target) {
            for (int source = 0; source < graph.nodes; ++source) {
                if (source == target) continue;
                const auto all = graph.listed(source, target, limit);
                const auto found = search.paths(source, target);
                ASSERT_EQ(found.size(), std::min(all.size(), static_cast<std::size_t>(count)));
                for (std::size_t i = 0; i < found.size(); ++i) {
                    ASSERT_NEAR(found[i].cost, all[i].cost, 1e-9);
                    ASSERT_EQ(found[i].nodes, all[i].nodes);
                    ++compared;
                }
                if (all.empty()) continue;
                ASSERT_NEAR(search.cheapest(source, target), all[0].cost, 1e-9);
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(CandidatePaths, EqualCostsAreAllFound) {
    // Four ways of the same cost through a ladder of diamonds.
    std::vector<PathEdge> edges;
    for (const int base : {0, 3}) {
        for (const int middle : {base + 1, base + 2}) {
            edges.push_back({base, middle, 1});
            edges.push_back({middle, base + 3, 1});
        }
    }
    const std::vector<CandidatePath> found = PathSearch(7, edges, {}).paths(0, 6);
    ASSERT_EQ(found.size(), 4u);
    for (const CandidatePath& path : found)
        EXPECT_EQ(path.cost, 4);
    EXPECT_EQ(found, PathSearch(7, edges, {}).paths(0, 6));
    std::set<std::vector<int>> different;
    for (const CandidatePath& path : found)
        different.insert(path.nodes);
    EXPECT_EQ(different.size(), 4u);
}

TEST(CandidatePaths, UnreachableAndSame) {
    PathSearch search(3, {{0, 1, 2.5}}, {});
    EXPECT_TRUE(search.paths(1, 0).empty());
    EXPECT_TRUE(search.paths(0, 2).empty());
    EXPECT_TRUE(std::isinf(search.cheapest(2, 0)));
    EXPECT_EQ(search.paths(0, 1), (std::vector<CandidatePath>{{2.5, {0, 1}}}));
    EXPECT_EQ(search.paths(2, 2), (std::vector<CandidatePath>{{0, {2}}}));
    PathSearch limited(3, {{0, 1, 2.5}}, {5, 2.5});
    EXPECT_TRUE(limited.paths(0, 1).empty());
}

}  // namespace
}  // namespace kumite
