#include "core/transition/transition_graph.h"

#include <algorithm>
#include <limits>
#include <map>

namespace kumite {
namespace {

void addCosts(const PoseTree& centres, std::vector<GraphEdge>& edges) {
    double smallest = std::numeric_limits<double>::infinity();
    for (GraphEdge& edge : edges) {
        edge.distance = metricDistance(centres.shape(), centres.points().at(edge.source),
                                       centres.points().at(edge.target));
        edge.cost = edge.shortest() * edge.distance;
        if (edge.cost > 0) smallest = std::min(smallest, edge.cost);
    }
    for (GraphEdge& edge : edges) {
        if (edge.cost == 0) edge.cost = std::min(smallest, 1.0);
    }
}

}  // namespace

int GraphEdge::shortest() const {
    int frames = std::numeric_limits<int>::max();
    for (const EdgeClip& clip : clips)
        frames = std::min(frames, clip.frames.size());
    return frames;
}

std::span<const GraphEdge> TransitionGraph::edgesFrom(int node) const {
    const auto begin = static_cast<std::size_t>(firstEdge[static_cast<std::size_t>(node)]);
    const auto end = static_cast<std::size_t>(firstEdge[static_cast<std::size_t>(node) + 1]);
    return {edges.data() + begin, end - begin};
}

const GraphEdge* TransitionGraph::find(int source, int target) const {
    for (const GraphEdge& edge : edgesFrom(source)) {
        if (edge.target == target) return &edge;
    }
    return nullptr;
}

std::vector<ClusterRun> clusterRuns(const PoseClusters& clusters) {
    std::vector<ClusterRun> runs;
    for (std::size_t m = 0; m < clusters.ids.size(); ++m) {
        const std::vector<int>& ids = clusters.ids[m];
        for (int frame = 0; frame < static_cast<int>(ids.size()); ++frame) {
            const int id = ids[static_cast<std::size_t>(frame)];
            if (frame > 0 && runs.back().cluster == id) {
                ++runs.back().frames.end;
            } else {
                runs.push_back({static_cast<int>(m), {frame, frame + 1}, id});
            }
        }
    }
    return runs;
}

TransitionGraph buildTransitionGraph(const PoseClusters& clusters, bool undirected) {
    TransitionGraph graph;
    graph.undirected = undirected;
    graph.nodeCount = clusters.count();
    graph.runs = clusterRuns(clusters);
    std::map<std::pair<int, int>, std::vector<EdgeClip>> clips;
    const auto collect = [&](bool backward) {
        for (std::size_t i = 1; i < graph.runs.size(); ++i) {
            const ClusterRun& a = graph.runs[i - 1];
            const ClusterRun& b = graph.runs[i];
            if (a.motion != b.motion) continue;
            const auto ends =
                backward ? std::pair(b.cluster, a.cluster) : std::pair(a.cluster, b.cluster);
            clips[ends].push_back({a.motion, {a.frames.begin, b.frames.end}, backward});
        }
    };
    collect(false);
    if (undirected) collect(true);
    graph.firstEdge.assign(static_cast<std::size_t>(graph.nodeCount) + 1, 0);
    for (auto& [ends, list] : clips) {
        graph.edges.push_back({ends.first, ends.second, 0, 0, std::move(list)});
        ++graph.firstEdge[static_cast<std::size_t>(ends.first) + 1];
    }
    for (std::size_t i = 1; i < graph.firstEdge.size(); ++i)
        graph.firstEdge[i] += graph.firstEdge[i - 1];
    addCosts(clusters.centres, graph.edges);
    return graph;
}

}  // namespace kumite
