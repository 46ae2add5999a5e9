#include "studio/workspaces/graph/graph_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

constexpr double kApart = 1.1;  ///< from the middle to each graph's, side by side
constexpr double kDeep = 0.85;  ///< the same, one behind the other
constexpr double kFaded = 0.16;
constexpr double kLeastRadius = 0.018;
constexpr double kMostRadius = 0.07;

/// The way from the middle to the second of two circles of radius 1 so that both fill a picture
/// best: to the right where it is wide, downward where it is high, in between where it is neither.
Eigen::Vector2d wayApart(double aspect) {
    double low = 0;
    double high = std::numbers::pi / 2;
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.5 * (low + high);
        const double filled = (kApart * std::cos(angle) + 1) / (kApart * std::sin(angle) + 1);
        (filled > aspect ? low : high) = angle;
    }
    return {kApart * std::cos(low), -kApart * std::sin(low)};
}

class Drawer {
public:
    Drawer(const GraphSession& graph, const DrawingOptions& options, const Colours& colours)
        : graph_(graph), options_(options), colours_(colours) {
        drawing_.values = graph.sharedValues();
        models_ = graph.compares() && graph.options().versus != Versus::OtherFighter;
        differs_ = graph.compares() && options.difference;
        const Interaction& own = graph.values()->interaction;
        drawing_.sides = models_ ? graph.sides()
                                 : std::array{GraphSide{&own, 0, fighterText(0)},
                                              GraphSide{&own, 1, fighterText(1)}};
        for (const std::size_t side : {0U, 1U}) {
            if (!graph.selection()) break;
            const auto chosen = carried(*graph.selection(), graph.graph(), graphOf(side));
            if (!models_ || (chosen && chosen->mover == moverOf(side))) chosen_[side] = chosen;
        }
    }

    GraphDrawing draw() {
        for (const std::size_t side : {0U, 1U})
            addGround(side);
        for (const std::size_t side : {0U, 1U})
            addNodes(side);
        for (const std::size_t side : {0U, 1U}) {
            addOwnEdges(side);
            if (!models_ && (options_.crossEdges || selects())) addCrossEdges(side);
        }
        addEdges();
        showSelection();
        return std::move(drawing_);
    }

private:
    struct Candidate {
        GraphScene::Edge edge;
        GraphDrawing::EdgeRef meaning;
    };

    const GraphSide& sideAt(std::size_t side) const { return drawing_.sides[side]; }
    const CoupledGraph& graphOf(std::size_t side) const { return sideAt(side).graph(); }
    int moverOf(std::size_t side) const { return sideAt(side).mover; }
    bool selects() const { return chosen_[0].has_value() || chosen_[1].has_value(); }
    const QColor& colourOf(std::size_t side) const { return colours_.fighters[moverOf(side)]; }

    Eigen::Vector3d centreOf(std::size_t side) const {
        const double sign = side == 0 ? -1 : 1;
        if (options_.inSpace) return {0, 0, -sign * kDeep};
        const Eigen::Vector2d way = sign * wayApart(options_.aspect);
        return {way.x(), way.y(), 0};
    }

    void addGround(std::size_t side) {
        QString caption = sideAt(side).name;
        if (differs_) caption = GraphSession::tr("%1: more often").arg(caption);
        drawing_.scene.grounds.push_back(
            {centreOf(side), caption, colours_.fighterText[moverOf(side)]});
    }

