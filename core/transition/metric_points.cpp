#include "core/transition/metric_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kumite {
namespace {

double squaredCoordinates(const MetricShape& shape, const double* a, const double* b) {
    double sum = 0;
    for (int i = 0; i < shape.coordinates; ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// Squared length of the chord between two unit quaternions, the nearer of q and −q: the angle is
/// 4 asin(chord / 2), which is exact also where the arc cosine of their product is not.
double squaredChord(const double* p, const double* q) {
    double minus = 0, plus = 0;
    for (int i = 0; i < 4; ++i) {
        minus += (p[i] - q[i]) * (p[i] - q[i]);
        plus += (p[i] + q[i]) * (p[i] + q[i]);
    }
    return std::min(minus, plus);
}

double squaredAngles(const MetricShape& shape, const double* a, const double* b) {
    double sum = 0;
    for (std::size_t k = 0; k < shape.weights.size(); ++k) {
        const double chord = std::sqrt(squaredChord(a + 4 * k, b + 4 * k));
        const double angle = shape.weights[k] * 4 * std::asin(std::min(1.0, chord / 2));
        sum += angle * angle;
    }
    return sum;
}

}  // namespace

double metricDistance(const MetricShape& shape, const double* a, const double* b) {
    return std::sqrt(squaredCoordinates(shape, a, b) +
                     squaredAngles(shape, a + shape.coordinates, b + shape.coordinates));
}

double metricDistanceWithin(const MetricShape& shape, const double* a, const double* b,
                            double bound) {
    constexpr double far = std::numeric_limits<double>::infinity();
    // An angle is at least twice its chord: what is too far by chords needs no arc sine.
    double least = squaredCoordinates(shape, a, b);
    const double limit = bound * bound * (1 + 1e-12);
    if (least > limit) return far;
    for (std::size_t k = 0; k < shape.weights.size(); ++k) {
        const std::size_t at = static_cast<std::size_t>(shape.coordinates) + 4 * k;
        least += 4 * shape.weights[k] * shape.weights[k] * squaredChord(a + at, b + at);
    }
    if (least > limit) return far;
    const double distance = metricDistance(shape, a, b);
    return distance <= bound ? distance : far;
}

}  // namespace kumite
