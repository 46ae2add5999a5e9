#include "core/interaction/action_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kumite {
namespace {

constexpr double kTooNear = 0.05;  ///< metres: no direction from one to the other

/// The same angle in (−π, π].
double wrapped(double angle) {
    const double turn = std::remainder(angle, 2 * std::numbers::pi);
    return turn <= -std::numbers::pi ? turn + 2 * std::numbers::pi : turn;
}

}  // namespace

Eigen::Vector2d GroundFrame::toLocal(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d d = point - origin;
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {c * d.x() - s * d.y(), s * d.x() + c * d.y()};
}

GroundFrame groundFrame(const Eigen::Vector2d& moverCom, const Eigen::Vector2d& opponentCom,
                        double moverHeading) {
    const Eigen::Vector2d toOpponent = opponentCom - moverCom;
    const double yaw =
        toOpponent.norm() < kTooNear ? moverHeading : std::atan2(toOpponent.x(), toOpponent.y());
    return {0.5 * (moverCom + opponentCom), yaw};
}

ActionSummary summarise(const FighterTrack& track, const Action& action) {
    const int begin = std::clamp(action.begin, 0, track.frameCount() - 1);
    const int end = std::clamp(action.end, begin + 1, track.frameCount());
    ActionSummary summary;
    summary.frames = end - begin;
    summary.rate = track.rate;
    const auto sample = [&](int frame) -> ActionSummary::Sample {
        return {track.root(frame), track.heading[static_cast<std::size_t>(frame)] + track.yaw,
                track.pose(frame)};
    };
    for (int f = begin; f < end; ++f) {
        const ActionSummary::Sample now = sample(f);
        summary.mean.root += now.root;
        summary.mean.yaw += now.yaw;
        summary.mean.pose += now.pose;
    }
    summary.mean.root /= summary.frames;
    summary.mean.yaw /= summary.frames;
    summary.mean.pose /= summary.frames;
    summary.first = sample(begin);
    summary.last = sample(end - 1);
    return summary;
}

Eigen::VectorXd actionNumbers(const ActionSummary& action, const GroundFrame& frame, double facing,
                              const PoseSpace& space, int k) {
    const int half = 3 + k;
    const double unwrap = wrapped(action.first.yaw - facing) - action.first.yaw;
    const auto six = [&](const ActionSummary::Sample& sample) {
        Eigen::VectorXd numbers(half);
        numbers.head<2>() = frame.toLocal(sample.root);
        numbers[2] = sample.yaw + unwrap;
        numbers.tail(k) = space.axes.leftCols(k).transpose() * (sample.pose - space.mean);
        return numbers;
    };
    Eigen::VectorXd n(2 * half);
    n.head(half) = six(action.mean);
    if (action.frames > 1) {
        n.tail(half) = (six(action.last) - six(action.first)) * action.rate / (action.frames - 1);
    } else {
        n.tail(half).setZero();
    }
    return n;
}

TransitionGround transitionGround(const FighterTrack& mover, const FighterTrack& opponent,
                                  int frame) {
    const double seconds = mover.offset + frame / mover.rate;
    const int theirs = opponent.frameAt(seconds);
    TransitionGround ground;
    ground.frame = groundFrame(mover.comOnGround(frame), opponent.comOnGround(theirs),
                               mover.heading[static_cast<std::size_t>(frame)] + mover.yaw);
    const int later = frame + static_cast<int>(std::lround(kTargetSeconds * mover.rate));
    if (later < mover.frameCount()) ground.target = ground.frame.toLocal(mover.root(later));
    return ground;
}

Eigen::VectorXd transitionNumbers(const GroundFrame& frame, const ActionSummary& own,
                                  const ActionSummary& opponent, const ActionSummary* next,
                                  const PoseSpace& space, int k, const Eigen::Vector2d* target) {
    const int size = 2 * (3 + k);
    const int now = 2 * size + (target ? 2 : 0);
    Eigen::VectorXd numbers(now + (next ? size : 0));
    numbers.head(size) = actionNumbers(own, frame, frame.yaw, space, k);
    numbers.segment(size, size) =
        actionNumbers(opponent, frame, frame.yaw + std::numbers::pi, space, k);
    if (target) numbers.segment<2>(2 * size) = *target;
    if (next) numbers.tail(size) = actionNumbers(*next, frame, frame.yaw, space, k);
    return numbers;
}

}  // namespace kumite
