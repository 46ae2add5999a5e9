#pragma once

#include <QRectF>

#include <memory>

#include "core/project/analysis.h"
#include "studio/timeline/curve_pyramid.h"
#include "studio/timeline/time_mapping.h"

namespace kumite::studio {

/// One fighter's row of the timeline: its curves made ready for drawing, and where its parts lie.
class Track {
public:
    /// Takes over a fighter's values; curves that did not change are kept. Null: nothing to show.
    void setFighter(const FighterAnalysis* fighter);
    void setGeometry(const QRectF& row, double leftGutter, double rightGutter);

    bool hasCurve() const { return force_ != nullptr && forceCurve_.size() > 0; }
    const CurvePyramid& forceCurve() const { return forceCurve_; }
    const CurvePyramid& height() const { return height_; }

    QRectF row() const { return row_; }
    /// Where the curves are, and the strip of actions below them.
    QRectF plot() const { return plot_; }
    QRectF strip() const { return strip_; }

    /// The force axis goes over these body weights; it begins at 0 where the curve comes near it.
    double forceLow() const { return forceLow_; }
    double forceTop() const { return forceTop_; }
    /// The height axis goes over these metres.
    double heightLow() const { return heightLow_; }
    double heightHigh() const { return heightHigh_; }
    double yOfForce(double bodyWeights) const;
    double yOfHeight(double metres) const;

private:
    std::shared_ptr<const FighterForce> force_;
    CurvePyramid forceCurve_;
    CurvePyramid height_;
    double forceLow_ = 0;
    double forceTop_ = 2;
    double heightLow_ = 0;
    double heightHigh_ = 1;
    QRectF row_, plot_, strip_;
};

}  // namespace kumite::studio
