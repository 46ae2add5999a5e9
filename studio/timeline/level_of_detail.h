#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "studio/timeline/curve_pyramid.h"

namespace kumite::studio {

/// Where the samples of a curve lie: sample i at x0 + i · step pixels. step > 0.
struct SampleAxis {
    double x0 = 0;
    double step = 1;

    double xOf(double sample) const { return x0 + sample * step; }
    double sampleAt(double x) const { return (x - x0) / step; }
};

/// The samples [begin, end) of a curve that a drawing needs, with one more on both sides of
/// [left, right] so that lines go on beyond the edges. Empty where the curve is elsewhere.
struct SampleRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};
SampleRange samplesWithin(const SampleAxis& axis, std::size_t size, double left, double right);

/// What lies in one column of pixels [x, x + 1).
struct CurveColumn {
    double x = 0;
    float low = 0;
    float high = 0;
};

/// Whether so many samples share a pixel that a curve is drawn by columns, not as a line.
bool needsColumns(const SampleAxis& axis);

/// The columns of a curve from `left` to `right`, one pixel each. A column holds every sample in it
/// and the one before, so that neighbouring columns touch and no peak is ever lost. Columns without
/// a sample are left out.
std::vector<CurveColumn> curveColumns(const CurvePyramid& curve, const SampleAxis& axis,
                                      double left, double right);

/// Thins marks that would fall on each other: of those that share a cell of `cell` pixels the
/// heaviest stays (the first of equals). `xs` in order. Gives indices, in order.
std::vector<std::size_t> heaviestPerCell(std::span<const double> xs,
                                         std::span<const double> weights, double cell);

}  // namespace kumite::studio
