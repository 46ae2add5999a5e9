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

/// What lies in one column of pixels [x, x + 1).
struct CurveColumn {
    double x = 0;
    float low = 0;
    float high = 0;
};

/// The columns of a curve, drawn as a line from sample to sample, from `left` to `right`, one pixel
/// each: the lowest and highest point of the line in each, so that neighbouring columns touch and
/// no peak is ever lost, whatever the zoom. Columns beyond the curve's ends are left out.
std::vector<CurveColumn> curveColumns(const CurvePyramid& curve, const SampleAxis& axis,
                                      double left, double right);

/// Thins marks that would fall on each other: of those that share a cell of `cell` pixels the
/// heaviest stays (the first of equals). `xs` in order. Gives indices, in order.
std::vector<std::size_t> heaviestPerCell(std::span<const double> xs,
                                         std::span<const double> weights, double cell);

}  // namespace kumite::studio
