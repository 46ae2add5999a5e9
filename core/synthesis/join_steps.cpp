#include "core/synthesis/join_steps.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

constexpr double kNoStep = 0.03;        ///< metres that a foot may slide over
constexpr double kFarthestHeld = 0.18;  ///< metres that a standing foot may be from its next place
constexpr double kLeastLift = 0.02;     ///< metres, and
constexpr double kLiftPerMetre = 0.5;
constexpr double kHighestLift = 0.09;  ///< metres
constexpr double kRise = 0.3;          ///< share of the join in which a foot is lifted and set down
constexpr double kSharpestBend = 2.65;  ///< radians at a knee or elbow, from straight

constexpr std::array kAnkles = {Role::LeftAnkle, Role::RightAnkle};

}  // namespace

JoinSteps::JoinSteps(const Rig& rig, const Pose& shown, const Pose& next, Standing standsNow,
                     Standing standsNext, double seconds)
    : seconds_(seconds) {
    for (const Role end : {Role::LeftWrist, Role::RightWrist, Role::LeftAnkle, Role::RightAnkle}) {
        const auto limb = limbOf(rig, end);
        if (!limb) continue;
        const double w = next.turns[static_cast<std::size_t>(limb->middle)].w();
        hinges_.push_back({limb->middle, w < 0 ? -1.0 : 1.0});
    }
    JointFrames from, to;
    jointFrames(rig, shown, from);
    jointFrames(rig, next, to);
    std::array<double, 2> way{};
    std::array<bool, 2> held{};
    for (const std::size_t side : {0, 1}) {
        const auto point = footPoint(rig, side == 0);
        if (!point) continue;
        const auto joint = static_cast<std::size_t>(*point);
        const Eigen::Vector3d d = to.positions[joint] - from.positions[joint];
        way[side] = std::hypot(d.x(), d.z());
        held[side] = standsNow[side] && standsNext[side] && way[side] <= kFarthestHeld;
    }
    // Of two standing feet that are both far from their places, one stays.
    const bool bothStand =
        standsNow[0] && standsNext[0] && standsNow[1] && standsNext[1] && !held[0] && !held[1];
    if (bothStand) held[way[0] < way[1] ? 0 : 1] = true;
    for (const std::size_t side : {0, 1}) {
        if (held[side] || way[side] < kNoStep) continue;
        steps_[side].leg = limbOf(rig, kAnkles[side]);
        steps_[side].height = std::min(kLeastLift + kLiftPerMetre * way[side], kHighestLift);
    }
}

void JoinSteps::apply(const Rig& rig, Pose& pose, Standing& standing, double seconds) const {
    if (over(seconds) || seconds <= 0) return;
    for (const Hinge& hinge : hinges_) {
        Eigen::Quaterniond& turn = pose.turns[static_cast<std::size_t>(hinge.joint)];
        // Beyond half a turn w changes its sign: the joint has folded through itself.
        const Eigen::Vector3d axis = hinge.side * turn.vec();
        const double angle = 2 * std::atan2(axis.norm(), hinge.side * turn.w());
        if (angle <= kSharpestBend) continue;
        turn = Eigen::Quaterniond(Eigen::AngleAxisd(kSharpestBend, axis.normalized()));
        turn.coeffs() *= hinge.side;
    }
    if (!steps_[0].leg && !steps_[1].leg) return;
    const double rise =
        std::min({1.0, seconds / (kRise * seconds_), (seconds_ - seconds) / (kRise * seconds_)});
    const double arc = rise * rise * (3 - 2 * rise);  // level at both ends and while it goes over
    JointFrames frames;
    jointFrames(rig, pose, frames);
    for (const std::size_t side : {0, 1}) {
        const Step& step = steps_[side];
        if (!step.leg) continue;
        standing[side] = false;
        const Eigen::Vector3d up(0, arc * step.height, 0);
        reach(rig, pose, frames, *step.leg,
              frames.positions[static_cast<std::size_t>(step.leg->end)] + up);
    }
}

}  // namespace kumite
