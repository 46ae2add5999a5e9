#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/interaction/label_term.h"

namespace kumite {

/// What a row of a table of transitions knows: the mover's own label, the opponent's, or both.
enum class TableRows { Own, Opponent, Pairs };

/// P(next | own, opponent) of a mover laid out as a table, one column per node of the mover's
/// graph. Rows for single labels hold every node; pairs are those that were seen.
struct TransitionTable {
    struct Row {
        int own = kAnyNode;
        int opponent = kAnyNode;
        int count = 0;  ///< transitions that begin so

        bool operator==(const Row&) const = default;
    };
    std::vector<Row> rows;          ///< in order of own, then of opponent nodes
    Eigen::MatrixXi counts;         ///< how often each next node was seen
    Eigen::MatrixXd probabilities;  ///< each row sums to 1
};

/// The table with the probabilities of a label term.
TransitionTable transitionTable(const CoupledGraph& graph, int mover, const LabelTerm& term,
                                TableRows rows);
/// The same with shares as counted, without any prior; rows that were never seen are 0 throughout.
TransitionTable countedTable(const CoupledGraph& graph, int mover, TableRows rows);

/// Two tables of the same kind brought together: a row or column for every label that either has,
/// known by its label; `first` and `second` say where it stands there (-1: it does not).
struct TablePairing {
    struct Place {
        int first = -1;
        int second = -1;
    };
    std::vector<Place> rows;
    std::vector<Place> columns;
};
/// Rows of `a` stand first in their order, then those that only `b` has. `aMover` and `bMover` are
/// the movers of the two graphs, which may be one and the same.
TablePairing pairTables(const CoupledGraph& aGraph, int aMover, const TransitionTable& a,
                        const CoupledGraph& bGraph, int bMover, const TransitionTable& b);
/// What a probability is where both are; a table that lacks the row or column counts as 0.
Eigen::MatrixXd differenceOf(const TablePairing& pairing, const TransitionTable& a,
                             const TransitionTable& b);

}  // namespace kumite
