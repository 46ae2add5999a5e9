#include "core/transition/pose_tree.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

constexpr double kShrink = 1.5;   ///< reach of a ball over the reach of its children
constexpr double kSlack = 1e-12;  ///< rounding of distances, so that equals are never left out

void keepNearer(NearestPoint& best, int id, double distance) {
    if (distance < best.distance || (distance == best.distance && (best.id < 0 || id < best.id)))
        best = {id, distance};
}

}  // namespace

void PoseTree::add(const double* point) {
    const int id = count();
    points_.add(point);
    nodes_.emplace_back();
    if (id == 0) return;
    const double* added = points_.at(id);
    int parent = 0;
    double distance = metricDistance(shape(), points_.at(0), added);
    Node& root = nodes_.front();
    if (root.reach == 0) root.reach = distance > 0 ? distance : 1;
    while (root.reach < distance)
        root.reach *= kShrink;
    for (;;) {
        Node& node = nodes_[static_cast<std::size_t>(parent)];
        node.radius = std::max(node.radius, distance);
        int next = -1;
        double nearest = std::numeric_limits<double>::infinity();
        for (const int child : node.children) {
            if (distance == 0) break;  // equal points lie side by side, not in a chain
            const double reach = nodes_[static_cast<std::size_t>(child)].reach;
            const double d =
                metricDistanceWithin(shape(), points_.at(child), added, std::min(reach, nearest));
            if (d < nearest) {
                nearest = d;
                next = child;
            }
        }
        if (next < 0) {
            node.children.push_back(id);
            nodes_.back().reach = node.reach / kShrink;
            nodes_.back().toParent = distance;
            return;
        }
        parent = next;
        distance = nearest;
    }
}

void PoseTree::search(const double* query, Visit visit, NearestPoint& best,
                      std::vector<Visit>& stack) const {
    const std::size_t begin = stack.size();
    for (const int child : nodes_[static_cast<std::size_t>(visit.node)].children) {
        const Node& node = nodes_[static_cast<std::size_t>(child)];
        // Whatever the ball holds is farther than this: no need to look at its centre.
        const double least = std::abs(visit.distance - node.toParent) - node.radius;
        if (least > best.distance + kSlack * (visit.distance + node.toParent)) continue;
        const double bound = (best.distance + node.radius) * (1 + kSlack);
        const double d = metricDistanceWithin(shape(), points_.at(child), query, bound);
        if (d > bound) continue;
        keepNearer(best, child, d);
        if (!node.children.empty()) stack.push_back({child, d});
    }
    const std::size_t end = stack.size();
    std::sort(stack.begin() + static_cast<std::ptrdiff_t>(begin), stack.end(),
              [](const Visit& a, const Visit& b) {
                  return a.distance != b.distance ? a.distance < b.distance : a.node < b.node;
              });
    for (std::size_t i = begin; i < end; ++i) {
        const Visit next = stack[i];
        const double radius = nodes_[static_cast<std::size_t>(next.node)].radius;
        if (next.distance - radius > best.distance + kSlack * next.distance) continue;
        search(query, next, best, stack);
    }
    stack.resize(begin);
}

NearestPoint PoseTree::nearest(const double* query, double bound, int hint) const {
    NearestPoint best;
    best.distance = bound;
    if (count() == 0) return {};
    if (hint >= 0)
        keepNearer(best, hint, metricDistanceWithin(shape(), points_.at(hint), query, bound));
    const double distance = metricDistance(shape(), points_.at(0), query);
    keepNearer(best, 0, distance);
    std::vector<Visit> stack;
    search(query, {0, distance}, best, stack);
    return best.id < 0 ? NearestPoint{} : best;
}

NearestPoint PoseTree::nearestByScan(const double* query) const {
    NearestPoint best;
    for (int i = 0; i < count(); ++i) {
        keepNearer(best, i, metricDistanceWithin(shape(), points_.at(i), query, best.distance));
    }
    return best;
}

}  // namespace kumite
