#pragma once

#include <QRectF>

#include <memory>
#include <vector>

#include "core/project/analysis.h"
#include "studio/timeline/curve_pyramid.h"
#include "studio/timeline/lane_painter.h"
#include "studio/timeline/time_mapping.h"
#include "studio/timeline/timeline_options.h"
#include "studio/timeline/wished_curves.h"

namespace kumite::studio {

/// One fighter's row of the timeline: its curves made ready for drawing, and where its parts lie.
class Track {
public:
    /// Takes over a fighter's values; curves that did not change are kept. Null: nothing to show.
    /// `curve`: which force is cut. Curves on wish stay empty until they are made; true: they have
    /// to be (`makeCurves(wish())`).
    bool setFighter(const FighterAnalysis* fighter, const TimelineOptions& options,
                    ForceCurve curve);
    const CurveWish& wish() const { return wish_; }
    void setCurves(WishedCurves curves) { wished_ = std::move(curves); }
    void setGeometry(const QRectF& row, double leftGutter, double rightGutter, int laneCount);

    bool hasCurve() const { return force_ != nullptr && forceCurve_.size() > 0; }
    const CurvePyramid& forceCurve() const { return forceCurve_; }
    /// Empty unless asked for, as the height and the rows of speeds.
    const CurvePyramid& rawForce() const { return wished_.rawForce; }
    const CurvePyramid& height() const { return height_; }
    const std::vector<SpeedRow>& speeds() const { return wished_.speeds; }

    QRectF row() const { return row_; }
    /// Where force and height are, the strip of actions under them, and the lanes under that.
    QRectF plot() const { return plot_; }
    QRectF strip() const { return strip_; }
    const LanePlace& lanes() const { return lanes_; }

    /// The force axis goes over body weights; it begins at 0 where the curve comes near it.
    const ValueAxis& forceAxis() const { return forceAxis_; }
    /// The height axis goes over metres above the floor.
    const ValueAxis& heightAxis() const { return heightAxis_; }
    double yOfForce(double bodyWeights) const { return forceAxis_.yOf(bodyWeights, plot_); }

private:
    void makeForce();
    void makeHeight(const FighterAnalysis& fighter);

    std::shared_ptr<const FighterForce> force_;
    bool withHeight_ = false;
    CurvePyramid forceCurve_;
    CurvePyramid height_;
    CurveWish wish_;
    WishedCurves wished_;
    ValueAxis forceAxis_{0, 2};
    ValueAxis heightAxis_{0, 1};
    QRectF row_, plot_, strip_;
    LanePlace lanes_;
};

}  // namespace kumite::studio