    void addNodes(std::size_t side) {
        const CoupledGraph& graph = graphOf(side);
        const int player = moverOf(side);
        first_[side] = static_cast<int>(drawing_.nodes.size());
        std::size_t most = 1;
        for (int node = 0; node < graph.nodeCount(player); ++node)
            most = std::max(most, graph.node(player, node).actions.size());
        const int now = graph_.moment(player).action;
        const Label* lit = nullptr;
        if (now >= 0) {
            const int node = graph_.graph().action(player, now).node;
            if (node != kAnyNode) lit = &graph_.graph().node(player, node).label;
        }
        for (int index = 0; index < graph.nodeCount(player); ++index) {
            const GraphNode& node = graph.node(player, index);
            GraphScene::Node drawn;
            drawn.name = shortLabelWords(*graph.vocabulary, node.label);
            drawn.place = centreOf(side);
            if (const auto* place = graph_.values()->layout.find(node.text)) {
                drawn.place += Eigen::Vector3d(place->x(), place->y(), 0);
            }
            const double share =
                static_cast<double>(node.actions.size()) / static_cast<double>(most);
            drawn.radius = kLeastRadius + (kMostRadius - kLeastRadius) * std::sqrt(share);
            drawn.fill = colourOf(side);
            drawn.lit = lit != nullptr && *lit == node.label;
            drawn.rank = share + (drawn.lit ? 10 : 0);
            drawing_.scene.nodes.push_back(drawn);
            drawing_.nodes.push_back({static_cast<int>(side), player, index});
        }
    }

    int nodeOf(std::size_t side, int node) const { return first_[side] + node; }

    /// P(next | own or opponent's label) of a side, and of what the other side does then.
    std::vector<double> row(std::size_t side, int own, int opponent) const {
        const GraphSide& here = sideAt(side);
        std::vector<double> values = here.model().labels.probabilities(own, opponent);
        if (!differs_) return values;
        const GraphSide& there = sideAt(1 - side);
        const auto same = [&](int player, int otherPlayer, int node) -> std::optional<int> {
            if (node == kAnyNode) return kAnyNode;
            return there.graph().find(otherPlayer, here.graph().node(player, node).label);
        };
        const auto otherOwn = same(here.mover, there.mover, own);
        const auto otherOpponent = same(1 - here.mover, 1 - there.mover, opponent);
        if (!otherOwn || !otherOpponent) return values;
        const auto others = there.model().labels.probabilities(*otherOwn, *otherOpponent);
        for (std::size_t next = 0; next < values.size(); ++next) {
            const auto node = same(here.mover, there.mover, static_cast<int>(next));
            if (node) values[next] -= others[static_cast<std::size_t>(*node)];
        }
        return values;
    }

    /// The edges of one row of probabilities: the likeliest that were seen.
    void addRow(std::size_t side, const std::vector<double>& probabilities,
                const Eigen::RowVectorXi& counts, int from, TransitionFilter filter,
                const QColor& colour, bool always) {
        std::vector<int> seen;
        for (int next = 0; next < static_cast<int>(probabilities.size()); ++next) {
            const double p = probabilities[static_cast<std::size_t>(next)];
            if (counts(next) > 0 && p >= options_.least && p > 0) seen.push_back(next);
        }
        std::stable_sort(seen.begin(), seen.end(), [&](int a, int b) {
            return probabilities[static_cast<std::size_t>(a)] >
                   probabilities[static_cast<std::size_t>(b)];
        });
        for (std::size_t rank = 0; rank < seen.size(); ++rank) {
            const int next = seen[rank];
            const bool few = static_cast<int>(rank) < options_.most;
            filter.next = next;
            const GraphSelection meaning{moverOf(side), filter};
            const bool wanted = always || chosen_[side] == meaning || leadsToSelected(side, next);
            if (!few && !wanted) continue;
            const double p = probabilities[static_cast<std::size_t>(next)];
            candidates_.push_back(
                {{from, nodeOf(side, next), 0, colour, 0}, {static_cast<int>(side), meaning, p}});
        }
    }

