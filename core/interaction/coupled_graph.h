#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/frame_range.h"
#include "core/base/shared_value.h"
#include "core/interaction/basic_structure.h"

namespace kumite {

/// Stands for "whatever it is" where a node is asked for.
inline constexpr int kAnyNode = -1;

/// A node of a player's motion transition graph: all actions that share one label.
struct GraphNode {
    Label label;
    std::string text;          ///< as labels are spelt: "right_punch:fwd+move:L-R"
    std::vector<int> actions;  ///< of B, in order of time

    bool operator==(const GraphNode&) const = default;
};

/// An element of the training set D1 or D2: the mover's action ends, the opponent is in the middle
/// of (or just at the end of) another, the mover goes on to the next.
struct Transition {
    int own = 0;       ///< the mover's action in B
    int opponent = 0;  ///< the other player's action in B
    int next = 0;      ///< the mover's next action in B
    int ownNode = 0;   ///< nodes of these actions, in the graphs of their players
    int opponentNode = 0;
    int nextNode = 0;

    bool operator==(const Transition&) const = default;
};

/// The coupled motion transition graph C = (B, G1, G2, C, R) (paper A, section 3.3; method A6).
/// Players by index 0 and 1. The graphs and their cross edges are complete, so edges are not
/// stored: what is known of them are the transitions (see transitionCounts) and what a model makes
/// of these (label_term.h). Nodes stand in order of their labels: the same labels give the same
/// order, whichever player shows them.
struct CoupledGraph {
    SharedValue<Vocabulary> vocabulary;
    std::vector<std::string> takes;                      ///< names
    BasicStructure actions;                              ///< B
    std::array<std::vector<GraphNode>, 2> nodes;         ///< of G1 and G2
    std::array<std::vector<Transition>, 2> transitions;  ///< D1 and D2, in order of time
    /// R: by player, aspect and qualifier, the nodes whose labels have it.
    std::array<std::vector<std::vector<std::vector<int>>>, 2> repertoire;

    int nodeCount(int player) const {
        return static_cast<int>(nodes[static_cast<std::size_t>(player)].size());
    }
    const BasicAction& action(int player, int index) const {
        return actions[static_cast<std::size_t>(player)][static_cast<std::size_t>(index)];
    }
    const GraphNode& node(int player, int index) const {
        return nodes[static_cast<std::size_t>(player)][static_cast<std::size_t>(index)];
    }
    const std::vector<Transition>& transitionsOf(int player) const {
        return transitions[static_cast<std::size_t>(player)];
    }
    /// The node of a label; nothing where the player never shows it.
    std::optional<int> find(int player, const Label& label) const;
};

/// Transitions need the labels of all three actions; what lacks one is left out. Aspects that a
/// label leaves open count as at their fallback.
CoupledGraph coupledGraph(const SharedValue<Vocabulary>& vocabulary,
                          std::span<const LabelledTake> takes);

/// How often a mover went from where to where.
struct TransitionCounts {
    Eigen::MatrixXi own;       ///< row: own node, column: next node
    Eigen::MatrixXi opponent;  ///< row: the opponent's node, column: next node (cross edges)
    Eigen::MatrixXi cross;     ///< row: own node, column: the opponent's node in progress
    Eigen::VectorXi next;      ///< by next node
};
TransitionCounts transitionCounts(const CoupledGraph& graph, int mover);

/// Which transitions are meant; kAnyNode leaves a place open.
struct TransitionFilter {
    int own = kAnyNode;
    int opponent = kAnyNode;
    int next = kAnyNode;

    bool matches(const Transition& transition) const {
        const auto fits = [](int wanted, int is) { return wanted == kAnyNode || wanted == is; };
        return fits(own, transition.ownNode) && fits(opponent, transition.opponentNode) &&
               fits(next, transition.nextNode);
    }
};

/// Trace-back: indices of the mover's transitions behind a node, a cell or an edge.
std::vector<int> transitionsBehind(const CoupledGraph& graph, int mover,
                                   const TransitionFilter& filter);

/// Where in the recordings a transition stands. Frames of the take: the mover's own and next
/// action, the moment of the change, the opponent's action.
struct TransitionPlace {
    int take = 0;
    int frame = 0;            ///< the mover's, at which the next action begins
    double seconds = 0;       ///< the same on the take's clock
    FrameRange mover;         ///< from the own action's begin to the next one's end
    FrameRange opponent;      ///< of the action in progress
    double beginSeconds = 0;  ///< of all three actions together, on the take's clock
    double endSeconds = 0;
};
TransitionPlace placeOf(const CoupledGraph& graph, int mover, const Transition& transition);

/// The transition into the action that begins at (or, of those before, nearest to) a frame of a
/// take; nothing where none is.
std::optional<int> transitionAt(const CoupledGraph& graph, int mover, int take, int frame);

}  // namespace kumite
