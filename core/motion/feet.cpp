#include "core/motion/feet.h"

#include <algorithm>
#include <cmath>

#include "core/motion/role_topology.h"

namespace kumite {
namespace {

constexpr double kContactHeight = 0.05;  // metres above the floor
constexpr double kSkateSpeed = 0.5;      // m/s
constexpr double kRestPercentile = 0.05;

/// Per interval: does this foot skate?
std::vector<bool> skates(std::span<const Eigen::Vector3f> toe, double rate, double floor) {
    const std::size_t intervals = toe.size() - 1;
    // Sums of speed up to each interval, so that a window's mean is one subtraction. Outside the
    // take the speed counts as 0 and the divisor stays the window's width.
    std::vector<double> speed(intervals), sum(intervals + 1, 0.0);
    for (std::size_t i = 0; i < intervals; ++i) {
        const Eigen::Vector3d step = (toe[i + 1] - toe[i]).cast<double>();
        speed[i] = std::hypot(step.x(), step.z()) * rate;
        sum[i + 1] = sum[i] + speed[i];
    }
    const auto half = static_cast<std::size_t>(std::floor(0.125 * rate));
    const auto width = static_cast<double>(2 * half + 1);
    std::vector<bool> result(intervals);
    for (std::size_t i = 0; i < intervals; ++i) {
        const std::size_t begin = i > half ? i - half : 0;
        const std::size_t end = std::min(intervals, i + half + 1);
        const double mean = (sum[end] - sum[begin]) / width;
        const bool low =
            toe[i].y() - floor < kContactHeight && toe[i + 1].y() - floor < kContactHeight;
        result[i] = low && speed[i] > kSkateSpeed && mean > kSkateSpeed;
    }
    return result;
}

}  // namespace

std::optional<int> footPoint(const Skeleton& skeleton, const RoleMap& roles, bool left) {
    const auto side = [left](Role role) { return left ? role : mirrored(role); };
    if (const auto toe = roles[side(Role::LeftToe)]) return toe;
    const auto ankle = roles[side(Role::LeftAnkle)];
    if (!ankle) return std::nullopt;
    const auto end = endSiteOf(skeleton, *ankle);
    return end ? end : ankle;
}

double restHeight(const JointPositions& positions, int joint) {
    std::vector<float> heights;
    heights.reserve(static_cast<std::size_t>(positions.frameCount));
    for (int frame = 0; frame < positions.frameCount; ++frame) {
        heights.push_back(positions.data(frame, joint)[1]);
    }
    if (heights.empty()) return 0;
    const double rank = kRestPercentile * static_cast<double>(heights.size() - 1);
    const auto below = heights.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(heights.begin(), below, heights.end());
    const double lower = *below;
    if (below + 1 == heights.end()) return lower;
    const double upper = *std::min_element(below + 1, heights.end());
    return lower + (rank - std::floor(rank)) * (upper - lower);
}

std::optional<double> floorHeight(const Skeleton& skeleton, const RoleMap& roles,
                                  const JointPositions& positions) {
    std::optional<double> floor;
    for (const bool left : {true, false}) {
        const auto joint = footPoint(skeleton, roles, left);
        if (!joint) continue;
        const double height = restHeight(positions, *joint);
        if (!floor || height < *floor) floor = height;
    }
    return floor;
}

std::vector<float> jointSpeed(const JointPositions& positions, int joint, double rate) {
    const int last = positions.frameCount - 1;
    std::vector<float> speed(static_cast<std::size_t>(positions.frameCount), 0.0f);
    for (int frame = 0; last > 0 && frame <= last; ++frame) {
        const int before = std::max(0, frame - 1);
        const int after = std::min(last, frame + 1);
        const float step = (positions.at(after, joint) - positions.at(before, joint)).norm();
        speed[static_cast<std::size_t>(frame)] =
            step * static_cast<float>(rate) / static_cast<float>(after - before);
    }
    return speed;
}

FootSkate measureFootSkate(std::span<const Eigen::Vector3f> leftToe,
                           std::span<const Eigen::Vector3f> rightToe, double rate, double floor) {
    FootSkate skate;
    if (leftToe.size() < 2 || leftToe.size() != rightToe.size()) return skate;
    const std::vector<bool> left = skates(leftToe, rate, floor);
    const std::vector<bool> right = skates(rightToe, rate, floor);
    skate.intervals = static_cast<int>(left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        skate.left += left[i];
        skate.right += right[i];
        skate.either += left[i] || right[i];
    }
    return skate;
}

}  // namespace kumite
