#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/interaction/coupled_graph.h"
#include "core/interaction/pose_space.h"

namespace kumite {

/// The frame of reference of a transition (paper A, Fig. 9; method A7) on the floor of the bout's
/// space: z points from the mover to the opponent, y up, x = y × z.
struct GroundFrame {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< x and z, metres
    double yaw = 0;                                    ///< of z, radians, 0 is the bout's +z

    Eigen::Vector2d toLocal(const Eigen::Vector2d& point) const;
    bool operator==(const GroundFrame&) const = default;
};
/// Origin midway between both centres of mass; if they are nearer than 5 cm, z is the mover's
/// heading.
GroundFrame groundFrame(const Eigen::Vector2d& moverCom, const Eigen::Vector2d& opponentCom,
                        double moverHeading);

/// All that n needs of an action, in the bout's space: n is linear in means and ends, so that it
/// follows from this for any frame of reference and any principal components.
struct ActionSummary {
    int frames = 0;
    double rate = 0;  ///< Hz
    struct Sample {
        Eigen::Vector2d root = Eigen::Vector2d::Zero();  ///< x and z, metres
        double yaw = 0;                                  ///< radians, unwrapped within the action
        LocalPose pose = LocalPose::Zero();

        bool operator==(const Sample&) const = default;
    };
    Sample mean, first, last;

    bool operator==(const ActionSummary&) const = default;
};
/// Over the frames begin … end − 1 (at least begin).
ActionSummary summarise(const FighterTrack& track, const Action& action);

/// The numbers n of an action in the frame of a transition: means of (x, z, yaw, d), then their
/// mean differences per second; 2·(3 + k) numbers. Metres and radians; yaw relative to `facing`,
/// the direction (radians, bout's space) toward the other player; the action's first frame wrapped
/// to (−π, π].
Eigen::VectorXd actionNumbers(const ActionSummary& action, const GroundFrame& frame, double facing,
                              const PoseSpace& space, int k);

/// Where a transition of a mover happens: its frame of reference and where the mover stands half a
/// second later in it (the avatar's target; nothing where the take ends before).
struct TransitionGround {
    GroundFrame frame;
    std::optional<Eigen::Vector2d> target;

    bool operator==(const TransitionGround&) const = default;
};
inline constexpr double kTargetSeconds = 0.5;
/// At a frame of the mover's take.
TransitionGround transitionGround(const FighterTrack& mover, const FighterTrack& opponent,
                                  int frame);

/// n¹ᵢ, n²ⱼ, the avatar's target c if it is given (two numbers, in the transition's frame) and, if
/// `next` is given, n¹ᵢ₊₁ side by side in the transition's frame: 36 numbers at k = 3, 38 with c.
Eigen::VectorXd transitionNumbers(const GroundFrame& frame, const ActionSummary& own,
                                  const ActionSummary& opponent, const ActionSummary* next,
                                  const PoseSpace& space, int k,
                                  const Eigen::Vector2d* target = nullptr);

}  // namespace kumite
