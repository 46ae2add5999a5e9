#include "core/editing/point_index.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kumite {

using Eigen::Vector3d;

PointIndex::PointIndex(std::vector<Vector3d> points) : points_(std::move(points)) {
    order_.resize(points_.size());
    axis_.resize(points_.size());
    std::iota(order_.begin(), order_.end(), 0);
    build(0, static_cast<int>(order_.size()));
}

void PointIndex::build(int begin, int end) {
    if (end - begin < 2) return;
    Vector3d low = points_[static_cast<std::size_t>(order_[static_cast<std::size_t>(begin)])];
    Vector3d high = low;
    for (int i = begin; i < end; ++i) {
        const Vector3d& p = points_[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])];
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](int a, int b) {
                         const double x = points_[static_cast<std::size_t>(a)][axis];
                         const double y = points_[static_cast<std::size_t>(b)][axis];
                         return std::pair(x, a) < std::pair(y, b);
                     });
    axis_[static_cast<std::size_t>(middle)] = axis;
    build(begin, middle);
    build(middle + 1, end);
}

std::vector<int> PointIndex::nearest(const Vector3d& place, int count) const {
    using Found = std::pair<double, int>;  // squared distance, index
    std::vector<Found> best;               // a heap, the farthest in front
    const auto wanted = static_cast<std::size_t>(std::max(0, count));
    const auto visit = [&](const auto& self, int begin, int end) -> void {
        if (begin >= end || wanted == 0) return;
        const int middle = (begin + end) / 2;
        const int index = order_[static_cast<std::size_t>(middle)];
        const Vector3d& point = points_[static_cast<std::size_t>(index)];
        const Found found{(point - place).squaredNorm(), index};
        if (best.size() < wanted) {
            best.push_back(found);
            std::push_heap(best.begin(), best.end());
        } else if (found < best.front()) {
            std::pop_heap(best.begin(), best.end());
            best.back() = found;
            std::push_heap(best.begin(), best.end());
        }
        if (end - begin < 2) return;
        const int axis = axis_[static_cast<std::size_t>(middle)];
        const double ahead = place[axis] - point[axis];
        const bool firstLow = ahead < 0;
        firstLow ? self(self, begin, middle) : self(self, middle + 1, end);
        if (best.size() < wanted || ahead * ahead <= best.front().first)
            firstLow ? self(self, middle + 1, end) : self(self, begin, middle);
    };
    visit(visit, 0, static_cast<int>(order_.size()));
    std::sort(best.begin(), best.end());
    std::vector<int> result;
    for (const Found& found : best)
        result.push_back(found.second);
    return result;
}

}  // namespace kumite
