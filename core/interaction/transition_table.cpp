#include "core/interaction/transition_table.h"

#include <map>
#include <utility>

namespace kumite {

namespace {

TransitionTable emptyTable(const CoupledGraph& graph, int mover, TableRows kind) {
    TransitionTable table;
    std::map<std::pair<int, int>, int> counts;
    const bool own = kind != TableRows::Opponent;
    const bool opponent = kind != TableRows::Own;
    if (kind != TableRows::Pairs) {
        for (int node = 0; node < graph.nodeCount(own ? mover : 1 - mover); ++node)
            counts[{own ? node : kAnyNode, opponent ? node : kAnyNode}] = 0;
    }
    const auto keyOf = [&](const Transition& t) {
        return std::pair(own ? t.ownNode : kAnyNode, opponent ? t.opponentNode : kAnyNode);
    };
    for (const Transition& t : graph.transitionsOf(mover))
        ++counts[keyOf(t)];
    std::map<std::pair<int, int>, int> rowOf;
    for (const auto& [key, count] : counts) {
        rowOf[key] = static_cast<int>(table.rows.size());
        table.rows.push_back({key.first, key.second, count});
    }
    const auto rows = static_cast<Eigen::Index>(table.rows.size());
    table.counts = Eigen::MatrixXi::Zero(rows, graph.nodeCount(mover));
    for (const Transition& t : graph.transitionsOf(mover))
        ++table.counts(rowOf[keyOf(t)], t.nextNode);
    table.probabilities = Eigen::MatrixXd::Zero(rows, graph.nodeCount(mover));
    return table;
}

/// Labels of a row: own, opponent; those that are left open are empty.
std::pair<Label, Label> labelsOf(const CoupledGraph& graph, int mover,
                                 const TransitionTable::Row& row) {
    return {row.own == kAnyNode ? Label() : graph.node(mover, row.own).label,
            row.opponent == kAnyNode ? Label() : graph.node(1 - mover, row.opponent).label};
}

template <typename Key>
std::vector<TablePairing::Place> pairUp(const std::vector<Key>& a, const std::vector<Key>& b) {
    std::vector<TablePairing::Place> places;
    std::map<Key, std::size_t> known;
    for (std::size_t i = 0; i < a.size(); ++i) {
        known[a[i]] = i;
        places.push_back({static_cast<int>(i), -1});
    }
    for (std::size_t i = 0; i < b.size(); ++i) {
        const auto found = known.find(b[i]);
        if (found != known.end()) {
            places[found->second].second = static_cast<int>(i);
        } else {
            places.push_back({-1, static_cast<int>(i)});
        }
    }
    return places;
}

}  // namespace

TransitionTable transitionTable(const CoupledGraph& graph, int mover, const LabelTerm& term,
                                TableRows kind) {
    TransitionTable table = emptyTable(graph, mover, kind);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto values = term.probabilities(table.rows[i].own, table.rows[i].opponent);
        table.probabilities.row(static_cast<Eigen::Index>(i)) =
            Eigen::Map<const Eigen::RowVectorXd>(values.data(),
                                                 static_cast<Eigen::Index>(values.size()));
    }
    return table;
}

TransitionTable countedTable(const CoupledGraph& graph, int mover, TableRows kind) {
    TransitionTable table = emptyTable(graph, mover, kind);
    for (Eigen::Index i = 0; i < table.counts.rows(); ++i) {
        const int sum = table.counts.row(i).sum();
        if (sum > 0) table.probabilities.row(i) = table.counts.row(i).cast<double>() / sum;
    }
    return table;
}

TablePairing pairTables(const CoupledGraph& aGraph, int aMover, const TransitionTable& a,
                        const CoupledGraph& bGraph, int bMover, const TransitionTable& b) {
    const auto rowKeys = [](const CoupledGraph& graph, int mover, const TransitionTable& table) {
        std::vector<std::pair<Label, Label>> keys;
        for (const auto& row : table.rows)
            keys.push_back(labelsOf(graph, mover, row));
        return keys;
    };
    const auto columnKeys = [](const CoupledGraph& graph, int mover) {
        std::vector<Label> keys;
        for (int node = 0; node < graph.nodeCount(mover); ++node)
            keys.push_back(graph.node(mover, node).label);
        return keys;
    };
    return {pairUp(rowKeys(aGraph, aMover, a), rowKeys(bGraph, bMover, b)),
            pairUp(columnKeys(aGraph, aMover), columnKeys(bGraph, bMover))};
}

Eigen::MatrixXd differenceOf(const TablePairing& pairing, const TransitionTable& a,
                             const TransitionTable& b) {
    Eigen::MatrixXd difference(static_cast<Eigen::Index>(pairing.rows.size()),
                               static_cast<Eigen::Index>(pairing.columns.size()));
    for (Eigen::Index r = 0; r < difference.rows(); ++r) {
        const auto& row = pairing.rows[static_cast<std::size_t>(r)];
        for (Eigen::Index c = 0; c < difference.cols(); ++c) {
            const auto& column = pairing.columns[static_cast<std::size_t>(c)];
            const bool inA = row.first >= 0 && column.first >= 0;
            const bool inB = row.second >= 0 && column.second >= 0;
            difference(r, c) = (inA ? a.probabilities(row.first, column.first) : 0.0) -
                               (inB ? b.probabilities(row.second, column.second) : 0.0);
        }
    }
    return difference;
}

}  // namespace kumite
