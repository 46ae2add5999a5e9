#include "studio/timeline/level_of_detail.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kumite::studio {

namespace {

/// The first sample at or after x, not limited to the curve.
double firstSampleFrom(const SampleAxis& axis, double x) {
    return std::ceil(axis.sampleAt(x));
}

std::size_t limited(double sample, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(sample, 0.0, static_cast<double>(size)));
}

}  // namespace

SampleRange samplesWithin(const SampleAxis& axis, std::size_t size, double left, double right) {
    const double first = std::floor(axis.sampleAt(left));
    const double last = std::ceil(axis.sampleAt(right));
    return {limited(first, size), limited(last + 1, size)};
}

bool needsColumns(const SampleAxis& axis) {
    return axis.step < 0.67;
}

std::vector<CurveColumn> curveColumns(const CurvePyramid& curve, const SampleAxis& axis,
                                      double left, double right) {
    std::vector<CurveColumn> columns;
    columns.reserve(static_cast<std::size_t>(std::max(0.0, right - left)) + 1);
    std::size_t begin = limited(firstSampleFrom(axis, left), curve.size());
    for (double x = left; x < right; x += 1) {
        const std::size_t end = limited(firstSampleFrom(axis, x + 1), curve.size());
        if (end > begin) {
            const CurveExtent extent = curve.extent(begin > 0 ? begin - 1 : begin, end);
            columns.push_back({x, extent.low, extent.high});
            begin = end;
        }
    }
    return columns;
}

std::vector<std::size_t> heaviestPerCell(std::span<const double> xs,
                                         std::span<const double> weights, double cell) {
    assert(xs.size() == weights.size());
    std::vector<std::size_t> kept;
    double lastCell = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        const double own = std::floor(xs[i] / cell);
        if (kept.empty() || own != lastCell) {
            kept.push_back(i);
        } else if (weights[i] > weights[kept.back()]) {
            kept.back() = i;
        }
        lastCell = own;
    }
    return kept;
}

}  // namespace kumite::studio
