#pragma once

#include <QRectF>

#include <array>
#include <memory>
#include <vector>

#include "core/project/analysis.h"
#include "studio/timeline/curve_pyramid.h"
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

/// Curves of a fighter that are shown on wish. For an hour they take so long to make that they are
/// made beside the window.
struct WishedCurves {
    CurvePyramid rawForce;
    std::vector<SpeedRow> speeds;
};

/// All that these curves are made from; equal wishes give equal curves.
struct CurveWish {
    std::shared_ptr<const FighterMotion> motion;
    std::shared_ptr<const FighterBody> body;  ///< null: no force
    std::shared_ptr<const Motion> recording;
    RoleMap roles;
    double rate = 0;
    ForceCurve curve = ForceCurve::Norm;
    bool rawForce = false;
    bool hands = false;
    bool feet = false;

    CurveWish() = default;
    CurveWish(const FighterAnalysis* fighter, const TimelineOptions& options, ForceCurve curve);

    bool operator==(const CurveWish&) const = default;
    /// Whether there is anything to make.
    bool any() const { return motion && (rawForce || hands || feet); }
};

/// Runs on any thread.
WishedCurves makeCurves(const CurveWish& wish);
/// The same rows, still without curves.
WishedCurves emptyCurves(const CurveWish& wish);

}  // namespace kumite::studio
