#include "studio/timeline/track.h"

#include <algorithm>
#include <cmath>

#include "core/motion/feet.h"

namespace kumite::studio {

namespace {

std::vector<float> speedOf(const FighterAnalysis& fighter, std::optional<int> joint) {
    if (!joint) return {};
    return jointSpeed(fighter.motion->positions, *joint, fighter.input.rate);
}

/// The speed that all but one frame in five hundred stay below: a jump of the recording (out of its
/// T-pose, as a rule) must not flatten the rest.
double usualTop(std::vector<float> speeds) {
    if (speeds.empty()) return 0.0;
    const auto rank = speeds.begin() + static_cast<std::ptrdiff_t>((speeds.size() - 1) * 0.998);
    std::nth_element(speeds.begin(), rank, speeds.end());
    return *rank;
}

}  // namespace

void Track::setFighter(const FighterAnalysis* fighter, const TimelineOptions& options,
                       ForceCurve curve) {
    const auto force = fighter ? fighter->force : nullptr;
    const auto motion = fighter ? fighter->motion : nullptr;
    const RoleMap roles = fighter ? fighter->input.roles : RoleMap();
    const bool sameForce = force == force_ && options.height == options_.height &&
                           options.rawForce == options_.rawForce;
    const bool sameSpeeds = motion == motion_ && roles == roles_ &&
                            options.handSpeed == options_.handSpeed &&
                            options.footSpeed == options_.footSpeed;
    force_ = force;
    motion_ = motion;
    roles_ = roles;
    options_ = options;
    if (!sameForce) {
        forceCurve_ = rawForce_ = height_ = CurvePyramid();
        if (force) makeForce(*fighter, options, curve);
    }
    if (!sameSpeeds) {
        speeds_.clear();
        if (motion) makeSpeeds(*fighter, options);
    }
}

void Track::makeForce(const FighterAnalysis& fighter, const TimelineOptions& options,
                      ForceCurve curve) {
    const ContactForce& force = fighter.force->force;
    forceCurve_ = CurvePyramid(force.curve);
    const CurveExtent forces = forceCurve_.extent();
    forceAxis_ = {std::min(0.5, std::floor(2.0 * forces.low) / 2.0),
                  std::max(1.5, std::ceil(2.0 * forces.high) / 2.0)};
    if (options.rawForce && fighter.body) {
        // A cutoff that is not below half of the rate smooths nothing.
        const double rate = fighter.input.rate;
        rawForce_ = CurvePyramid(contactForce(fighter.body->com.position, rate, rate, curve).curve);
    }
    if (!options.height) return;
    std::vector<double> heights;
    heights.reserve(force.smoothedCom.size());
    const double floor = fighter.body ? fighter.body->floor : 0.0;
    for (const auto& com : force.smoothedCom)
        heights.push_back(com.y() - floor);
    height_ = CurvePyramid(heights);
    // Ten centimetres of air, so that a still body does not fill the axis with noise.
    const CurveExtent range = height_.extent();
    heightAxis_.low = std::floor(10.0 * range.low) / 10.0;
    heightAxis_.high = std::max(heightAxis_.low + 0.2, std::ceil(10.0 * range.high) / 10.0);
}

void Track::makeSpeeds(const FighterAnalysis& fighter, const TimelineOptions& options) {
    const auto add = [&](bool hands, std::optional<int> left, std::optional<int> right) {
        SpeedRow row;
        row.hands = hands;
        double top = 1.0;
        for (const std::size_t side : {0U, 1U}) {
            const std::vector<float> speed = speedOf(fighter, side == 0 ? left : right);
            top = std::max(top, usualTop(speed));
            row.sides[side] = CurvePyramid(std::vector<double>(speed.begin(), speed.end()));
        }
        row.axis = {0.0, std::ceil(top)};
        speeds_.push_back(std::move(row));
    };
    const RoleMap& roles = fighter.input.roles;
    if (options.handSpeed) add(true, roles[Role::LeftWrist], roles[Role::RightWrist]);
    if (!options.footSpeed || !fighter.input.motion) return;
    const Skeleton& skeleton = *fighter.input.motion->skeleton;
    add(false, footPoint(skeleton, roles, true), footPoint(skeleton, roles, false));
}

void Track::setGeometry(const QRectF& row, double leftGutter, double rightGutter, int laneCount) {
    constexpr double kStripHeight = 14;
    constexpr double kTop = 6;
    constexpr double kGap = 8;
    constexpr double kLowestPlot = 26;
    row_ = row;
    const double left = row.left() + leftGutter;
    const double width = row.width() - leftGutter - rightGutter;
    double bottom = row.bottom() - 4 - kStripHeight;
    lanes_ = {};
    if (laneCount > 0) {
        const auto rows = static_cast<double>(speeds_.size());
        const double room =
            bottom - 2 - (row.top() + kTop) - kGap * rows - kLowestPlot * (1 + 0.5 * rows);
        lanes_.height = laneHeight(room, laneCount);
        lanes_.collapsed = lanes_.height == 0;
        const double height = lanes_.collapsed ? kStripHeight : lanes_.height * laneCount;
        bottom -= height + 2;
        lanes_.area = QRectF(left, bottom + kStripHeight + 2, width, height);
    }
    strip_ = QRectF(left, bottom, width, kStripHeight);
    // Speeds get half as much room as the force each.
    const auto rows = static_cast<double>(speeds_.size());
    const double room = bottom - 3 - (row.top() + kTop) - kGap * rows;
    const double each = room / (2 + rows);
    plot_ = QRectF(left, row.top() + kTop, width, 2 * each);
    double top = plot_.bottom() + kGap;
    for (SpeedRow& speed : speeds_) {
        speed.plot = QRectF(left, top, width, each);
        top += each + kGap;
    }
}

}  // namespace kumite::studio
