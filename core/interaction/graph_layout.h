#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace kumite {

struct CoupledGraph;

/// A graph to be drawn: nodes are known again by their names.
struct LayoutGraph {
    struct Edge {
        int from = 0;
        int to = 0;
        double weight = 0;  ///< how strongly it draws its ends together, above 0
    };
    std::vector<std::string> nodes;
    std::vector<double> weights;  ///< of the nodes; the heaviest start in the middle
    std::vector<Edge> edges;
};

/// Both fighters' graphs as one, so that a label has the same place in either: nodes by the text of
/// their labels, weighed by their actions; edges by what follows on what, and on what of the
/// opponent.
LayoutGraph layoutGraphOf(const CoupledGraph& graph);

/// Where nodes are drawn: within a circle of radius 1 about the origin.
struct GraphLayout {
    std::vector<std::string> nodes;
    std::vector<Eigen::Vector2d> places;

    const Eigen::Vector2d* find(const std::string& node) const;
};

/// How far a node may go at most when a layout is brought up to date.
inline constexpr double kLayoutStep = 0.04;

/// Lays out by forces (Fruchterman and Reingold, 1991) from fixed places: the same graph gives the
/// same layout. With `last` nodes that it knows move by kLayoutStep at most, so that a drawing
/// does not jump when one edit arrives; new ones appear among their neighbours.
GraphLayout layOutGraph(const LayoutGraph& graph, const GraphLayout* last = nullptr);

}  // namespace kumite
