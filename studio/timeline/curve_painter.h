#pragma once

#include <QImage>
#include <QRectF>

#include "studio/timeline/level_of_detail.h"
#include "studio/timeline/track.h"

class QColor;
class QPainter;

namespace kumite::studio {

/// Curves painted over each other into a picture of their own, which then goes onto the timeline as
/// one. A curve is drawn column by column with soft ends, so that the time depends on the width,
/// not on the length, and is the same at any zoom.
class CurvePicture {
public:
    /// `area`: where it will stand, in the painter's coordinates; `ratio`: pixels per coordinate.
    CurvePicture(const QRectF& area, double ratio);

    /// Draws a curve over the values of a plot. What lies outside of the plot, but for the line's
    /// width, is cut off.
    void draw(const CurvePyramid& curve, const SampleAxis& axis, const ValueAxis& values,
              const QRectF& plot, const QColor& colour, double width);
    void paintOnto(QPainter& painter) const;

private:
    QImage image_;
    double ratio_;
    int left_, top_;  ///< of the picture, pixels
};

}  // namespace kumite::studio
