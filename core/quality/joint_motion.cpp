#include "core/quality/joint_motion.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Angular velocity, in the parent's axes, that turns `a` into `b` within 1 / rate.
Vector3d velocityBetween(const Quaterniond& a, const Quaterniond& b, double rate) {
    const Quaterniond step = b * a.conjugate();
    const double sign = step.w() < 0 ? -1.0 : 1.0;
    const double sine = step.vec().norm();
    if (sine < 1e-12) return Vector3d::Zero();
    return (2.0 * rate * std::atan2(sine, sign * step.w()) * sign / sine) * step.vec();
}

/// Per frame: does it lie at a join?
std::vector<bool> framesAtJoins(int frames, std::span<const int> joins, int after) {
    std::vector<bool> at(static_cast<std::size_t>(frames), false);
    for (const int join : joins) {
        for (int frame = std::max(0, join - 1); frame < std::min(frames, join + after + 1); ++frame)
            at[static_cast<std::size_t>(frame)] = true;
    }
    return at;
}

std::vector<std::size_t> jointsWithRoles(const Rig& rig) {
    std::vector<std::size_t> joints;
    for (const Role role : allRoles()) {
        if (const auto joint = rig.roles[role]; joint && !rig.joint(*joint).isEndSite)
            joints.push_back(static_cast<std::size_t>(*joint));
    }
    std::sort(joints.begin(), joints.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    return joints;
}

}  // namespace

JoinMotion measureJoins(const Clip& clip, std::span<const int> joins, double after) {
    JoinMotion result;
    const int frames = clip.frameCount();
    const auto at = framesAtJoins(frames, joins, static_cast<int>(std::lround(after * clip.rate)));
    for (const std::size_t joint : jointsWithRoles(*clip.rig)) {
        Vector3d before = Vector3d::Zero();
        for (int frame = 0; frame + 1 < frames; ++frame) {
            const auto i = static_cast<std::size_t>(frame);
            const Vector3d velocity = velocityBetween(clip.frames[i].turns[joint],
                                                      clip.frames[i + 1].turns[joint], clip.rate);
            JointMotion& part = at[i] ? result.atJoins : result.inside;
            part.velocity.push_back(static_cast<float>(velocity.norm()));
            if (frame > 0) {
                part.acceleration.push_back(
                    static_cast<float>((velocity - before).norm() * clip.rate));
            }
            before = velocity;
        }
    }
    return result;
}

double percentile(std::vector<float> values, double p) {
    if (values.empty()) return 0;
    const double rank = std::clamp(p, 0.0, 1.0) * static_cast<double>(values.size() - 1);
    const auto below = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), below, values.end());
    if (below + 1 == values.end()) return *below;
    const double upper = *std::min_element(below + 1, values.end());
    return *below + (rank - std::floor(rank)) * (upper - *below);
}

JointMotionBar barOf(const JointMotion& motion) {
    return {percentile(motion.velocity, 0.99), percentile(motion.acceleration, 0.99)};
}

}  // namespace kumite
