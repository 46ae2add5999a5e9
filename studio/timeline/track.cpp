#include "studio/timeline/track.h"

#include <algorithm>
#include <cmath>

#include "studio/app/comfort.h"

namespace kumite::studio {

bool Track::setFighter(const FighterAnalysis* fighter, const TimelineOptions& options,
                       ForceCurve curve) {
    const auto force = fighter ? fighter->force : nullptr;
    const bool sameForce = force == force_;
    const bool sameHeight = sameForce && options.height == withHeight_;
    force_ = force;
    withHeight_ = options.height;
    if (!sameForce) {
        forceCurve_ = CurvePyramid();
        if (force) makeForce();
    }
    if (!sameHeight) {
        height_ = CurvePyramid();
        if (force && options.height) makeHeight(*fighter);
    }
    CurveWish wish(fighter, options, curve);
    if (wish == wish_) return false;
    // What is there stays until the new is made, unless it is of another motion.
    const bool rowsStay =
        wish.motion == wish_.motion && wish.hands == wish_.hands && wish.feet == wish_.feet;
    wish_ = std::move(wish);
    if (!rowsStay) wished_ = emptyCurves(wish_);
    if (!wish_.rawForce) wished_.rawForce = CurvePyramid();
    return wish_.any();
}

void Track::makeForce() {
    forceCurve_ = CurvePyramid(force_->force.curve);
    const CurveExtent forces = forceCurve_.extent();
    forceAxis_ = {std::min(0.5, std::floor(2.0 * forces.low) / 2.0),
                  std::max(1.5, std::ceil(2.0 * forces.high) / 2.0)};
}

void Track::makeHeight(const FighterAnalysis& fighter) {
    const auto& places = force_->force.smoothedCom;
    std::vector<float> heights;
    heights.reserve(places.size());
    const double floor = fighter.body ? fighter.body->floor : 0.0;
    for (const auto& place : places)
        heights.push_back(static_cast<float>(place.y() - floor));
    height_ = CurvePyramid(heights);
    // Ten centimetres of air, so that a still body does not fill the axis with noise.
    const CurveExtent range = height_.extent();
    heightAxis_.low = std::floor(10.0 * range.low) / 10.0;
    heightAxis_.high = std::max(heightAxis_.low + 0.2, std::ceil(10.0 * range.high) / 10.0);
}

void Track::setGeometry(const QRectF& row, double leftGutter, double rightGutter, int laneCount) {
    const double stripHeight = withTextSize(14.0);
    constexpr double kTop = 6;
    constexpr double kGap = 8;
    constexpr double kLowestPlot = 26;
    row_ = row;
    const double left = row.left() + leftGutter;
    const double width = row.width() - leftGutter - rightGutter;
    double bottom = row.bottom() - 4 - stripHeight;
    lanes_ = {};
    if (laneCount > 0) {
        const auto rows = static_cast<double>(wished_.speeds.size());
        const double room =
            bottom - 2 - (row.top() + kTop) - kGap * rows - kLowestPlot * (1 + 0.5 * rows);
        lanes_.height = laneHeight(room, laneCount);
        lanes_.collapsed = lanes_.height == 0;
        const double height = lanes_.collapsed ? stripHeight : lanes_.height * laneCount;
        bottom -= height + 2;
        lanes_.area = QRectF(left, bottom + stripHeight + 2, width, height);
    }
    strip_ = QRectF(left, bottom, width, stripHeight);
    // Speeds get half as much room as the force each.
    const auto rows = static_cast<double>(wished_.speeds.size());
    const double room = bottom - 3 - (row.top() + kTop) - kGap * rows;
    const double each = room / (2 + rows);
    plot_ = QRectF(left, row.top() + kTop, width, 2 * each);
    double top = plot_.bottom() + kGap;
    for (SpeedRow& speed : wished_.speeds) {
        speed.plot = QRectF(left, top, width, each);
        top += each + kGap;
    }
}

}  // namespace kumite::studio
