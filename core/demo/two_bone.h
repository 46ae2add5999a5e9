#pragma once

#include <Eigen/Core>

namespace kumite::demo {

/// Where the middle joint of a limb lies that spans from `root` to `end`: in the plane of `pole`,
/// on its side. A target too far or too near is brought within
/// what a knee or elbow can do. Lengths in metres.
struct TwoBone {
    Eigen::Vector3d middle;
    Eigen::Vector3d end;
};

TwoBone bend(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
             const Eigen::Vector3d& pole, double upper, double lower);

/// The rotation that takes y to `along` and turns z as near to `ahead` as it can.
Eigen::Matrix3d turnWithY(const Eigen::Vector3d& along, const Eigen::Vector3d& ahead);

/// The rotation that takes x to `along` and turns y as near to `above` as it can.
Eigen::Matrix3d turnWithX(const Eigen::Vector3d& along, const Eigen::Vector3d& above);

/// Rotations about the axes, right-handed, radians.
Eigen::Matrix3d aboutX(double angle);
Eigen::Matrix3d aboutY(double angle);
Eigen::Matrix3d aboutZ(double angle);

}  // namespace kumite::demo
