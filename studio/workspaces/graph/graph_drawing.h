#pragma once

#include <array>
#include <memory>
#include <vector>

#include "studio/view3d/graph_scene.h"
#include "studio/workspaces/graph/graph_session.h"

namespace kumite::studio {

struct Colours;

/// Which edges of the coupled graph are drawn, and where its nodes are.
struct DrawingOptions {
    bool inSpace = false;     ///< both graphs one behind the other, else side by side
    bool crossEdges = false;  ///< also from the opponent's labels to what is done next
    /// Where two are compared: only what one side does more often than the other, as wide as the
    /// difference.
    bool difference = false;
    double least = 0;   ///< probability (or difference) from which on an edge is drawn
    int most = 3;       ///< how many edges leave a node at most, the likeliest first
    double aspect = 1;  ///< of the picture, width over height: side by side fills it
};

/// The coupled graph as a drawing, and what its nodes and edges mean. Two graphs stand in it: the
/// fighters', or the mover's by each of two models.
struct GraphDrawing {
    struct NodeRef {
        int side = 0;
        int player = 0;
        int node = 0;  ///< of the side's graph
    };
    struct EdgeRef {
        int side = 0;
        GraphSelection meaning;  ///< in the side's graph
        double probability = 0;  ///< or difference
    };
    GraphScene scene;
    std::vector<NodeRef> nodes;  ///< of scene.nodes
    std::vector<EdgeRef> edges;  ///< of scene.edges
    std::array<GraphSide, 2> sides;
    std::shared_ptr<const GraphValues> values;  ///< what the sides are part of
};

/// Only edges that were seen are drawn. What is selected stands out with its neighbours, and all
/// edges that touch it are drawn whatever `most` says.
GraphDrawing drawGraph(const GraphSession& graph, const DrawingOptions& options,
                       const Colours& colours);

}  // namespace kumite::studio
