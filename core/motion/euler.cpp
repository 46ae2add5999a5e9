#include "core/motion/euler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kumite {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double nearestTurn(double angle, double before) {
    return angle + 360.0 * std::round((before - angle) / 360.0);
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

}  // namespace

Eigen::Matrix3d axisRotation(int axis, double degrees) {
    return Eigen::AngleAxisd(degrees / kDegrees, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

std::array<double, 3> eulerAngles(const Eigen::Matrix3d& r, const std::array<int, 3>& order,
                                  const std::array<double, 3>& before) {
    const auto [i, j, k] = order;
    // +1 for x→y→z order of the axes and its cyclic shifts, −1 for the others.
    const double sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
    const double sine = std::clamp(sign * r(i, k), -1.0, 1.0);
    // Stable near ±90°, where the arc sine alone loses half of its digits.
    const double middle = std::atan2(sine, std::hypot(r(i, i), r(i, j)));
    if (std::hypot(r(i, i), r(i, j)) < 1e-12) {
        const Eigen::Matrix3d rest = axisRotation(i, before[0]).transpose() * r;
        const Eigen::Matrix3d last = axisRotation(j, middle * kDegrees).transpose() * rest;
        const double third = std::atan2(-sign * last(i, j), last(i, i));
        return {before[0], nearestTurn(middle * kDegrees, before[1]),
                nearestTurn(third * kDegrees, before[2])};
    }
    const double first = std::atan2(-sign * r(j, k), r(k, k)) * kDegrees;
    const double third = std::atan2(-sign * r(i, j), r(i, i)) * kDegrees;
    const double second = middle * kDegrees;

    const auto nearBefore = [&](double a, double b, double c) -> std::array<double, 3> {
        return {nearestTurn(a, before[0]), nearestTurn(b, before[1]), nearestTurn(c, before[2])};
    };
    const std::array<double, 3> one = nearBefore(first, second, third);
    const std::array<double, 3> other = nearBefore(first + 180.0, 180.0 - second, third + 180.0);
    return distance(one, before) <= distance(other, before) ? one : other;
}

}  // namespace kumite
