#pragma once

#include <vector>

#include "studio/view3d/graph_scene.h"
#include "studio/workspaces/graph/graph_session.h"

namespace kumite::studio {

struct Colours;

/// Which edges of the coupled graph are drawn, and where its nodes are.
struct DrawingOptions {
    bool inSpace = false;     ///< the fighters' graphs one behind the other, else side by side
    bool crossEdges = false;  ///< also from the opponent's labels to what is done next
    double least = 0;         ///< probability from which on an edge is drawn
    int most = 3;             ///< how many edges leave a node at most, the likeliest first
    bool upright = false;     ///< side by side means one above the other
};

/// The coupled graph as a drawing, and what its nodes and edges mean.
struct GraphDrawing {
    struct NodeRef {
        int player = 0;
        int node = 0;
    };
    GraphScene scene;
    std::vector<NodeRef> nodes;         ///< of scene.nodes
    std::vector<GraphSelection> edges;  ///< of scene.edges
    std::vector<double> probabilities;  ///< of scene.edges
};

/// Only edges that were seen are drawn. What is selected stands out with its neighbours, and all
/// edges that touch it are drawn whatever `most` says; `name` gives the text of a node.
GraphDrawing drawGraph(const GraphSession& graph, const DrawingOptions& options,
                       const Colours& colours);

}  // namespace kumite::studio
