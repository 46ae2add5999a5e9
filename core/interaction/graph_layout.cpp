#include "core/interaction/graph_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "core/interaction/coupled_graph.h"

namespace kumite {

namespace {

using Places = std::vector<Eigen::Vector2d>;

constexpr int kColdSteps = 300;
constexpr int kWarmSteps = 20;

/// The heaviest in the middle, the others around in the order of a sunflower's seeds.
Places sunflower(const std::vector<double>& weights) {
    const std::size_t count = weights.size();
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    Places places(count);
    for (std::size_t rank = 0; rank < count; ++rank) {
        const double radius =
            std::sqrt((static_cast<double>(rank) + 0.5) / static_cast<double>(count));
        const double angle = golden * static_cast<double>(rank);
        places[order[rank]] = 0.95 * radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    return places;
}

/// Neighbours draw together, all push each other away, the middle draws all a little.
Places forcesOn(const LayoutGraph& graph, const Places& places, double strongest) {
    const std::size_t count = places.size();
    const double ideal = 1.5 / std::sqrt(static_cast<double>(count));
    Places forces(count, Eigen::Vector2d::Zero());
    for (std::size_t i = 0; i < count; ++i) {
        forces[i] -= 0.6 * ideal * places[i];
        for (std::size_t j = i + 1; j < count; ++j) {
            Eigen::Vector2d way = places[i] - places[j];
            double distance = way.norm();
            if (distance < 1e-6) {  // the order of the nodes says who goes where
                way = Eigen::Vector2d(1e-6, 0);
                distance = 1e-6;
            }
            const Eigen::Vector2d push =
                way / distance * (ideal * ideal / std::max(distance, 0.1 * ideal));
            forces[i] += push;
            forces[j] -= push;
        }
    }
    for (const LayoutGraph::Edge& edge : graph.edges) {
        if (edge.from == edge.to) continue;
        const auto from = static_cast<std::size_t>(edge.from);
        const auto to = static_cast<std::size_t>(edge.to);
        const Eigen::Vector2d way = places[to] - places[from];
        const Eigen::Vector2d pull = edge.weight / strongest * way.norm() / ideal * way;
        forces[from] += pull;
        forces[to] -= pull;
    }
    return forces;
}

void move(const LayoutGraph& graph, Places& places, int steps, double first) {
    double strongest = 1e-12;
    for (const LayoutGraph::Edge& edge : graph.edges)
        strongest = std::max(strongest, edge.weight);
    for (int step = 0; step < steps; ++step) {
        const double reach = first * (1 - static_cast<double>(step) / steps);
        const Places forces = forcesOn(graph, places, strongest);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double length = forces[i].norm();
            if (length < 1e-12) continue;
            places[i] += forces[i] / length * std::min(length, reach);
            const double radius = places[i].norm();
            if (radius > 1) places[i] /= radius;
        }
    }
}

/// Spreads a layout so that it fills the circle, about its own middle.
void fill(Places& places) {
    Eigen::Vector2d low = places.front();
    Eigen::Vector2d high = places.front();
    for (const auto& place : places) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
    }
    const Eigen::Vector2d middle = 0.5 * (low + high);
    double radius = 0;
    for (auto& place : places) {
        place -= middle;
        radius = std::max(radius, place.norm());
    }
    if (radius < 1e-9) return;
    for (auto& place : places)
        place /= radius;
}

/// Where a new node appears: among those that it is tied to, else where the sunflower has it.
Eigen::Vector2d amongNeighbours(const LayoutGraph& graph, std::size_t node, const Places& places,
                                const std::vector<bool>& known) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0;
    for (const LayoutGraph::Edge& edge : graph.edges) {
        const auto from = static_cast<std::size_t>(edge.from);
        const auto to = static_cast<std::size_t>(edge.to);
        if ((from == node) == (to == node)) continue;
        const std::size_t other = from == node ? to : from;
        if (!known[other]) continue;
        sum += edge.weight * places[other];
        weight += edge.weight;
    }
    return weight > 0 ? Eigen::Vector2d(sum / weight + 0.05 * places[node]) : places[node];
}

}  // namespace

const Eigen::Vector2d* GraphLayout::find(const std::string& node) const {
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    return found == nodes.end() ? nullptr
                                : &places[static_cast<std::size_t>(found - nodes.begin())];
}

LayoutGraph layoutGraphOf(const CoupledGraph& graph) {
    LayoutGraph result;
    std::map<std::string, int> known;
    std::map<std::pair<int, int>, double> counts;
    const auto indexOf = [&](int player, int node) {
        const std::string& text = graph.node(player, node).text;
        const auto [place, isNew] = known.try_emplace(text, static_cast<int>(known.size()));
        if (isNew) {
            result.nodes.push_back(text);
            result.weights.push_back(0);
        }
        return place->second;
    };
    for (const int player : {0, 1}) {
        for (int node = 0; node < graph.nodeCount(player); ++node) {
            result.weights[static_cast<std::size_t>(indexOf(player, node))] +=
                static_cast<double>(graph.node(player, node).actions.size());
        }
    }
    // What answers the opponent binds less than what goes on from one's own.
    constexpr double kCross = 0.3;
    for (const int mover : {0, 1}) {
        for (const Transition& t : graph.transitionsOf(mover)) {
            const int next = indexOf(mover, t.nextNode);
            counts[{indexOf(mover, t.ownNode), next}] += 1;
            counts[{indexOf(1 - mover, t.opponentNode), next}] += kCross;
        }
    }
    for (const auto& [ends, count] : counts)
        result.edges.push_back({ends.first, ends.second, std::sqrt(count)});
    return result;
}

GraphLayout layOutGraph(const LayoutGraph& graph, const GraphLayout* last) {
    const std::size_t count = graph.nodes.size();
    if (count == 0) return {};
    GraphLayout layout{graph.nodes, sunflower(graph.weights)};
    std::vector<bool> known(count, false);
    if (last != nullptr) {
        for (std::size_t i = 0; i < count; ++i) {
            const Eigen::Vector2d* place = last->find(graph.nodes[i]);
            if (place == nullptr) continue;
            layout.places[i] = *place;
            known[i] = true;
        }
    }
    const bool warm = std::find(known.begin(), known.end(), true) != known.end();
    if (!warm) {
        move(graph, layout.places, kColdSteps, 0.12);
        fill(layout.places);
        return layout;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!known[i]) layout.places[i] = amongNeighbours(graph, i, layout.places, known);
    }
    // The reach falls linearly: all steps together are half of first × steps.
    move(graph, layout.places, kWarmSteps, 2 * kLayoutStep / (kWarmSteps + 1));
    return layout;
}

}  // namespace kumite
