#include "core/transition/pose_metric.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// The turn about the vertical taken away: of all rotations that differ by such a turn, the same.
Quaterniond withoutYaw(const Quaterniond& turn) {
    const double length = std::hypot(turn.w(), turn.y());
    if (length < 1e-9) return turn;
    return Quaterniond(turn.w() / length, 0, -turn.y() / length, 0) * turn;
}

/// The rotation vector from `before` to `after`, in the axes of the joint.
Vector3d turnBetween(const Quaterniond& before, const Quaterniond& after) {
    Quaterniond change = before.conjugate() * after;
    if (change.w() < 0) change.coeffs() = -change.coeffs();
    const double sine = change.vec().norm();
    if (sine < 1e-12) return 2 * change.vec();
    return 2 * std::atan2(sine, change.w()) / sine * change.vec();
}

}  // namespace

std::array<double, kRoleCount> PoseMetricSettings::defaultWeights() {
    std::array<double, kRoleCount> weights{};
    for (const Role role : {Role::Pelvis, Role::Spine, Role::Chest, Role::LeftShoulder,
                            Role::LeftElbow, Role::LeftHip, Role::LeftKnee, Role::RightShoulder,
                            Role::RightElbow, Role::RightHip, Role::RightKnee})
        weights[static_cast<std::size_t>(role)] = 1;
    for (const Role role :
         {Role::Neck, Role::LeftWrist, Role::LeftAnkle, Role::RightWrist, Role::RightAnkle})
        weights[static_cast<std::size_t>(role)] = 0.3;
    return weights;
}

PoseMetric::PoseMetric(const Rig& rig, const PoseMetricSettings& settings)
    : heightWeight_(settings.heightWeight) {
    // Where a skeleton has fewer joints than a body, a joint of several roles counts once.
    std::vector<double> weights(rig.joints.size(), 0.0);
    for (const Role role : allRoles()) {
        const auto joint = rig.roles[role];
        if (!joint || rig.joint(*joint).isEndSite) continue;
        double& weight = weights[static_cast<std::size_t>(*joint)];
        weight = std::max(weight, settings.weights[static_cast<std::size_t>(role)]);
    }
    const int pelvis = rig.roles[Role::Pelvis].value_or(0);
    for (int joint = pelvis; joint >= 0; joint = rig.joint(joint).parent)
        pelvisChain_.insert(pelvisChain_.begin(), joint);
    const auto add = [&](int joint) {
        const double weight = weights[static_cast<std::size_t>(joint)];
        if (weight <= 0) return;
        joints_.push_back({joint, weight * settings.velocityTime});
        shape_.weights.push_back(weight);
    };
    add(pelvis);
    hasPelvis_ = !joints_.empty();
    for (int joint = 0; joint < rig.jointCount(); ++joint) {
        if (joint != pelvis) add(joint);
    }
    shape_.coordinates = 1 + 3 * static_cast<int>(joints_.size());
}

Quaterniond PoseMetric::pelvisTurn(const Pose& pose) const {
    Quaterniond turn = pose.turns[static_cast<std::size_t>(pelvisChain_.front())];
    for (std::size_t i = 1; i < pelvisChain_.size(); ++i)
        turn = turn * pose.turns[static_cast<std::size_t>(pelvisChain_[i])];
    return turn;
}

void PoseMetric::point(std::span<const Pose> frames, int frame, double rate, double* out) const {
    const int before = std::max(0, frame - 1);
    const int after = std::min(static_cast<int>(frames.size()) - 1, frame + 1);
    const Pose& pose = frames[static_cast<std::size_t>(frame)];
    const Pose& earlier = frames[static_cast<std::size_t>(before)];
    const Pose& later = frames[static_cast<std::size_t>(after)];
    const double perSecond = after > before ? rate / (after - before) : 0;
    double* coordinate = out;
    double* rotation = out + shape_.coordinates;
    *coordinate++ = heightWeight_ * pose.root.y();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = joints_[i];
        const auto index = static_cast<std::size_t>(joint.index);
        const bool isPelvis = i == 0 && hasPelvis_;
        const Vector3d velocity = isPelvis ? turnBetween(pelvisTurn(earlier), pelvisTurn(later))
                                           : turnBetween(earlier.turns[index], later.turns[index]);
        for (int axis = 0; axis < 3; ++axis)
            *coordinate++ = joint.velocityScale * perSecond * velocity[axis];
        const Quaterniond turn = isPelvis ? withoutYaw(pelvisTurn(pose)) : pose.turns[index];
        *rotation++ = turn.w();
        *rotation++ = turn.x();
        *rotation++ = turn.y();
        *rotation++ = turn.z();
    }
}

void PoseMetric::points(std::span<const Pose> frames, double rate, MetricPoints& out) const {
    const std::size_t first = out.values.size();
    out.shape = shape_;
    out.values.resize(first + frames.size() * shape_.width());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        point(frames, static_cast<int>(i), rate, out.values.data() + first + i * shape_.width());
    }
}

void PoseMetric::reverse(double* point) const {
    for (int i = 1; i < shape_.coordinates; ++i)
        point[i] = -point[i];
}

}  // namespace kumite
