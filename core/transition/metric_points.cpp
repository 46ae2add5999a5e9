#include "core/transition/metric_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kumite {
namespace {

double squaredCoordinates(const MetricShape& shape, const double* a, const double* b) {
    // Four sums side by side, which the processor adds at once.
    double sums[4] = {0, 0, 0, 0};
    int i = 0;
    for (; i + 4 <= shape.coordinates; i += 4) {
        for (int j = 0; j < 4; ++j)
            sums[j] += (a[i + j] - b[i + j]) * (a[i + j] - b[i + j]);
    }
    for (; i < shape.coordinates; ++i)
        sums[0] += (a[i] - b[i]) * (a[i] - b[i]);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
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
    const double* p = a + shape.coordinates;
    const double* q = b + shape.coordinates;
    // An angle is at least twice its chord: what is too far by chords needs no arc sine. A chord's
    // square is 2 − 2 |p · q|, to within rounding.
    const double limit = bound * bound * (1 + 1e-12) + 1e-12;
    double least = 0;
    for (std::size_t k = 0; k < shape.weights.size(); ++k, p += 4, q += 4) {
        const double dot = (p[0] * q[0] + p[1] * q[1]) + (p[2] * q[2] + p[3] * q[3]);
        const double weight = shape.weights[k];
        least += 8 * weight * weight * (1 - std::abs(dot));
        if (least > limit) return far;
    }
    const double coordinates = squaredCoordinates(shape, a, b);
    if (least + coordinates > limit) return far;
    const double distance =
        std::sqrt(coordinates + squaredAngles(shape, a + shape.coordinates, b + shape.coordinates));
    return distance <= bound ? distance : far;
}

}  // namespace kumite
