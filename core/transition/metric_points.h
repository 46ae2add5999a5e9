#pragma once

#include <span>
#include <vector>

namespace kumite {

/// What the points of a metric space are made of: plain coordinates first, then unit quaternions
/// (w, x, y, z), each rotation with a weight. Without rotations it is Euclidean space.
struct MetricShape {
    int coordinates = 0;
    std::vector<double> weights;  ///< one per rotation, not negative

    std::size_t width() const { return static_cast<std::size_t>(coordinates) + 4 * weights.size(); }
    bool operator==(const MetricShape&) const = default;
};

/// √( Σ (x − x')² + Σ (w θ)² ), θ the angle between two rotations in radians (q and −q are one
/// rotation). A metric: never negative, symmetric, and the triangle inequality holds, so that
/// searches may leave out what cannot be near. `a` and `b` are `shape.width()` numbers each.
double metricDistance(const MetricShape& shape, const double* a, const double* b);

/// The same where it is at most `bound`, else +infinity; several times quicker for what is far.
double metricDistanceWithin(const MetricShape& shape, const double* a, const double* b,
                            double bound);

/// Points of one shape, one after the other in one block.
struct MetricPoints {
    MetricShape shape;
    std::vector<double> values;

    int count() const {
        return shape.width() == 0 ? 0 : static_cast<int>(values.size() / shape.width());
    }
    const double* at(int index) const {
        return values.data() + static_cast<std::size_t>(index) * shape.width();
    }
    void add(const double* point) { values.insert(values.end(), point, point + shape.width()); }
};

}  // namespace kumite