    bool leadsToSelected(std::size_t side, int next) const {
        const auto& chosen = chosen_[side];
        return chosen && chosen->mover == moverOf(side) && chosen->filter.next == kAnyNode &&
               chosen->filter.opponent == kAnyNode && chosen->filter.own == next;
    }
    /// Whether all that leaves a node is asked for: the mover's, or the opponent's of the mover.
    bool isChosen(std::size_t side, int own, int opponent) const {
        const auto& chosen = chosen_[side];
        if (!chosen || chosen->filter.next != kAnyNode) return false;
        if (opponent == kAnyNode) {
            return chosen->mover == moverOf(side) ? chosen->filter.own == own
                                                  : chosen->filter.opponent == own;
        }
        return chosen->mover == moverOf(side) ? chosen->filter.opponent == opponent
                                              : chosen->filter.own == opponent;
    }

    void addOwnEdges(std::size_t side) {
        const TransitionModel& model = sideAt(side).model();
        for (int own = 0; own < graphOf(side).nodeCount(moverOf(side)); ++own) {
            addRow(side, row(side, own, kAnyNode), model.counts.own.row(own), nodeOf(side, own),
                   {own, kAnyNode, kAnyNode}, colourOf(side), isChosen(side, own, kAnyNode));
        }
    }

    void addCrossEdges(std::size_t side) {
        const TransitionModel& model = sideAt(side).model();
        const int mover = moverOf(side);
        const QColor colour = mixed(colours_.secondText, colours_.fighters[mover], 0.35);
        for (int other = 0; other < graphOf(side).nodeCount(1 - mover); ++other) {
            // Without a wish for all of them only those of what is selected.
            const auto& chosen = chosen_[side];
            const bool among = chosen && chosen->mover == mover && chosen->filter.opponent == other;
            if (!options_.crossEdges && !isChosen(side, kAnyNode, other) && !among) continue;
            addRow(side, row(side, kAnyNode, other), model.counts.opponent.row(other),
                   nodeOf(1 - side, other), {kAnyNode, other, kAnyNode}, colour, false);
        }
    }

    void addEdges() {
        // The likeliest edge is the widest and strongest; labels are many, so that even that one is
        // far from certain.
        double most = 1e-9;
        for (const Candidate& candidate : candidates_)
            most = std::max(most, candidate.meaning.probability);
        for (Candidate& candidate : candidates_) {
            const double share = candidate.meaning.probability / most;
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
        }
    }

    void showSelection() {
        std::set<int> ends;
        const auto add = [&](std::size_t side, int node) {
            if (node == kAnyNode) return;
            const int index = nodeOf(side, node);
            ends.insert(index);
            drawing_.scene.nodes[static_cast<std::size_t>(index)].ringed = true;
        };
        for (const std::size_t side : {0U, 1U}) {
            const auto& chosen = chosen_[side];
            if (!chosen || chosen->mover != moverOf(side)) continue;
            add(side, chosen->filter.own);
            add(side, chosen->filter.next);
            if (!models_) add(1 - side, chosen->filter.opponent);
        }
        if (ends.empty()) return;
        std::set<int> near = ends;
        for (GraphScene::Edge& edge : drawing_.scene.edges) {
            const bool both = ends.count(edge.from) && ends.count(edge.to);
            const bool touches =
                selectsNode() ? ends.count(edge.from) || ends.count(edge.to) : both;
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
    /// One label is chosen, not a way from one to another.
    bool selectsNode() const {
        const TransitionFilter& filter = graph_.selection()->filter;
        return (filter.own != kAnyNode) + (filter.opponent != kAnyNode) +
                   (filter.next != kAnyNode) ==
               1;
    }

    const GraphSession& graph_;
    const DrawingOptions& options_;
    const Colours& colours_;
    GraphDrawing drawing_;
    bool models_ = false;   ///< the sides are two models of one fighter
    bool differs_ = false;  ///< edges are as wide as what the sides differ
    std::array<std::optional<GraphSelection>, 2> chosen_;  ///< what is selected, in a side's graph
    std::array<int, 2> first_{};
    std::vector<Candidate> candidates_;
};

}  // namespace

GraphDrawing drawGraph(const GraphSession& graph, const DrawingOptions& options,
                       const Colours& colours) {
    return Drawer(graph, options, colours).draw();
}

}  // namespace kumite::studio
