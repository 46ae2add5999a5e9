#pragma once

#include <QColor>
#include <QString>

#include <vector>

#include <Eigen/Core>

namespace kumite::studio {

/// What a drawing of the coupled graph holds: circles, bent edges that get thinner toward where
/// they lead, names. Lengths in the drawing's own unit: a fighter's graph has radius 1.
struct GraphScene {
    struct Node {
        QString name;
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        double radius = 0.03;
        QColor fill;
        double presence = 1;  ///< 0 … 1: how little it fades into the ground
        bool ringed = false;  ///< chosen
        bool lit = false;     ///< going on at the playhead
        double rank = 0;      ///< names of higher ones are placed first; below 0: only on demand
    };
    struct Edge {
        int from = 0;
        int to = 0;
        double width = 0.01;  ///< where it begins
        QColor colour;
        double presence = 1;
    };
    /// A circle of radius 1 behind a fighter's graph, and its caption.
    struct Ground {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        QString caption;
        QColor colour;
    };
    std::vector<Node> nodes;
    std::vector<Edge> edges;  ///< weak ones first: the last is drawn on top
    std::vector<Ground> grounds;
};

/// What a point of the picture is on.
struct GraphPick {
    enum class Kind { Node, Edge };
    Kind kind = Kind::Node;
    int index = 0;

    bool operator==(const GraphPick&) const = default;
};

}  // namespace kumite::studio
