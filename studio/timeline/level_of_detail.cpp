#include "studio/timeline/level_of_detail.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kumite::studio {

std::vector<CurveColumn> curveColumns(const CurvePyramid& curve, const SampleAxis& axis,
                                      double left, double right) {
    std::vector<CurveColumn> columns;
    if (curve.size() == 0) return columns;
    columns.reserve(static_cast<std::size_t>(std::max(0.0, right - left)) + 1);
    const auto last = static_cast<double>(curve.size() - 1);
    const auto valueAt = [&](double sample) {
        const auto before = static_cast<std::size_t>(sample);
        const float value = curve.at(before);
        const auto share = static_cast<float>(sample - static_cast<double>(before));
        return share > 0 ? value + share * (curve.at(before + 1) - value) : value;
    };
    // Neighbouring columns share an edge, and the value there.
    double next = axis.sampleAt(left);
    float edge = valueAt(std::clamp(next, 0.0, last));
    for (double x = left; x < right; x += 1) {
        const double from = std::max(next, 0.0);
        next = axis.sampleAt(x + 1);
        if (from > last) break;
        if (next <= 0) continue;
        const double to = std::min(next, last);
        const float begin = edge;
        edge = valueAt(to);
        CurveColumn column{x, std::min(begin, edge), std::max(begin, edge)};
        const auto first = static_cast<std::size_t>(std::ceil(from));
        const auto beyond = static_cast<std::size_t>(to) + 1;
        if (first < beyond) {
            const CurveExtent extent = curve.extent(first, beyond);
            column.low = std::min(column.low, extent.low);
            column.high = std::max(column.high, extent.high);
        }
        columns.push_back(column);
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
