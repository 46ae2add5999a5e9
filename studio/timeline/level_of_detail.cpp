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
    for (double x = left; x < right; x += 1) {
        const double from = std::max(axis.sampleAt(x), 0.0);
        const double to = std::min(axis.sampleAt(x + 1), last);
        if (from > to) continue;
        const float begin = valueAt(from);
        const float end = valueAt(to);
        CurveColumn column{x, std::min(begin, end), std::max(begin, end)};
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
