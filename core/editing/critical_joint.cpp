#include "core/editing/critical_joint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/euler.h"

namespace kumite {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
/// Deviations below it (radians) are rounding, not motion.
constexpr double kStill = 1e-9;

}  // namespace

AngleTrack unwrapped(AngleTrack angles) {
    for (std::size_t i = 1; i < angles.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double before = angles[i - 1][axis];
            angles[i][axis] =
                before + std::remainder(angles[i][axis] - before, 2 * std::numbers::pi);
        }
    }
    return angles;
}

AngleStatistics statisticsOf(const AngleTrack& angles) {
    AngleStatistics s;
    if (angles.empty()) return s;
    const AngleTrack track = unwrapped(angles);
    const double n = static_cast<double>(track.size());
    for (const Eigen::Vector3d& a : track)
        s.mean += a / n;
    for (const Eigen::Vector3d& a : track)
        s.deviation += (a - s.mean).cwiseAbs2() / n;
    s.deviation = s.deviation.cwiseSqrt();
    return s;
}

AngleTrack adjusted(const AngleTrack& retrieved, const AngleTrack& query) {
    AngleTrack result = unwrapped(retrieved);
    const AngleStatistics r = statisticsOf(result), q = statisticsOf(query);
    for (Eigen::Vector3d& angle : result) {
        for (int axis = 0; axis < 3; ++axis) {
            const double scale =
                r.deviation[axis] > kStill ? q.deviation[axis] / r.deviation[axis] : 0.0;
            angle[axis] = (angle[axis] - r.mean[axis]) * scale + q.mean[axis];
        }
    }
    return result;
}

Eigen::Quaterniond turnOf(const Eigen::Vector3d& angles, const std::array<int, 3>& order) {
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (int k = 0; k < 3; ++k) {
        turn = turn * Eigen::Quaterniond(Eigen::AngleAxisd(
                          angles[k], Eigen::Vector3d::Unit(order[static_cast<std::size_t>(k)])));
    }
    return turn;
}

AngleTrack anglesOf(std::span<const Eigen::Quaterniond> turns, const std::array<int, 3>& order) {
    AngleTrack track;
    std::array<double, 3> before{};
    for (const Eigen::Quaterniond& turn : turns) {
        before = eulerAngles(turn.toRotationMatrix(), order, before);
        track.push_back(Eigen::Vector3d(before[0], before[1], before[2]) / kDegrees);
    }
    return track;
}

std::array<int, 3> safestOrder(std::span<const Eigen::Quaterniond> a,
                               std::span<const Eigen::Quaterniond> b) {
    constexpr std::array<std::array<int, 3>, 6> kOrders = {
        {{2, 0, 1}, {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 1, 0}}};
    std::array<int, 3> best = kOrders[0];
    double least = 2;
    for (const auto& order : kOrders) {
        // The sine of the middle angle is one entry of the matrix.
        double largest = 0;
        for (const auto& turns : {a, b}) {
            for (const Eigen::Quaterniond& turn : turns)
                largest = std::max(largest, std::abs(turn.toRotationMatrix()(order[0], order[2])));
        }
        if (largest < least - 1e-12) {
            least = largest;
            best = order;
        }
    }
    return best;
}

JointAdjustment adjustJoint(std::vector<Eigen::Quaterniond>& retrieved,
                            std::span<const Eigen::Quaterniond> query) {
    JointAdjustment result;
    result.order = safestOrder(retrieved, query);
    const AngleTrack before = anglesOf(retrieved, result.order);
    const AngleTrack wanted = anglesOf(query, result.order);
    const AngleTrack after = adjusted(before, wanted);
    result.query = statisticsOf(wanted);
    result.retrieved = statisticsOf(before);
    result.assembled = statisticsOf(after);
    for (std::size_t i = 0; i < retrieved.size(); ++i)
        retrieved[i] = turnOf(after[i], result.order);
    return result;
}

}  // namespace kumite
