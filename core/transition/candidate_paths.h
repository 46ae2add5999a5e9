#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/transition/transition_graph.h"

namespace kumite {

/// A way through the graph that visits no node twice, and the sum of its edges' costs.
struct CandidatePath {
    double cost = 0;
    std::vector<int> nodes;  ///< source first, target last

    bool operator==(const CandidatePath&) const = default;
};

struct PathSettings {
    int count = 5;                                           ///< paths per pair, at most
    double limit = std::numeric_limits<double>::infinity();  ///< paths cost less

    bool operator==(const PathSettings&) const = default;
};

/// An edge as path finding sees it; costs are positive.
struct PathEdge {
    int source = 0;
    int target = 0;
    double cost = 0;
};

/// Finds the cheapest loopless paths between any two nodes: Yen's algorithm (1971) with Lawler's
/// rule, made quick by one tree of cheapest ways to the target, found once and shared by all
/// sources. A deviation whose best continuation follows that tree without a loop needs no search;
/// any other gets a lower bound from the tree and is searched (A* with the tree as its estimate)
/// only if that bound comes up among the cheapest. Exact. The tree reaches as far as the limit.
/// One object per thread; copies share the graph.
class PathSearch {
public:
    PathSearch(int nodeCount, const std::vector<PathEdge>& edges, PathSettings settings);
    PathSearch(const TransitionGraph& graph, PathSettings settings);

    /// The cheapest paths, cheapest first (equal costs: by their nodes). From a node to itself
    /// there is one, which stays there and costs nothing. The tree of the last target is kept: ask
    /// target by target.
    std::vector<CandidatePath> paths(int source, int target);

    /// Cost of the cheapest path; infinity where there is none under the limit.
    double cheapest(int source, int target);

private:
    struct Arcs;
    struct Candidate;
    void growTree(int target);
    Candidate deviation(const std::vector<int>& path, std::size_t spur, double costBefore,
                        const std::vector<CandidatePath>& found);
    bool complete(Candidate& candidate);

    std::shared_ptr<const Arcs> arcs_;
    PathSettings settings_;
    int target_ = -1;
    std::vector<double> toTarget_;  ///< cheapest cost from each node
    std::vector<int> next_;         ///< the node after it on that way
    // Scratch: a stamp says that an entry belongs to the search in progress.
    std::vector<std::uint32_t> onPrefix_, reached_;
    std::vector<double> reachedCost_;
    std::vector<int> before_;
    std::uint32_t prefixStamp_ = 0, searchStamp_ = 0;
};

/// What all pairs of different nodes have.
struct PathSummary {
    std::size_t pairs = 0;
    std::size_t pairsWithPath = 0;
    std::size_t paths = 0;
    std::size_t visitedNodes = 0;  ///< in all paths together: what storing them would take
    double share() const { return pairs ? double(pairsWithPath) / double(pairs) : 0; }
};

/// Finds the candidate paths of every ordered pair and hands them to `use`, which may be called
/// from several threads at once, but for one target from one thread, in the order of sources. On
/// all cores; cancellable.
PathSummary findAllPaths(
    const TransitionGraph& graph, const PathSettings& settings,
    const std::function<void(int source, int target, const std::vector<CandidatePath>&)>& use,
    const Progress& progress = {});

/// A limit beyond which paths are bad transitions, in the graph's own measure: `edges` times the
/// median cost of an edge. 0 for a graph without edges.
double pathLimit(const TransitionGraph& graph, double edges);

}  // namespace kumite
