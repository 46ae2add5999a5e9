#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/gravity.h"

namespace kumite {

/// Which curve is cut at its minima: the length of the force (default) or its vertical part.
enum class ForceCurve { Norm, Vertical };

/// The force that a fighter exerts against the ground, f(t) = (c̈(t) − g) / |g|: in body weights,
/// so that standing still reads 1 (paper A, section 3.1; method A2).
struct ContactForce {
    std::vector<Eigen::Vector3d> smoothedCom;  ///< metres, y up
    std::vector<Eigen::Vector3d> force;        ///< body weights, y up
    std::vector<double> curve;                 ///< the chosen curve, body weights
    bool smoothed = true;  ///< false where the cutoff is not below half the rate
};

/// 2nd-order Butterworth low-pass at `cutoff` Hz, forward and backward, over `rate` Hz samples;
/// then three-point second differences; the two end values are copied from their neighbours.
/// One or two frames have no acceleration: they read 1. An empty path gives empty arrays.
ContactForce contactForce(std::span<const Eigen::Vector3d> com, double rate, double cutoff,
                          ForceCurve which);

}  // namespace kumite
