#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace kumite {

/// A k-d tree over points in space: which of them are nearest to a place. Exact.
class PointIndex {
public:
    PointIndex() = default;
    explicit PointIndex(std::vector<Eigen::Vector3d> points);

    /// Indices of the `count` points nearest to `place`, nearest first, equally near ones in the
    /// order of their indices; all of them if there are fewer.
    std::vector<int> nearest(const Eigen::Vector3d& place, int count) const;

    std::span<const Eigen::Vector3d> points() const { return points_; }

private:
    void build(int begin, int end);

    std::vector<Eigen::Vector3d> points_;
    std::vector<int> order_;  ///< the tree: the middle of every range splits it
    std::vector<int> axis_;   ///< along which axis, per place in `order_`
};

}  // namespace kumite
