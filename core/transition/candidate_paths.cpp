#include "core/transition/candidate_paths.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <queue>
#include <set>

#include "core/base/parallel.h"

namespace kumite {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A node in a queue of nodes to be settled, cheapest first.
struct Queued {
    double cost;
    int node;
    bool operator>(const Queued& other) const {
        return cost != other.cost ? cost > other.cost : node > other.node;
    }
};
using NodeQueue = std::priority_queue<Queued, std::vector<Queued>, std::greater<>>;

}  // namespace

/// The edges in rows, both ways.
struct PathSearch::Arcs {
    struct Arc {
        int node;
        double cost;
    };
    std::vector<int> firstOut, firstIn;
    std::vector<Arc> out, in;

    std::span<const Arc> from(int node) const { return row(firstOut, out, node); }
    std::span<const Arc> into(int node) const { return row(firstIn, in, node); }

    static std::span<const Arc> row(const std::vector<int>& first, const std::vector<Arc>& arcs,
                                    int node) {
        const auto begin = static_cast<std::size_t>(first[static_cast<std::size_t>(node)]);
        const auto end = static_cast<std::size_t>(first[static_cast<std::size_t>(node) + 1]);
        return {arcs.data() + begin, end - begin};
    }
};

/// A path, or a promise of one: `nodes` up to the spur are certain. Its rest is what the tree says,
/// or still has to be searched, then `cost` is a lower bound.
struct PathSearch::Candidate {
    double cost = kNever;
    bool exact = false;
    std::size_t spur = 0;  ///< index of the node where it leaves the path that it came from
    std::vector<int> nodes;
    std::vector<int> banned;  ///< nodes that may not follow the spur
    double costBefore = 0;    ///< of the way to the spur

    bool operator<(const Candidate& other) const {
        if (cost != other.cost) return cost < other.cost;
        if (exact != other.exact) return !exact;  // so that equal paths come in the order of nodes
        return nodes < other.nodes;
    }
};

PathSearch::PathSearch(int nodeCount, const std::vector<PathEdge>& edges, PathSettings settings)
    : settings_(settings) {
    const auto n = static_cast<std::size_t>(nodeCount);
    auto arcs = std::make_shared<Arcs>();
    const auto rows = [&](std::vector<int>& first, std::vector<Arcs::Arc>& list, bool forward) {
        first.assign(n + 1, 0);
        for (const PathEdge& e : edges)
            ++first[static_cast<std::size_t>(forward ? e.source : e.target) + 1];
        for (std::size_t i = 1; i <= n; ++i)
            first[i] += first[i - 1];
        list.resize(edges.size());
        std::vector<int> at(first.begin(), first.end() - 1);
        for (const PathEdge& e : edges) {
            assert(e.cost > 0);
            int& slot = at[static_cast<std::size_t>(forward ? e.source : e.target)];
            list[static_cast<std::size_t>(slot++)] = {forward ? e.target : e.source, e.cost};
        }
    };
    rows(arcs->firstOut, arcs->out, true);
    rows(arcs->firstIn, arcs->in, false);
    arcs_ = std::move(arcs);
    onPrefix_.assign(n, 0);
    reached_.assign(n, 0);
    reachedCost_.resize(n);
    before_.resize(n);
}

PathSearch::PathSearch(const TransitionGraph& graph, PathSettings settings)
    : PathSearch(
          graph.nodeCount,
          [&] {
              std::vector<PathEdge> edges;
              edges.reserve(graph.edges.size());
              for (const GraphEdge& edge : graph.edges)
                  edges.push_back({edge.source, edge.target, edge.cost});
              return edges;
          }(),
          settings) {}

void PathSearch::growTree(int target) {
    if (target == target_) return;
    target_ = target;
    toTarget_.assign(onPrefix_.size(), kNever);
    next_.assign(onPrefix_.size(), -1);
    toTarget_[static_cast<std::size_t>(target)] = 0;
    NodeQueue queue;
    queue.push({0, target});
    while (!queue.empty()) {
        const Queued top = queue.top();
        queue.pop();
        if (top.cost > toTarget_[static_cast<std::size_t>(top.node)]) continue;
        for (const Arcs::Arc& arc : arcs_->into(top.node)) {
            const double cost = top.cost + arc.cost;
            double& known = toTarget_[static_cast<std::size_t>(arc.node)];
            if (cost >= known || cost >= settings_.limit) continue;
            known = cost;
            next_[static_cast<std::size_t>(arc.node)] = top.node;
            queue.push({cost, arc.node});
        }
    }
}

/// The cheapest way that leaves `path` at index `spur` by an edge that no path found so far takes
/// there.
PathSearch::Candidate PathSearch::deviation(const std::vector<int>& path, std::size_t spur,
                                            double costBefore,
                                            const std::vector<CandidatePath>& found) {
    Candidate candidate;
    candidate.spur = spur;
    candidate.costBefore = costBefore;
    const auto prefixEnd = path.begin() + static_cast<std::ptrdiff_t>(spur) + 1;
    candidate.nodes.assign(path.begin(), prefixEnd);
    for (const CandidatePath& other : found) {
        if (other.nodes.size() > spur + 1 &&
            std::equal(path.begin(), prefixEnd, other.nodes.begin()))
            candidate.banned.push_back(other.nodes[spur + 1]);
    }
    ++prefixStamp_;
    for (const int node : candidate.nodes)
        onPrefix_[static_cast<std::size_t>(node)] = prefixStamp_;
    int first = -1;
    for (const Arcs::Arc& arc : arcs_->from(path[spur])) {
        if (onPrefix_[static_cast<std::size_t>(arc.node)] == prefixStamp_) continue;
        const double cost = costBefore + arc.cost + toTarget_[static_cast<std::size_t>(arc.node)];
        if (cost >= candidate.cost) continue;
        if (std::find(candidate.banned.begin(), candidate.banned.end(), arc.node) !=
            candidate.banned.end())
            continue;
        candidate.cost = cost;
        first = arc.node;
    }
    if (candidate.cost >= settings_.limit) candidate.cost = kNever;
    if (candidate.cost == kNever) return candidate;
    const std::size_t certain = candidate.nodes.size();
    for (int node = first; node >= 0; node = next_[static_cast<std::size_t>(node)]) {
        if (onPrefix_[static_cast<std::size_t>(node)] == prefixStamp_) {
            candidate.nodes.resize(certain);
            return candidate;  // the tree leads back: only a lower bound
        }
        candidate.nodes.push_back(node);
    }
    candidate.exact = true;
    return candidate;
}

