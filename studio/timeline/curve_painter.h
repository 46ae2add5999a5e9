#pragma once

#include <QColor>
#include <QRectF>

#include "studio/timeline/level_of_detail.h"
#include "studio/timeline/track.h"

class QPainter;

namespace kumite::studio {

/// Draws a curve into a plot, as a line where its samples are apart and by columns where many share
/// a pixel: the time it takes depends on the width, not on the length.
void paintCurve(QPainter& painter, const CurvePyramid& curve, const SampleAxis& axis,
                const ValueAxis& values, const QRectF& plot, const QColor& colour, double width);

}  // namespace kumite::studio
