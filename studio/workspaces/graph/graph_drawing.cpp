#include "studio/workspaces/graph/graph_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

constexpr double kApart = 1.18;  ///< from the middle to each graph's, side by side
constexpr double kDeep = 0.85;   ///< the same, one behind the other
constexpr double kFaded = 0.16;
constexpr double kLeastRadius = 0.018;
constexpr double kMostRadius = 0.07;

struct Candidate {
    GraphScene::Edge edge;
    GraphSelection meaning;
    double probability = 0;
};

class Drawer {
public:
    Drawer(const GraphSession& graph, const DrawingOptions& options, const Colours& colours)
        : graph_(graph), options_(options), colours_(colours) {}

    GraphDrawing draw() {
        for (const int player : {0, 1})
            addGround(player);
        for (const int player : {0, 1})
            addNodes(player);
        for (const int mover : {0, 1}) {
            addOwnEdges(mover);
            if (options_.crossEdges || selects()) addCrossEdges(mover);
        }
        addEdges();
        showSelection();
        return std::move(drawing_);
    }

private:
    bool selects() const { return graph_.selection().has_value(); }

    Eigen::Vector3d centreOf(int player) const {
        const double side = player == 0 ? -1 : 1;
        if (options_.inSpace) return {0, 0, -side * kDeep};
        return options_.upright ? Eigen::Vector3d(0, -side * kApart, 0)
                                : Eigen::Vector3d(side * kApart, 0, 0);
    }

    void addGround(int player) {
        drawing_.scene.grounds.push_back(
            {centreOf(player), fighterText(player), colours_.fighterText[player]});
    }

    void addNodes(int player) {
        const CoupledGraph& graph = graph_.graph();
        first_[static_cast<std::size_t>(player)] = static_cast<int>(drawing_.nodes.size());
        std::size_t most = 1;
        for (int node = 0; node < graph.nodeCount(player); ++node)
            most = std::max(most, graph.node(player, node).actions.size());
        const int now = graph_.moment(player).action;
        const int lit = now < 0 ? kAnyNode : graph.action(player, now).node;
        for (int index = 0; index < graph.nodeCount(player); ++index) {
            const GraphNode& node = graph.node(player, index);
            GraphScene::Node drawn;
            drawn.name = graph_.nameOf(player, index);
            drawn.place = centreOf(player);
            if (const auto* place = graph_.values()->layout.find(node.text)) {
                drawn.place += Eigen::Vector3d(place->x(), place->y(), 0);
            }
            const double share =
                static_cast<double>(node.actions.size()) / static_cast<double>(most);
            drawn.radius = kLeastRadius + (kMostRadius - kLeastRadius) * std::sqrt(share);
            drawn.fill = colours_.fighters[player];
            drawn.lit = index == lit;
            drawn.rank = share + (drawn.lit ? 10 : 0);
            drawing_.scene.nodes.push_back(drawn);
            drawing_.nodes.push_back({player, index});
        }
    }

    int nodeOf(int player, int node) const {
        return first_[static_cast<std::size_t>(player)] + node;
    }

    /// The edges of one row of probabilities: the likeliest that were seen.
    void addRow(const std::vector<double>& probabilities, const Eigen::RowVectorXi& counts,
                int from, int mover, TransitionFilter filter, const QColor& colour, bool always) {
        std::vector<int> seen;
        for (int next = 0; next < static_cast<int>(probabilities.size()); ++next) {
            const double p = probabilities[static_cast<std::size_t>(next)];
            if (counts(next) > 0 && p >= options_.least) seen.push_back(next);
        }
        std::stable_sort(seen.begin(), seen.end(), [&](int a, int b) {
            return probabilities[static_cast<std::size_t>(a)] >
                   probabilities[static_cast<std::size_t>(b)];
        });
        for (std::size_t rank = 0; rank < seen.size(); ++rank) {
            const int next = seen[rank];
            const bool few = static_cast<int>(rank) < options_.most;
            filter.next = next;
            const GraphSelection meaning{mover, filter};
            const int to = nodeOf(mover, next);
            if (!few && !(always || isSelected(meaning) || leadsToSelected(mover, next))) continue;
            const double p = probabilities[static_cast<std::size_t>(next)];
            candidates_.push_back({{from, to, 0, colour, 0}, meaning, p});
        }
    }

