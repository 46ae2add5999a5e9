#include "core/motion/inertialise.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// The rotation vector of a turn, the short way round.
Vector3d vectorOf(const Quaterniond& turn) {
    const double sign = turn.w() < 0 ? -1.0 : 1.0;
    const Vector3d axis = sign * turn.vec();
    const double sine = axis.norm();
    if (sine < 1e-12) return 2.0 * axis;
    return (2.0 * std::atan2(sine, sign * turn.w()) / sine) * axis;
}

Quaterniond turnOf(const Vector3d& vector) {
    const double angle = vector.norm();
    if (angle < 1e-12) return Quaterniond::Identity();
    return Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

/// How fast the rotation vector `v` changes where exp(v) turns with the angular velocity `omega`
/// (inverse left Jacobian of the rotation group).
Vector3d vectorRate(const Vector3d& v, const Vector3d& omega) {
    const double angle = v.norm();
    const Vector3d half = -0.5 * v.cross(omega);
    if (angle < 1e-6) return omega + half;
    const double c = (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / (angle * angle);
    return omega + half + c * v.cross(v.cross(omega));
}

/// The velocity's share of the quintic is at most this times T, at s = 1/3.
constexpr double kPeakOfVelocityTerm = 16.0 / 81.0;

void limit(Vector3d& velocity, double duration, double overshoot) {
    const double most = overshoot / (kPeakOfVelocityTerm * duration);
    const double speed = velocity.norm();
    if (speed > most) velocity *= most / speed;
}

}  // namespace

PoseOffset offsetBetween(const Pose& shown, const Pose& other) {
    PoseOffset offset;
    offset.root = shown.root - other.root;
    offset.turns.reserve(shown.turns.size());
    for (std::size_t i = 0; i < shown.turns.size(); ++i)
        offset.turns.push_back(vectorOf(shown.turns[i] * other.turns[i].conjugate()));
    return offset;
}

Inertialisation::Inertialisation(const Pose& before, const Pose& shown, const Pose& next,
                                 const Pose& after, double dt, const JoinSettings& settings)
    : offset_(offsetBetween(shown, next)), duration_(settings.duration) {
    if (duration_ <= 0) return;
    velocity_.root = ((shown.root - before.root) - (after.root - next.root)) / dt;
    limit(velocity_.root, duration_, settings.overshootRoot);
    velocity_.turns.reserve(shown.turns.size());
    for (std::size_t i = 0; i < shown.turns.size(); ++i) {
        const Vector3d ofShown = vectorOf(shown.turns[i] * before.turns[i].conjugate()) / dt;
        const Vector3d ofNext = vectorOf(after.turns[i] * next.turns[i].conjugate()) / dt;
        // shown = e · next, so the offset e turns by what shown has beyond e · next.
        const Vector3d omega = ofShown - turnOf(offset_.turns[i]) * ofNext;
        Vector3d rate = vectorRate(offset_.turns[i], omega);
        limit(rate, duration_, settings.overshootTurn);
        velocity_.turns.push_back(rate);
    }
}

PoseOffset Inertialisation::at(double seconds) const {
    PoseOffset left;
    left.turns.assign(offset_.turns.size(), Vector3d::Zero());
    if (over(seconds)) return left;
    const double s = std::max(0.0, seconds) / duration_;
    const double cubed = s * s * s;
    const double ofOffset = 1.0 + cubed * (-10.0 + s * (15.0 - 6.0 * s));
    const double ofVelocity = duration_ * (s + cubed * (-6.0 + s * (8.0 - 3.0 * s)));
    left.root = ofOffset * offset_.root + ofVelocity * velocity_.root;
    for (std::size_t i = 0; i < left.turns.size(); ++i)
        left.turns[i] = ofOffset * offset_.turns[i] + ofVelocity * velocity_.turns[i];
    return left;
}

void Inertialisation::apply(Pose& pose, double seconds) const {
    if (over(seconds)) return;
    const PoseOffset left = at(seconds);
    pose.root += left.root;
    for (std::size_t i = 0; i < pose.turns.size(); ++i)
        pose.turns[i] = (turnOf(left.turns[i]) * pose.turns[i]).normalized();
}

Clip joined(const Clip& first, const Clip& second, const JoinSettings& settings) {
    if (first.frames.empty() || second.frames.empty())
        throw Error("A clip without frames cannot be joined.");
    if (first.rate != second.rate || first.rig->joints.size() != second.rig->joints.size())
        throw Error("Clips can be joined only at one rate and on one skeleton.");
    const double dt = 1.0 / first.rate;
    const auto& shown = first.frames;
    const auto& next = second.frames;
    const Inertialisation join(shown[shown.size() - std::min<std::size_t>(2, shown.size())],
                               shown.back(), next.front(),
                               next[std::min<std::size_t>(1, next.size() - 1)], dt, settings);
    Clip clip = first;
    clip.frames.reserve(shown.size() + next.size() - 1);
    for (std::size_t i = 1; i < next.size(); ++i) {
        clip.frames.push_back(next[i]);
        join.apply(clip.frames.back(), static_cast<double>(i) * dt);
    }
    return clip;
}

}  // namespace kumite
