#include "core/project/graph_export.h"

#include <functional>

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/formats/json_text.h"
#include "core/formats/tables.h"
#include "core/interaction/surprise.h"
#include "core/project/chart_svg.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

/// An edge that was observed, into a node of the mover.
struct Edge {
    int mover = 0;
    bool cross = false;
    int from = 0;
    int to = 0;
    int count = 0;
    double probability = 0;
};

void forEdges(const Interaction& interaction, const std::function<void(const Edge&)>& visit) {
    for (const auto& model : interaction.models) {
        for (const bool cross : {false, true}) {
            const Eigen::MatrixXi& counts = cross ? model->counts.opponent : model->counts.own;
            for (int from = 0; from < counts.rows(); ++from) {
                if (counts.row(from).sum() == 0) continue;
                const auto row = cross ? model->labels.probabilities(kAnyNode, from)
                                       : model->labels.probabilities(from, kAnyNode);
                for (int to = 0; to < counts.cols(); ++to) {
                    if (counts(from, to) == 0) continue;
                    visit({model->mover, cross, from, to, counts(from, to),
                           row[static_cast<std::size_t>(to)]});
                }
            }
        }
    }
}

const std::string& textOf(const Interaction& interaction, int player, int node) {
    return interaction.graph->node(player, node).text;
}

Json actionJson(const CoupledGraph& graph, const BasicAction& action) {
    return {{"take", graph.takes[static_cast<std::size_t>(action.take)]},
            {"begin", action.frames.begin},
            {"end", action.frames.end}};
}

Json countsJson(const Eigen::MatrixXi& counts) {
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < counts.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index j = 0; j < counts.cols(); ++j)
            row.push_back(counts(i, j));
        rows.push_back(std::move(row));
    }
    return rows;
}

Json playerJson(const Interaction& interaction, int player) {
    const CoupledGraph& graph = *interaction.graph;
    const auto slot = static_cast<std::size_t>(player);
    const TransitionModel& model = *interaction.models[slot];
    Json labels = Json::array();
    for (const GraphNode& node : graph.nodes[slot]) {
        Json actions = Json::array();
        for (const int action : node.actions)
            actions.push_back(actionJson(graph, graph.action(player, action)));
        labels.push_back({{"label", node.text}, {"actions", std::move(actions)}});
    }
    Json transitions = Json::array();
    const std::vector<Surprise> strange = surprises(model);
    for (std::size_t i = 0; i < strange.size(); ++i) {
        const Transition& t = graph.transitions[slot][i];
        const TransitionPlace place = placeOf(graph, player, t);
        transitions.push_back({{"take", graph.takes[static_cast<std::size_t>(place.take)]},
                               {"frame", place.frame},
                               {"own", t.ownNode},
                               {"opponent", t.opponentNode},
                               {"next", t.nextNode},
                               {"label_surprise", rounded(strange[i].label)},
                               {"geometry_surprise", rounded(strange[i].geometry)},
                               {"surprise", rounded(strange[i].both)}});
    }
    Json table = Json::object();
    for (int a = 0; a < graph.vocabulary->size(); ++a) {
        const Aspect& aspect = (*graph.vocabulary)[a];
        Json& qualifiers = table[aspect.id] = Json::object();
        for (std::size_t q = 0; q < aspect.qualifiers.size(); ++q)
            qualifiers[aspect.qualifiers[q].id] =
                graph.repertoire[slot][static_cast<std::size_t>(a)][q];
    }
    return {{"labels", std::move(labels)},
            {"transitions", std::move(transitions)},
            {"action_table", std::move(table)},
            {"own_counts", countsJson(model.counts.own)},
            {"cross_counts", countsJson(model.counts.opponent)}};
}

}  // namespace

std::string graphCsv(const Interaction& interaction) {
    std::string text = "mover,kind,from,to,count,probability\n";
    forEdges(interaction, [&](const Edge& edge) {
        const int source = edge.cross ? 1 - edge.mover : edge.mover;
        text += fmt::format("{},{},{},{},{},{}\n", edge.mover + 1, edge.cross ? "cross" : "own",
                            csvField(textOf(interaction, source, edge.from)),
                            csvField(textOf(interaction, edge.mover, edge.to)), edge.count,
                            fixed(edge.probability, 6));
    });
    return text;
}

std::string graphJson(const Interaction& interaction) {
    return prettyJson({{"kumite_graph", 1},
                       {"takes", interaction.graph->takes},
                       {"players", {playerJson(interaction, 0), playerJson(interaction, 1)}}});
}

std::string graphGraphMl(const Interaction& interaction) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
        "  <key id=\"player\" for=\"node\" attr.name=\"player\" attr.type=\"int\"/>\n"
        "  <key id=\"label\" for=\"node\" attr.name=\"label\" attr.type=\"string\"/>\n"
        "  <key id=\"actions\" for=\"node\" attr.name=\"actions\" attr.type=\"int\"/>\n"
        "  <key id=\"kind\" for=\"edge\" attr.name=\"kind\" attr.type=\"string\"/>\n"
        "  <key id=\"count\" for=\"edge\" attr.name=\"count\" attr.type=\"int\"/>\n"
        "  <key id=\"probability\" for=\"edge\" attr.name=\"probability\" attr.type=\"double\"/>\n"
        "  <graph id=\"coupled\" edgedefault=\"directed\">\n";
    for (const int player : {0, 1}) {
        const auto& nodes = interaction.graph->nodes[static_cast<std::size_t>(player)];
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            text += fmt::format(
                "    <node id=\"p{0}n{1}\"><data key=\"player\">{0}</data><data key=\"label\">{2}"
                "</data><data key=\"actions\">{3}</data></node>\n",
                player + 1, n, xmlText(nodes[n].text), nodes[n].actions.size());
        }
    }
    forEdges(interaction, [&](const Edge& edge) {
        const int source = edge.cross ? 1 - edge.mover : edge.mover;
        text += fmt::format(
            "    <edge source=\"p{}n{}\" target=\"p{}n{}\"><data key=\"kind\">{}</data><data "
            "key=\"count\">{}</data><data key=\"probability\">{}</data></edge>\n",
            source + 1, edge.from, edge.mover + 1, edge.to, edge.cross ? "cross" : "own",
            edge.count, shortest(edge.probability));
    });
    return text + "  </graph>\n</graphml>\n";
}

void writeGraph(const Interaction& interaction, const std::filesystem::path& file) {
    const std::string suffix = lowerCase(file.extension().string());
    if (suffix == ".csv") return writeFileAtomically(file, graphCsv(interaction));
    if (suffix == ".json") return writeFileAtomically(file, graphJson(interaction));
    if (suffix == ".graphml") return writeFileAtomically(file, graphGraphMl(interaction));
    throw Error(file.string() + ": a graph is written as .csv, .json or .graphml.");
}

}  // namespace kumite
