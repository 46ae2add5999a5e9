#pragma once

#include <QRectF>

#include <array>
#include <memory>
#include <vector>

#include "core/project/analysis.h"
#include "studio/timeline/curve_pyramid.h"
#include "studio/timeline/lane_painter.h"
#include "studio/timeline/time_mapping.h"
#include "studio/timeline/timeline_options.h"

namespace kumite::studio {

/// What is drawn over an interval of values, from the lower to the upper edge of a rectangle.
struct ValueAxis {
    double low = 0;
    double high = 1;

    double yOf(double value, const QRectF& plot) const {
        return plot.bottom() - (value - low) / (high - low) * plot.height();
    }
};

/// A row of speeds: of both hands, or of both feet.
struct SpeedRow {
    bool hands = false;
    std::array<CurvePyramid, 2> sides;  ///< left, right; empty where the body has none
    ValueAxis axis;                     ///< m/s, from 0; rare jumps of a recording go beyond
    QRectF plot;
};

/// One fighter's row of the timeline: its curves made ready for drawing, and where its parts lie.
class Track {
public:
    /// Takes over a fighter's values; curves that did not change are kept. Null: nothing to show.
    /// `curve`: which force is cut.
    void setFighter(const FighterAnalysis* fighter, const TimelineOptions& options,
                    ForceCurve curve);
    void setGeometry(const QRectF& row, double leftGutter, double rightGutter, int laneCount);

    bool hasCurve() const { return force_ != nullptr && forceCurve_.size() > 0; }
    const CurvePyramid& forceCurve() const { return forceCurve_; }
    /// Empty unless asked for, as the height and the rows of speeds.
    const CurvePyramid& rawForce() const { return rawForce_; }
    const CurvePyramid& height() const { return height_; }
    const std::vector<SpeedRow>& speeds() const { return speeds_; }

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
    void makeForce(const FighterAnalysis& fighter, const TimelineOptions& options,
                   ForceCurve curve);
    void makeSpeeds(const FighterAnalysis& fighter, const TimelineOptions& options);

    std::shared_ptr<const FighterForce> force_;
    std::shared_ptr<const FighterMotion> motion_;
    RoleMap roles_;
    TimelineOptions options_;
    CurvePyramid forceCurve_;
    CurvePyramid rawForce_;
    CurvePyramid height_;
    std::vector<SpeedRow> speeds_;
    ValueAxis forceAxis_{0, 2};
    ValueAxis heightAxis_{0, 1};
    QRectF row_, plot_, strip_;
    LanePlace lanes_;
};

}  // namespace kumite::studio
