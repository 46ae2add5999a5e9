#pragma once

#include <array>

#include <Eigen/Core>

namespace kumite {

/// Angles in degrees such that `rotation` = R(order[0]) · R(order[1]) · R(order[2]), where order
/// names three different axes (0, 1, 2 for x, y, z). Of the two triples that mean the same
/// rotation, and of their full turns, the one nearest to `before` is taken, so that tracks stay
/// continuous. Where the middle angle is ±90° (gimbal lock) the first angle stays as before.
std::array<double, 3> eulerAngles(const Eigen::Matrix3d& rotation, const std::array<int, 3>& order,
                                  const std::array<double, 3>& before);

/// Rotation by `degrees` about axis 0, 1 or 2.
Eigen::Matrix3d axisRotation(int axis, double degrees);

}  // namespace kumite
