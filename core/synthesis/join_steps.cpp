#include "core/synthesis/join_steps.h"

#include <algorithm>
#include <cmath>

#include "core/motion/inertialise.h"

namespace kumite {
namespace {

using Eigen::Vector3d;

constexpr double kNoStep = 0.03;        ///< metres that a foot may slide over
constexpr double kFarthestHeld = 0.16;  ///< metres that a standing foot may be from its next place
constexpr double kLeastLift = 0.02;     ///< metres, and
constexpr double kLiftPerMetre = 0.5;
constexpr double kHighestLift = 0.09;
constexpr double kLeastStep = 0.3;     ///< seconds that a step from the floor takes, and
constexpr double kLeastFlight = 0.18;  ///< one from the air, and
constexpr double kStepPerMetre = 0.6;
constexpr double kStepPerSpeed = 0.06;  ///< seconds more for each m/s that a flying foot loses
constexpr double kLongestStep = 0.6;
/// A foot this high over the floor is left to the joined motion, wholly from the second height on.
constexpr double kLow = 0.2, kHigh = 0.6;  ///< metres
constexpr double kUpAndDown = 0.2;         ///< share of a step before and after the foot goes over
constexpr double kOverThere = 0.75;        ///< share after which one that lands only goes down
constexpr double kBack = 0.15;             ///< seconds in which one that has arrived is let go
constexpr double kWait = 0.4;              ///< share of a step for which the other foot waits
constexpr double kSharpestBend = 2.65;     ///< radians at a knee or elbow, from straight

constexpr std::array kAnkles = {Role::LeftAnkle, Role::RightAnkle};

/// From 0 to 1 without a jump in speed or acceleration.
double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (10 + t * (6 * t - 15));
}

double level(const Vector3d& way) {
    return std::hypot(way.x(), way.z());
}

/// How far a foot would have to be from where the following motion has it: at the join, or for as
/// long as it stands from the join on.
double wayOf(const FootAtJoin& foot) {
    double way = level(foot.next.front() - foot.place);
    for (int i = 0; foot.landing == 0 && i < foot.lift; ++i)
        way = std::max(way, level(foot.next[static_cast<std::size_t>(i)] - foot.place));
    return way;
}

}  // namespace

double JoinSteps::lookAhead() {
    return kLongestStep;
}

JoinSteps::JoinSteps(const Rig& rig, const Pose& next, const std::array<FootAtJoin, 2>& feet,
                     double rate, double seconds)
    : seconds_(seconds), longest_(seconds) {
    for (const Role end : {Role::LeftWrist, Role::RightWrist, Role::LeftAnkle, Role::RightAnkle}) {
        const auto limb = limbOf(rig, end);
        if (!limb) continue;
        const double w = next.turns[static_cast<std::size_t>(limb->middle)].w();
        hinges_.push_back({limb->middle, w < 0 ? -1.0 : 1.0});
    }
    for (const std::size_t side : {0, 1}) {
        const auto point = footPoint(rig, side == 0);
        if (!point) continue;
        const FootAtJoin& foot = feet[side];
        if (foot.stands && wayOf(foot) <= (foot.landing == 0 ? kFarthestHeld : kNoStep)) continue;
        Step& step = steps_[side];
        step.leg = limbOf(rig, kAnkles[side]);
        step.point = *point;
        plan(step, foot, rate);
    }
    if (guides(0) && guides(1) && feet[0].stands && feet[1].stands) {
        // The one that has to be there first goes first.
        const std::size_t second = steps_[0].end > steps_[1].end ? 0 : 1;
        const double wait = kWait * steps_[1 - second].end;
        steps_[second].begin = wait;
        steps_[second].end += wait;
    }
    for (const std::size_t side : {0, 1}) {
        if (!guides(side)) continue;
        aim(steps_[side], feet[side], rate);
        longest_ = std::max(longest_, steps_[side].end);
    }
}

