#include "core/motion/heading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kumite {
namespace {

/// Horizontal share of the forward direction below which it is "nearly vertical": 78° up or down.
constexpr double kVertical = 0.2;

/// An axis of the file without scale: toWorld is linear, so its transpose leads back.
Eigen::Matrix3d worldAxes(const SpaceConvention& space) {
    const SpaceConvention unit{1.0, space.up};
    Eigen::Matrix3d axes;
    for (int axis = 0; axis < 3; ++axis)
        axes.col(axis) = unit.toWorld(Eigen::Vector3d::Unit(axis));
    return axes;
}

/// The coordinate axis (with sign) nearest to a direction.
Eigen::Vector3d nearestAxis(const Eigen::Vector3d& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return std::copysign(1.0, direction[axis]) * Eigen::Vector3d::Unit(axis);
}

/// The pelvis and its parents, root first.
std::vector<int> chainTo(const Skeleton& skeleton, int joint) {
    std::vector<int> chain;
    for (; joint >= 0; joint = skeleton.joints[static_cast<std::size_t>(joint)].parent)
        chain.push_back(joint);
    std::reverse(chain.begin(), chain.end());
    return chain;
}

}  // namespace

Eigen::Vector3d restForward(const std::vector<Eigen::Vector3d>& rest, const RoleMap& roles) {
    const auto left = roles[Role::LeftHip];
    const auto right = roles[Role::RightHip];
    if (!left || !right || *left == *right) return Eigen::Vector3d::UnitZ();
    const auto at = [&](int joint) -> const Eigen::Vector3d& {
        return rest[static_cast<std::size_t>(joint)];
    };
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    if (const auto neck = roles[Role::Neck]) {
        const Eigen::Vector3d trunk = at(*neck) - 0.5 * (at(*left) + at(*right));
        if (trunk.norm() > 0) up = nearestAxis(trunk);
    }
    const Eigen::Vector3d forward = (at(*left) - at(*right)).cross(up);
    return forward.norm() > 0 ? forward.normalized() : Eigen::Vector3d::UnitZ();
}

Eigen::Vector3d restForward(const Skeleton& skeleton, const RoleMap& roles,
                            const SpaceConvention& space) {
    const Eigen::Matrix3d axes = worldAxes(space);
    std::vector<Eigen::Vector3d> rest = skeleton.restPositions();
    for (Eigen::Vector3d& position : rest)
        position = axes * position;
    return axes.transpose() * restForward(rest, roles);
}

std::vector<double> headings(const Motion& motion, FrameRange frames, const SpaceConvention& space,
                             const RoleMap& roles) {
    const Skeleton& skeleton = *motion.skeleton;
    const std::vector<int> chain = chainTo(skeleton, roles[Role::Pelvis].value_or(0));
    const Eigen::Vector3d forward = restForward(skeleton, roles, space);
    const Eigen::Matrix3d axes = worldAxes(space);

    std::vector<double> yaw(static_cast<std::size_t>(frames.size()), 0.0);
    std::size_t known = 0;  // frames before it have their yaw
    bool any = false;
    for (std::size_t i = 0; i < yaw.size(); ++i) {
        const auto row = motion.frame(frames.begin + static_cast<int>(i));
        Eigen::Vector3d facing = forward;
        for (auto joint = chain.rbegin(); joint != chain.rend(); ++joint)
            facing = localRotation(skeleton.joints[static_cast<std::size_t>(*joint)], row) * facing;
        facing = axes * facing;
        if (std::hypot(facing.x(), facing.z()) < kVertical) continue;
        yaw[i] = std::atan2(facing.x(), facing.z());
        if (!any) {
            std::fill(yaw.begin(), yaw.begin() + static_cast<std::ptrdiff_t>(i), yaw[i]);
        } else {
            const double before = yaw[known - 1];
            yaw[i] = before + std::remainder(yaw[i] - before, 2 * std::numbers::pi);
            const double step = (yaw[i] - before) / static_cast<double>(i - known + 1);
            for (std::size_t gap = known; gap < i; ++gap)
                yaw[gap] = before + step * static_cast<double>(gap - known + 1);
        }
        known = i + 1;
        any = true;
    }
    if (any) {
        std::fill(yaw.begin() + static_cast<std::ptrdiff_t>(known), yaw.end(), yaw[known - 1]);
    }
    return yaw;
}

}  // namespace kumite
