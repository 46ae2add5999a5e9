#include "core/interaction/coupled_graph.h"

#include <algorithm>
#include <map>

namespace kumite {
namespace {

/// Nothing is left open where an aspect has a fallback.
Label completed(const Vocabulary& vocabulary, Label label) {
    for (int a = 0; a < vocabulary.size(); ++a) {
        int& qualifier = label[static_cast<std::size_t>(a)];
        if (qualifier == kUnknown && vocabulary[a].fallback) qualifier = *vocabulary[a].fallback;
    }
    return label;
}

std::vector<GraphNode> nodesOf(const Vocabulary& vocabulary, std::span<const LabelledTake> takes,
                               std::size_t player, std::vector<BasicAction>& actions) {
    std::map<Label, std::vector<int>> groups;
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const LabelledStream& stream =
            takes[static_cast<std::size_t>(actions[i].take)].players[player];
        const Label& label = stream.labels[static_cast<std::size_t>(actions[i].index)];
        if (!label.empty()) groups[completed(vocabulary, label)].push_back(static_cast<int>(i));
    }
    std::vector<GraphNode> nodes;
    for (auto& [label, members] : groups) {
        for (const int action : members)
            actions[static_cast<std::size_t>(action)].node = static_cast<int>(nodes.size());
        nodes.push_back({label, labelText(vocabulary, label), std::move(members)});
    }
    return nodes;
}

std::vector<std::vector<std::vector<int>>> repertoireOf(const Vocabulary& vocabulary,
                                                        const std::vector<GraphNode>& nodes) {
    std::vector<std::vector<std::vector<int>>> table;
    for (const Aspect& aspect : vocabulary.aspects)
        table.emplace_back(aspect.qualifiers.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        for (std::size_t a = 0; a < table.size(); ++a) {
            const int qualifier = nodes[n].label[a];
            if (qualifier != kUnknown)
                table[a][static_cast<std::size_t>(qualifier)].push_back(static_cast<int>(n));
        }
    }
    return table;
}

std::vector<Transition> transitionsOf(const BasicStructure& all, std::size_t mover) {
    std::vector<Transition> found;
    const std::vector<BasicAction>& own = all[mover];
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i].next < 0) continue;
        const BasicAction& next = own[static_cast<std::size_t>(own[i].next)];
        if (next.inProgress < 0) continue;
        const BasicAction& opponent = all[1 - mover][static_cast<std::size_t>(next.inProgress)];
        if (own[i].node < 0 || opponent.node < 0 || next.node < 0) continue;
        found.push_back({static_cast<int>(i), next.inProgress, own[i].next, own[i].node,
                         opponent.node, next.node});
    }
    return found;
}

}  // namespace

std::optional<int> CoupledGraph::find(int player, const Label& label) const {
    const auto& all = nodes[static_cast<std::size_t>(player)];
    const auto found = std::lower_bound(
        all.begin(), all.end(), label,
        [](const GraphNode& node, const Label& wanted) { return node.label < wanted; });
    if (found == all.end() || found->label != label) return std::nullopt;
    return static_cast<int>(found - all.begin());
}

CoupledGraph coupledGraph(const SharedValue<Vocabulary>& vocabulary,
                          std::span<const LabelledTake> takes) {
    CoupledGraph graph;
    graph.vocabulary = vocabulary;
    for (const LabelledTake& take : takes)
        graph.takes.push_back(take.name);
    graph.actions = basicStructure(takes);
    for (const std::size_t player : {0, 1}) {
        graph.nodes[player] = nodesOf(*vocabulary, takes, player, graph.actions[player]);
        graph.repertoire[player] = repertoireOf(*vocabulary, graph.nodes[player]);
    }
    for (const std::size_t mover : {0, 1})
        graph.transitions[mover] = transitionsOf(graph.actions, mover);
    return graph;
}

TransitionCounts transitionCounts(const CoupledGraph& graph, int mover) {
    const int own = graph.nodeCount(mover);
    const int opponent = graph.nodeCount(1 - mover);
    TransitionCounts counts{Eigen::MatrixXi::Zero(own, own), Eigen::MatrixXi::Zero(opponent, own),
                            Eigen::MatrixXi::Zero(own, opponent), Eigen::VectorXi::Zero(own)};
    for (const Transition& t : graph.transitionsOf(mover)) {
        ++counts.own(t.ownNode, t.nextNode);
        ++counts.opponent(t.opponentNode, t.nextNode);
        ++counts.cross(t.ownNode, t.opponentNode);
        ++counts.next(t.nextNode);
    }
    return counts;
}

std::vector<int> transitionsBehind(const CoupledGraph& graph, int mover,
                                   const TransitionFilter& filter) {
    std::vector<int> found;
    const std::vector<Transition>& all = graph.transitionsOf(mover);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (filter.matches(all[i])) found.push_back(static_cast<int>(i));
    }
    return found;
}

TransitionPlace placeOf(const CoupledGraph& graph, int mover, const Transition& transition) {
    const BasicAction& own = graph.action(mover, transition.own);
    const BasicAction& next = graph.action(mover, transition.next);
    const BasicAction& opponent = graph.action(1 - mover, transition.opponent);
    TransitionPlace place;
    place.take = own.take;
    place.frame = next.frames.begin;
    place.seconds = next.beginSeconds;
    place.mover = {own.frames.begin, next.frames.end + 1};
    place.opponent = {opponent.frames.begin, opponent.frames.end + 1};
    place.beginSeconds = std::min(own.beginSeconds, opponent.beginSeconds);
    place.endSeconds = std::max(next.endSeconds, opponent.endSeconds);
    return place;
}

std::optional<int> transitionAt(const CoupledGraph& graph, int mover, int take, int frame) {
    std::optional<int> best;
    const std::vector<Transition>& all = graph.transitionsOf(mover);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const BasicAction& next = graph.action(mover, all[i].next);
        if (next.take == take && next.frames.begin <= frame) best = static_cast<int>(i);
    }
    return best;
}

}  // namespace kumite
