#include "core/synthesis/action_placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kumite {
namespace {

double wrapped(double angle) {
    return std::remainder(angle, 2 * std::numbers::pi);
}

/// From 0 to 1 without a jump in speed or acceleration.
double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (10 + t * (6 * t - 15));
}

Eigen::Vector3d lifted(const Eigen::Vector2d& ground) {
    return {ground.x(), 0, ground.y()};
}

}  // namespace

GroundTransform between(const GroundFrame& recorded, const GroundFrame& now) {
    return between(Station{recorded.origin, recorded.yaw}, Station{now.origin, now.yaw});
}

Station moved(const Station& station, const GroundTransform& transform) {
    const Eigen::Vector3d point = transform * lifted(station.root);
    return {{point.x(), point.z()}, station.yaw + transform.yaw};
}

GroundTransform between(const Station& from, const Station& to) {
    GroundTransform turn;
    turn.yaw = to.yaw - from.yaw;
    const Eigen::Vector3d turned = turn * lifted(from.root);
    turn.x = to.root.x() - turned.x();
    turn.z = to.root.y() - turned.z();
    return turn;
}

ActionPlacement::ActionPlacement(const GroundTransform& wanted, const Station& first,
                                 const Station& shown, double release)
    : wanted_(wanted), release_(release) {
    const Station there = moved(first, wanted);
    turn_ = wrapped(shown.yaw - there.yaw);
    distance_ = (shown.root - there.root).norm();
    shown_ = between(first, Station{shown.root, there.yaw + turn_});
}

Station ActionPlacement::at(const Station& station, double phase) const {
    const double kept = 1 - release_ * smooth(phase);
    const Station there = moved(station, wanted_);
    const Station here = moved(station, shown_);
    const double span = steerTo_ - steerFrom_;
    const double steered = span > 0 ? smooth((phase - steerFrom_) / span) : 1.0;
    return {there.root + kept * (here.root - there.root) + steered * shift_,
            there.yaw + kept * turn_};
}

void ActionPlacement::steer(const Eigen::Vector2d& shift, double fromPhase, double toPhase) {
    shift_ = shift;
    steerFrom_ = fromPhase;
    steerTo_ = toPhase;
}

}  // namespace kumite