void JoinSteps::plan(Step& step, const FootAtJoin& foot, double rate) const {
    const Vector3d& next = foot.next.front();
    const bool lands = foot.landing >= 0;
    const double landing = foot.landing / rate;
    const Vector3d& there = lands ? foot.next[static_cast<std::size_t>(foot.landing)] : next;
    step.from = foot.place;
    step.floor = std::min(foot.place.y(), there.y());
    double way = 0;
    const auto needs = [&](double least, double speed) {
        return std::min(least + kStepPerMetre * way + kStepPerSpeed * speed, kLongestStep);
    };
    if (foot.stands) {
        way = lands && landing > 0 ? level(there - foot.place) : wayOf(foot);
        step.end = std::max(lands ? landing : seconds_, needs(kLeastStep, 0));
    } else {
        step.way = Step::Way::Joins;
        step.offset = foot.place - next;
        step.velocity = foot.velocity - rate * (foot.next[1] - next);
        way = level(step.offset);
        step.end = needs(kLeastFlight, level(step.velocity));
        if (lands && landing < step.end) {
            step.way = Step::Way::Lands;
            way = level(foot.place - there);
            step.end = std::max(landing, needs(kLeastFlight, level(foot.velocity)));
        }
    }
    step.height = std::min(kLeastLift + kLiftPerMetre * way, kHighestLift);
}

/// Where a foot goes: if it will stand when it has arrived, half way between where the following
/// motion has it then and last, because the whole body may still be on its way.
void JoinSteps::aim(Step& step, const FootAtJoin& foot, double rate) {
    if (step.way == Step::Way::Joins) return;
    const auto then = static_cast<std::size_t>(std::lround(step.end * rate));
    step.to = foot.next[std::min(then, foot.next.size() - 1)];
    const bool stays = foot.landing >= 0 && then < static_cast<std::size_t>(foot.lift);
    if (stays) step.to = 0.5 * (step.to + foot.next[static_cast<std::size_t>(foot.lift) - 1]);
    step.stops = stays || step.way == Step::Way::Lands;
    if (step.stops) longest_ = std::max(longest_, step.end + kBack);
    if (step.way == Step::Way::Lands) {
        step.offset = foot.place - step.to;
        step.velocity = foot.velocity;
    }
}

void JoinSteps::apply(const Rig& rig, Pose& pose, const Pose& next, Standing& standing,
                      double seconds) const {
    if (over(seconds) || seconds <= 0) return;
    for (const Hinge& hinge : hinges_) {
        Eigen::Quaterniond& turn = pose.turns[static_cast<std::size_t>(hinge.joint)];
        // Beyond half a turn w changes its sign: the joint has folded through itself.
        const Vector3d axis = hinge.side * turn.vec();
        const double angle = 2 * std::atan2(axis.norm(), hinge.side * turn.w());
        if (angle <= kSharpestBend) continue;
        turn = Eigen::Quaterniond(Eigen::AngleAxisd(kSharpestBend, axis.normalized()));
        turn.coeffs() *= hinge.side;
    }
    if (!guides(0) && !guides(1)) return;
    JointFrames frames, nextFrames;
    jointFrames(rig, pose, frames);
    jointFrames(rig, next, nextFrames);
    for (const std::size_t side : {0, 1}) {
        const Step& step = steps_[side];
        if (!step.leg) continue;
        const auto point = static_cast<std::size_t>(step.point);
        const double s = std::clamp((seconds - step.begin) / (step.end - step.begin), 0.0, 1.0);
        if (s < 1) standing[side] = s <= 0 && step.way == Step::Way::Over;
        Vector3d place = nextFrames.positions[point];
        if (s >= 1) {
            if (step.stops)
                place = step.to + smooth((seconds - step.end) / kBack) * (place - step.to);
        } else if (step.way == Step::Way::Over) {
            const double there = smooth((s - kUpAndDown) / (1 - 2 * kUpAndDown));
            place = step.from + there * ((step.stops ? step.to : place) - step.from);
        } else if (step.way == Step::Way::Joins) {
            place += decayed(step.offset, step.velocity, seconds, step.end);
        } else {
            const double height = decayed(step.offset, step.velocity, seconds, step.end).y();
            place = step.to + decayed(step.offset, step.velocity, seconds, kOverThere * step.end);
            place.y() = step.to.y() + height;
        }
        // The higher it is anyway, the less it has to be lifted.
        const double lift = 16 * s * s * (1 - s) * (1 - s) * step.height;
        place.y() += lift * std::exp(-std::max(0.0, place.y() - step.floor) / step.height);
        const Vector3d& shown = frames.positions[point];
        const double high = std::max(shown.y(), place.y()) - step.floor;
        const double guided = 1 - smooth((high - kLow) / (kHigh - kLow));
        if (guided <= 0) continue;
        const Vector3d ankle = frames.positions[static_cast<std::size_t>(step.leg->end)];
        reach(rig, pose, frames, *step.leg, ankle + guided * (place - shown));
    }
}

}  // namespace kumite
