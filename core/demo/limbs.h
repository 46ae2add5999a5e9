#pragma once

#include "core/demo/figure.h"

namespace kumite::demo {

/// Sets clavicle, arm and hand of both sides: the guard's hands, and out to what is struck. Needs
/// the chest's rotation and a trunk that was placed.
void poseArms(const FighterPlan& plan, const Posture& posture, double facing, double time,
              Figure& figure);

/// How a foot shall be at a time, before the leg is known.
struct FootGoal {
    Eigen::Vector3d ankle = Eigen::Vector3d::Zero();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< of the foot, where `free` is 0
    Eigen::Vector3d knee = Eigen::Vector3d::UnitZ();  ///< where the knee points while the leg hangs
    double free = 0;   ///< 1: the foot is turned with the shank, its toes down by `point`
    double point = 0;  ///< radians
    bool planted = false;
    bool hasToe = false;  ///< the toe is given; the heel may rise for the leg's sake
    Eigen::Vector3d toe = Eigen::Vector3d::Zero();
    double yaw = 0;
    double pitch = 0;  ///< of the raised heel, radians
};

FootGoal footGoal(const FighterPlan& plan, const ComPath& opponent, const Posture& posture,
                  Side side, double time);

/// Sets thigh, shank, foot and toe of one side by what the foot shall do. Where the leg is too
/// short to reach the ankle, the heel rises about the toe.
void poseLeg(const BodySize& size, Side side, const FootGoal& goal, Figure& figure);

}  // namespace kumite::demo
