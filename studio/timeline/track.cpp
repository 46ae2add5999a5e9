#include "studio/timeline/track.h"

#include <algorithm>
#include <cmath>

namespace kumite::studio {

void Track::setFighter(const FighterAnalysis* fighter) {
    const auto force = fighter ? fighter->force : nullptr;
    if (force == force_) return;
    force_ = force;
    forceCurve_ = CurvePyramid();
    height_ = CurvePyramid();
    if (!force) return;
    forceCurve_ = CurvePyramid(force->force.curve);
    std::vector<double> heights;
    heights.reserve(force->force.smoothedCom.size());
    const double floor = fighter->body ? fighter->body->floor : 0.0;
    for (const auto& com : force->force.smoothedCom)
        heights.push_back(com.y() - floor);
    height_ = CurvePyramid(heights);
    // Ten centimetres of air, so that a still body does not fill the axis with noise.
    const CurveExtent range = height_.extent();
    heightLow_ = std::floor(10.0 * range.low) / 10.0;
    heightHigh_ = std::max(heightLow_ + 0.2, std::ceil(10.0 * range.high) / 10.0);
    const CurveExtent forces = forceCurve_.extent();
    forceLow_ = std::min(0.5, std::floor(2.0 * forces.low) / 2.0);
    forceTop_ = std::max(1.5, std::ceil(2.0 * forces.high) / 2.0);
}

void Track::setGeometry(const QRectF& row, double leftGutter, double rightGutter) {
    constexpr double kStripHeight = 14;
    constexpr double kTop = 6;
    row_ = row;
    const double bottom = row.bottom() - 4 - kStripHeight;
    plot_ = QRectF(row.left() + leftGutter, row.top() + kTop,
                   row.width() - leftGutter - rightGutter, bottom - row.top() - kTop - 3);
    strip_ = QRectF(plot_.left(), bottom, plot_.width(), kStripHeight);
}

double Track::yOfForce(double bodyWeights) const {
    const double share = (bodyWeights - forceLow_) / (forceTop_ - forceLow_);
    return plot_.bottom() - share * plot_.height();
}

double Track::yOfHeight(double metres) const {
    const double share = (metres - heightLow_) / (heightHigh_ - heightLow_);
    return plot_.bottom() - share * plot_.height();
}

}  // namespace kumite::studio
