#pragma once

#include <span>
#include <vector>

#include "core/base/frame_range.h"
#include "core/transition/pose_clusters.h"

namespace kumite {

/// Frames of a motion that follow each other in one cluster: what the paper calls a clip of a node.
struct ClusterRun {
    int motion = 0;
    FrameRange frames;
    int cluster = 0;

    bool operator==(const ClusterRun&) const = default;
};

/// All runs, in the order of motions and frames.
std::vector<ClusterRun> clusterRuns(const PoseClusters& clusters);

/// Frames that lead from one cluster to another: two neighbouring runs joined, perhaps played from
/// the last frame to the first.
struct EdgeClip {
    int motion = 0;
    FrameRange frames;
    bool backward = false;

    int firstFrame() const { return backward ? frames.end - 1 : frames.begin; }
    int lastFrame() const { return backward ? frames.begin : frames.end - 1; }
    bool operator==(const EdgeClip&) const = default;
};

struct GraphEdge {
    int source = 0;
    int target = 0;
    double distance = 0;  ///< between the two centres
    double cost = 0;  ///< frames of the shortest clip × distance (paper B, equation 1), above 0
    std::vector<EdgeClip> clips;  ///< in the order of motions and frames, forward ones first

    int shortest() const;  ///< frames of the shortest clip
};

/// How frames of different clusters follow each other (paper B, "Build the Transition Graph").
/// Nodes are the clusters.
struct TransitionGraph {
    bool undirected = false;
    int nodeCount = 0;
    std::vector<ClusterRun> runs;
    std::vector<GraphEdge> edges;  ///< by source, then target
    std::vector<int> firstEdge;    ///< of each node; one more at the end

    std::span<const GraphEdge> edgesFrom(int node) const;
    const GraphEdge* find(int source, int target) const;  ///< null where there is none
};

/// `undirected`: every edge also runs the other way, its clips played backward (short transitions
/// stay natural, says the paper). A cost of 0 is raised to the smallest positive one.
TransitionGraph buildTransitionGraph(const PoseClusters& clusters, bool undirected);

}  // namespace kumite
