#include "core/transition/bezier.h"

#include <cassert>

#include "core/motion/blend.h"

namespace kumite {

std::vector<int> medoidWalk(const PoseTree& centres, int source, int target) {
    const MetricPoints& points = centres.points();
    const auto distance = [&](int a, int b) {
        return metricDistance(points.shape, points.at(a), points.at(b));
    };
    std::vector<double> toTarget(static_cast<std::size_t>(centres.count()));
    for (int i = 0; i < centres.count(); ++i)
        toTarget[static_cast<std::size_t>(i)] = distance(i, target);
    std::vector<int> walk = {source};
    while (walk.back() != target) {
        const int here = walk.back();
        NearestPoint next;
        for (int i = 0; i < centres.count(); ++i) {
            if (!(toTarget[static_cast<std::size_t>(i)] < toTarget[static_cast<std::size_t>(here)]))
                continue;
            const double d =
                metricDistanceWithin(points.shape, points.at(i), points.at(here), next.distance);
            if (d < next.distance) next = {i, d};
        }
        // Another centre at the target's place leaves nothing nearer: then the target is next.
        walk.push_back(next.id < 0 ? target : next.id);
    }
    return walk;
}

Pose meanPose(std::span<const Pose> poses) {
    assert(!poses.empty());
    Pose mean = poses.front();
    mean.root.setZero();
    for (const Pose& pose : poses)
        mean.root += pose.root / static_cast<double>(poses.size());
    for (std::size_t joint = 0; joint < mean.turns.size(); ++joint) {
        const Eigen::Quaterniond& first = poses.front().turns[joint];
        Eigen::Vector4d sum = Eigen::Vector4d::Zero();
        for (const Pose& pose : poses) {
            const Eigen::Quaterniond& turn = pose.turns[joint];
            sum += turn.dot(first) < 0 ? Eigen::Vector4d(-turn.coeffs()) : turn.coeffs();
        }
        if (sum.norm() > 1e-9) mean.turns[joint].coeffs() = sum.normalized();
    }
    return mean;
}

Pose PoseCurve::at(double u) const {
    std::array<Pose, 4> level = points;
    for (std::size_t count = 3; count > 0; --count) {
        for (std::size_t i = 0; i < count; ++i)
            level[i] = blend(level[i], level[i + 1], u);
    }
    return level[0];
}

PoseCurve curveThrough(const Pose& source, std::span<const Pose> visited, const Pose& target) {
    if (visited.empty()) {
        return {{source, blend(source, target, 1.0 / 3), blend(source, target, 2.0 / 3), target}};
    }
    const std::size_t half = (visited.size() + 1) / 2;
    return {{source, meanPose(visited.first(half)), meanPose(visited.last(half)), target}};
}

}  // namespace kumite
