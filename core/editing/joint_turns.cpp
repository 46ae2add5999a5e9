#include "core/editing/joint_turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond parentTurn(const Rig& rig, const JointFrames& frames, int joint) {
    const int parent = rig.joint(joint).parent;
    return parent < 0 ? Quaterniond::Identity() : frames.turns[static_cast<std::size_t>(parent)];
}

}  // namespace

void turnInSpace(const Rig& rig, Pose& pose, const JointFrames& frames, int joint,
                 const Quaterniond& turn) {
    const Quaterniond parent = parentTurn(rig, frames, joint);
    Quaterniond& local = pose.turns[static_cast<std::size_t>(joint)];
    local = (parent.conjugate() * turn * parent * local).normalized();
}

void setTurnInSpace(const Rig& rig, Pose& pose, const JointFrames& frames, int joint,
                    const Quaterniond& turn) {
    pose.turns[static_cast<std::size_t>(joint)] =
        (parentTurn(rig, frames, joint).conjugate() * turn).normalized();
}

JointTurn aimingTurn(int joint, const Vector3d& pivot, const Vector3d& from, const Vector3d& to,
                     double limit, const std::optional<Vector3d>& axis) {
    JointTurn turn{joint, axis.value_or(Vector3d::UnitY()), 0};
    Vector3d a = from - pivot, b = to - pivot;
    if (axis) {
        a -= a.dot(*axis) * *axis;
        b -= b.dot(*axis) * *axis;
    }
    constexpr double kNear = 1e-6;
    if (a.norm() < kNear || b.norm() < kNear) return turn;
    const Vector3d across = a.cross(b);
    double angle = std::atan2(across.norm(), a.dot(b));
    if (axis) {
        if (across.dot(*axis) < 0) angle = -angle;
    } else {
        if (across.norm() < 1e-12) return turn;
        turn.axis = across.normalized();
    }
    turn.angle = std::clamp(angle, -limit, limit);
    return turn;
}

double yawOf(const Rig& rig, const Quaterniond& turn) {
    const Vector3d facing = turn * rig.forward;
    return std::atan2(facing.x(), facing.z());
}

double wrapped(double angle) {
    return std::remainder(angle, 2 * std::numbers::pi);
}

}  // namespace kumite
