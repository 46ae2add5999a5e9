#include "studio/timeline/wished_curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/motion/feet.h"

namespace kumite::studio {

namespace {

/// The speed that all but one frame in five hundred stay below: a jump of the recording (out of its
/// T-pose, as a rule) must not flatten the rest.
double usualTop(std::vector<float> speeds) {
    if (speeds.empty()) return 0.0;
    const auto rank = speeds.begin() + static_cast<std::ptrdiff_t>((speeds.size() - 1) * 0.998);
    std::nth_element(speeds.begin(), rank, speeds.end());
    return *rank;
}

/// Left and right.
using Sides = std::array<std::optional<int>, 2>;

Sides jointsOf(const CurveWish& wish, bool hands) {
    if (hands) return {wish.roles[Role::LeftWrist], wish.roles[Role::RightWrist]};
    if (!wish.recording) return {};
    const Skeleton& skeleton = *wish.recording->skeleton;
    return {footPoint(skeleton, wish.roles, true), footPoint(skeleton, wish.roles, false)};
}

void fill(SpeedRow& row, const CurveWish& wish) {
    double top = 1.0;
    const Sides joints = jointsOf(wish, row.hands);
    for (std::size_t side = 0; side < joints.size(); ++side) {
        if (!joints[side]) continue;
        const std::vector<float> speed =
            jointSpeed(wish.motion->positions, *joints[side], wish.rate);
        top = std::max(top, usualTop(speed));
        row.sides[side] = CurvePyramid(speed);
    }
    row.axis = {0.0, std::ceil(top)};
}

}  // namespace

CurveWish::CurveWish(const FighterAnalysis* fighter, const TimelineOptions& options,
                     ForceCurve whichForce)
    : curve(whichForce), hands(options.handSpeed), feet(options.footSpeed) {
    if (fighter == nullptr) return;
    motion = fighter->motion;
    body = fighter->force ? fighter->body : nullptr;
    rawForce = options.rawForce && body != nullptr;
    recording = fighter->input.motion;
    roles = fighter->input.roles;
    rate = fighter->input.rate;
}

WishedCurves emptyCurves(const CurveWish& wish) {
    WishedCurves curves;
    if (!wish.motion) return curves;
    for (const bool hands : {true, false}) {
        if (!(hands ? wish.hands : wish.feet)) continue;
        curves.speeds.emplace_back().hands = hands;
    }
    return curves;
}

WishedCurves makeCurves(const CurveWish& wish) {
    WishedCurves curves = emptyCurves(wish);
    for (SpeedRow& row : curves.speeds)
        fill(row, wish);
    if (wish.rawForce) {
        // A cutoff that is not below half of the rate smooths nothing.
        curves.rawForce = CurvePyramid(
            contactForce(wish.body->com.position, wish.rate, wish.rate, wish.curve).curve);
    }
    return curves;
}

}  // namespace kumite::studio