    bool isSelected(const GraphSelection& meaning) const {
        return selects() && *graph_.selection() == meaning;
    }
    bool leadsToSelected(int mover, int next) const {
        if (!selects()) return false;
        const GraphSelection& chosen = *graph_.selection();
        const bool nodeAlone = chosen.filter.next == kAnyNode && chosen.filter.opponent == kAnyNode;
        return nodeAlone && chosen.mover == mover && chosen.filter.own == next;
    }
    /// Whether all that leaves a node is asked for.
    bool isChosenNode(int player, int node) const {
        if (!selects()) return false;
        const GraphSelection& chosen = *graph_.selection();
        if (chosen.filter.next != kAnyNode) return false;
        return player == chosen.mover ? chosen.filter.own == node : chosen.filter.opponent == node;
    }

    void addOwnEdges(int mover) {
        const TransitionModel& model = graph_.model(mover);
        for (int own = 0; own < graph_.graph().nodeCount(mover); ++own) {
            addRow(model.labels.probabilities(own, kAnyNode), model.counts.own.row(own),
                   nodeOf(mover, own), mover, {own, kAnyNode, kAnyNode}, colours_.fighters[mover],
                   isChosenNode(mover, own));
        }
    }

    void addCrossEdges(int mover) {
        const TransitionModel& model = graph_.model(mover);
        const QColor colour = mixed(colours_.secondText, colours_.fighters[mover], 0.35);
        for (int other = 0; other < graph_.graph().nodeCount(1 - mover); ++other) {
            const bool chosen = isChosenNode(1 - mover, other);
            // Without a wish for all of them only those of what is selected.
            const TransitionFilter filter{kAnyNode, other, kAnyNode};
            if (!options_.crossEdges && !chosen && !selectsCross(mover, other)) continue;
            addRow(model.labels.probabilities(kAnyNode, other), model.counts.opponent.row(other),
                   nodeOf(1 - mover, other), mover, filter, colour, false);
        }
    }
    bool selectsCross(int mover, int other) const {
        return selects() && graph_.selection()->mover == mover &&
               graph_.selection()->filter.opponent == other;
    }

    void addEdges() {
        // The likeliest edge is the widest and strongest; labels are many, so that even that one is
        // far from certain.
        double most = 1e-9;
        for (const Candidate& candidate : candidates_)
            most = std::max(most, candidate.probability);
        for (Candidate& candidate : candidates_) {
            const double share = candidate.probability / most;
            candidate.edge.width = 0.01 + 0.03 * share;
            candidate.edge.presence = 0.35 + 0.65 * share;
        }
        std::stable_sort(candidates_.begin(), candidates_.end(),
                         [](const Candidate& a, const Candidate& b) {
                             return a.edge.presence < b.edge.presence;
                         });
        for (const Candidate& candidate : candidates_) {
            drawing_.scene.edges.push_back(candidate.edge);
            drawing_.edges.push_back(candidate.meaning);
            drawing_.probabilities.push_back(candidate.probability);
        }
    }

    void showSelection() {
        if (!selects()) return;
        const GraphSelection& chosen = *graph_.selection();
        std::set<int> ends;
        const auto add = [&](int player, int node) {
            if (node == kAnyNode) return;
            const int index = nodeOf(player, node);
            ends.insert(index);
            drawing_.scene.nodes[static_cast<std::size_t>(index)].ringed = true;
        };
        add(chosen.mover, chosen.filter.own);
        add(1 - chosen.mover, chosen.filter.opponent);
        add(chosen.mover, chosen.filter.next);
        if (ends.empty()) return;
        std::set<int> near = ends;
        for (GraphScene::Edge& edge : drawing_.scene.edges) {
            const bool both = ends.count(edge.from) && ends.count(edge.to);
            const bool touches =
                ends.size() == 1 ? ends.count(edge.from) || ends.count(edge.to) : both;
            if (!touches) {
                edge.presence *= kFaded;
                continue;
            }
            edge.presence = std::min(1.0, edge.presence + 0.25);
            near.insert(edge.from);
            near.insert(edge.to);
        }
        for (std::size_t i = 0; i < drawing_.scene.nodes.size(); ++i) {
            GraphScene::Node& node = drawing_.scene.nodes[i];
            const bool isNear = near.count(static_cast<int>(i)) > 0;
            if (!isNear && !node.lit) {
                node.presence = kFaded + 0.1;
                node.rank = -1;
            } else {
                node.rank += node.ringed ? 20 : 5;
            }
        }
    }

    const GraphSession& graph_;
    const DrawingOptions& options_;
    const Colours& colours_;
    GraphDrawing drawing_;
    std::array<int, 2> first_{};
    std::vector<Candidate> candidates_;
};

}  // namespace

GraphDrawing drawGraph(const GraphSession& graph, const DrawingOptions& options,
                       const Colours& colours) {
    return Drawer(graph, options, colours).draw();
}

}  // namespace kumite::studio
