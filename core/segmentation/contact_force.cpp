#include "core/segmentation/contact_force.h"

#include "core/segmentation/low_pass.h"

namespace kumite {
namespace {

std::vector<Eigen::Vector3d> smooth(std::span<const Eigen::Vector3d> path, double rate,
                                    double cutoff) {
    std::vector<Eigen::Vector3d> result(path.size());
    std::vector<double> samples(path.size());
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < path.size(); ++i)
            samples[i] = path[i][axis];
        const std::vector<double> smoothed = lowPass(samples, rate, cutoff);
        for (std::size_t i = 0; i < path.size(); ++i)
            result[i][axis] = smoothed[i];
    }
    return result;
}

}  // namespace

ContactForce contactForce(std::span<const Eigen::Vector3d> com, double rate, double cutoff,
                          ForceCurve which) {
    ContactForce result;
    result.smoothed = cutoff < rate / 2;
    result.smoothedCom = result.smoothed ? smooth(com, rate, cutoff)
                                         : std::vector<Eigen::Vector3d>(com.begin(), com.end());
    const std::size_t n = com.size();
    const Eigen::Vector3d standing = Eigen::Vector3d::UnitY();
    result.force.assign(n, standing);
    const std::vector<Eigen::Vector3d>& c = result.smoothedCom;
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const Eigen::Vector3d acceleration = (c[i - 1] - 2 * c[i] + c[i + 1]) * rate * rate;
        result.force[i] = acceleration / kGravity + standing;
    }
    if (n >= 3) {
        result.force.front() = result.force[1];
        result.force.back() = result.force[n - 2];
    }
    result.curve.reserve(n);
    for (const Eigen::Vector3d& f : result.force) {
        result.curve.push_back(which == ForceCurve::Norm ? f.norm() : f.y());
    }
    return result;
}

}  // namespace kumite
