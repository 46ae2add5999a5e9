#include "core/interaction/transition_table.h"

#include <gtest/gtest.h>

namespace kumite {
namespace {

Label label(const char* text) {
    return parseLabel(kickboxing(), text);
}

/// Two fighters whose actions follow each other at the same moments, half a second each.
CoupledGraph bout(const std::vector<const char*>& first, const std::vector<const char*>& second) {
    LabelledTake take{"round", {}};
    for (const auto* spelled : {&first, &second}) {
        LabelledStream stream;
        stream.rate = 60;
        stream.frameCount = 30 * static_cast<int>(spelled->size()) + 1;
        for (std::size_t i = 0; i < spelled->size(); ++i) {
            const int begin = 30 * static_cast<int>(i);
            stream.actions.push_back({begin, begin + 30, begin + 15});
            stream.labels.push_back(label((*spelled)[i]));
        }
        take.players.push_back(stream);
    }
    return coupledGraph(SharedValue<Vocabulary>(kickboxing()), std::vector<LabelledTake>{take});
}

const CoupledGraph& example() {
    static const CoupledGraph graph =
        bout({"left_punch:fwd", "right_punch:fwd", "left_punch:fwd", "right_punch:fwd", "jump:up"},
             {"jump:up", "jump:down", "jump:up", "jump:down", "jump:up"});
    return graph;
}

TEST(TransitionTable, RowsSumToOneAndCountsAreThoseOfTheTransitions) {
    const CoupledGraph& graph = example();
    const LabelTerm term = learnLabelTerm(graph, 0, LabelEstimator::Equ7);
    for (const TableRows kind : {TableRows::Own, TableRows::Opponent, TableRows::Pairs}) {
        const TransitionTable table = transitionTable(graph, 0, term, kind);
        ASSERT_EQ(table.probabilities.cols(), graph.nodeCount(0));
        EXPECT_EQ(table.counts.sum(), 4);
        for (Eigen::Index i = 0; i < table.probabilities.rows(); ++i) {
            EXPECT_NEAR(table.probabilities.row(i).sum(), 1, 1e-12);
            EXPECT_EQ(table.counts.row(i).sum(), table.rows[std::size_t(i)].count);
        }
    }
}

TEST(TransitionTable, SingleLabelsHaveAllRowsPairsThoseThatWereSeen) {
    const CoupledGraph& graph = example();
    EXPECT_EQ(countedTable(graph, 0, TableRows::Own).rows.size(), 3U);
    EXPECT_EQ(countedTable(graph, 0, TableRows::Opponent).rows.size(), 2U);
    // Left punches end while the opponent jumps up, right ones while it comes down.
    EXPECT_EQ(countedTable(graph, 0, TableRows::Pairs).rows.size(), 2U);
}

TEST(TransitionTable, SharesAreAsCounted) {
    const CoupledGraph& graph = example();
    const TransitionTable table = countedTable(graph, 0, TableRows::Own);
    const int left = *graph.find(0, label("left_punch:fwd"));
    const int right = *graph.find(0, label("right_punch:fwd"));
    const int jump = *graph.find(0, label("jump:up"));
    EXPECT_EQ(table.counts(left, right), 2);
    EXPECT_DOUBLE_EQ(table.probabilities(left, right), 1.0);
    EXPECT_DOUBLE_EQ(table.probabilities(right, left), 0.5);
    EXPECT_DOUBLE_EQ(table.probabilities(right, jump), 0.5);
    EXPECT_EQ(table.probabilities.row(jump).sum(), 0.0) << "nothing follows the last action";
}

TEST(TransitionTable, TablesAreComparedByTheirLabels) {
    const CoupledGraph& graph = example();
    const TransitionTable a = countedTable(graph, 0, TableRows::Own);
    const TransitionTable b = countedTable(graph, 1, TableRows::Own);
    const TablePairing pairing = pairTables(graph, 0, a, graph, 1, b);
    EXPECT_EQ(pairing.rows.size(), 4U) << "jump:up is what both do";
    const Eigen::MatrixXd difference = differenceOf(pairing, a, b);
    EXPECT_NEAR(difference.cwiseMax(0.0).sum(), a.probabilities.sum(), 1e-12);
    EXPECT_NEAR(difference.cwiseMin(0.0).sum(), -b.probabilities.sum(), 1e-12);
    const TablePairing same = pairTables(graph, 0, a, graph, 0, a);
    EXPECT_EQ(same.rows.size(), a.rows.size());
    EXPECT_EQ(differenceOf(same, a, a).cwiseAbs().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace kumite
