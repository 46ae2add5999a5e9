#pragma once

#include <limits>
#include <vector>

#include "core/transition/metric_points.h"

namespace kumite {

/// The nearest of some points; id −1 where none lies within the bound.
struct NearestPoint {
    int id = -1;
    double distance = std::numeric_limits<double>::infinity();
};

/// Points in a tree of balls, so that the nearest one is found without looking at most of them: the
/// hierarchical clustering that the paper names as future work. A simplified cover tree (Izbicki
/// and Shelton, ICML 2015) that knows the true radius of every ball, whence the search is exact.
/// Points are added one by one and numbered from 0. Searches may run on several threads at once.
class PoseTree {
public:
    explicit PoseTree(MetricShape shape = {}) : points_{std::move(shape), {}} {}

    /// Adds a point of `shape().width()` numbers; its id is the count before.
    void add(const double* point);

    int count() const { return points_.count(); }
    const MetricShape& shape() const { return points_.shape; }
    const MetricPoints& points() const { return points_; }

    /// The nearest point at a distance of at most `bound`, the lowest id of equals. `hint`: a point
    /// that is probably near (such as the answer for the frame before), which saves most of the
    /// search; −1: none.
    NearestPoint nearest(const double* query,
                         double bound = std::numeric_limits<double>::infinity(),
                         int hint = -1) const;
    /// The same by looking at every point: what the tree is compared with.
    NearestPoint nearestByScan(const double* query) const;

private:
    struct Node {
        double reach = 0;     ///< a point this near may become a child
        double radius = 0;    ///< distance of the farthest point below
        double toParent = 0;  ///< distance of the parent
        std::vector<int> children;
    };
    struct Visit {
        int node;
        double distance;
    };
    void search(const double* query, Visit visit, NearestPoint& best,
                std::vector<Visit>& stack) const;

    MetricPoints points_;
    std::vector<Node> nodes_;  ///< one per point, the same numbers; 0 is the root
};

}  // namespace kumite