/// Makes a promise a path, or finds that there is none.
bool PathSearch::complete(Candidate& candidate) {
    ++prefixStamp_;
    for (const int node : candidate.nodes)
        onPrefix_[static_cast<std::size_t>(node)] = prefixStamp_;
    ++searchStamp_;
    NodeQueue queue;
    const auto reach = [&](int node, int from, double cost) {
        const auto i = static_cast<std::size_t>(node);
        const double whole = cost + toTarget_[i];
        if (onPrefix_[i] == prefixStamp_ || !(whole < settings_.limit)) return;
        if (reached_[i] == searchStamp_ && reachedCost_[i] <= cost) return;
        reached_[i] = searchStamp_;
        reachedCost_[i] = cost;
        before_[i] = from;
        queue.push({whole, node});
    };
    const int spur = candidate.nodes.back();
    for (const Arcs::Arc& arc : arcs_->from(spur)) {
        if (std::find(candidate.banned.begin(), candidate.banned.end(), arc.node) ==
            candidate.banned.end())
            reach(arc.node, spur, candidate.costBefore + arc.cost);
    }
    while (!queue.empty()) {
        const Queued top = queue.top();
        queue.pop();
        const auto i = static_cast<std::size_t>(top.node);
        if (top.cost > reachedCost_[i] + toTarget_[i]) continue;
        if (top.node == target_) {
            candidate.cost = reachedCost_[i];
            candidate.exact = true;
            const std::size_t certain = candidate.nodes.size();
            for (int node = target_; node != spur; node = before_[static_cast<std::size_t>(node)])
                candidate.nodes.push_back(node);
            std::reverse(candidate.nodes.begin() + static_cast<std::ptrdiff_t>(certain),
                         candidate.nodes.end());
            return true;
        }
        for (const Arcs::Arc& arc : arcs_->from(top.node))
            reach(arc.node, top.node, reachedCost_[i] + arc.cost);
    }
    return false;
}

std::vector<CandidatePath> PathSearch::paths(int source, int target) {
    if (source == target) return {{0, {source}}};
    growTree(target);
    std::vector<CandidatePath> found;
    std::set<Candidate> open;
    const auto offer = [&](Candidate candidate) {
        if (candidate.cost < kNever) open.insert(std::move(candidate));
    };
    offer(deviation({source}, 0, 0, {}));
    while (!open.empty() && static_cast<int>(found.size()) < settings_.count) {
        Candidate best = std::move(open.extract(open.begin()).value());
        if (!best.exact) {
            if (complete(best)) offer(std::move(best));
            continue;
        }
        found.push_back({best.cost, best.nodes});
        if (static_cast<int>(found.size()) == settings_.count) break;
        double cost = best.costBefore;
        for (std::size_t spur = best.spur; spur + 1 < best.nodes.size(); ++spur) {
            offer(deviation(best.nodes, spur, cost, found));
            for (const Arcs::Arc& arc : arcs_->from(best.nodes[spur])) {
                if (arc.node == best.nodes[spur + 1]) cost += arc.cost;
            }
        }
    }
    return found;
}

double PathSearch::cheapest(int source, int target) {
    growTree(target);
    return toTarget_[static_cast<std::size_t>(source)];
}

PathSummary findAllPaths(
    const TransitionGraph& graph, const PathSettings& settings,
    const std::function<void(int, int, const std::vector<CandidatePath>&)>& use,
    const Progress& progress) {
    const PathSearch search(graph, settings);
    std::vector<PathSummary> parts(static_cast<std::size_t>(graph.nodeCount));
    std::atomic<int> done{0};
    forBlocks({0, graph.nodeCount}, 8, [&](FrameRange targets) {
        PathSearch own = search;
        for (int target = targets.begin; target < targets.end; ++target) {
            PathSummary& part = parts[static_cast<std::size_t>(target)];
            for (int source = 0; source < graph.nodeCount; ++source) {
                if (source == target) continue;
                const std::vector<CandidatePath> paths = own.paths(source, target);
                ++part.pairs;
                part.pairsWithPath += !paths.empty();
                part.paths += paths.size();
                for (const CandidatePath& path : paths)
                    part.visitedNodes += path.nodes.size();
                if (use) use(source, target, paths);
            }
            progress.update(static_cast<double>(++done) / graph.nodeCount);
        }
    });
    PathSummary sum;
    for (const PathSummary& part : parts) {
        sum.pairs += part.pairs;
        sum.pairsWithPath += part.pairsWithPath;
        sum.paths += part.paths;
        sum.visitedNodes += part.visitedNodes;
    }
    return sum;
}

double pathLimit(const TransitionGraph& graph, double edges) {
    if (graph.edges.empty()) return 0;
    std::vector<double> costs;
    costs.reserve(graph.edges.size());
    for (const GraphEdge& edge : graph.edges)
        costs.push_back(edge.cost);
    const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
    std::nth_element(costs.begin(), middle, costs.end());
    return edges * *middle;
}

}  // namespace kumite
