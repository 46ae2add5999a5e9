#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/demo/technique.h"
#include "core/motion/roles.h"

namespace kumite::demo {

/// Sizes of a body, metres. In the T-pose: y up, x to its left, z ahead; arms along ±x.
struct BodySize {
    double hipWidth = 0.18;  ///< between the hip joints
    double hipDrop = 0.06;   ///< of the hips below the pelvis joint
    double thigh = 0.43;
    double shank = 0.42;
    double ankleHeight = 0.085;
    double foot = 0.145;                             ///< ankle to toe joint, along the ground
    double toeHeight = 0.022;                        ///< of the toe joint above the sole
    double toe = 0.07;                               ///< toe joint to the tip
    std::vector<double> spine = {0.09, 0.14, 0.14};  ///< pelvis to first joint, and so on
    double chestToNeck = 0.19;
    double neck = 0.10;          ///< neck joint to head joint
    double head = 0.19;          ///< head joint to the top
    double clavicle = 0.155;     ///< sternum to shoulder joint, sideways
    double clavicleRise = 0.11;  ///< of the clavicle's begin above the chest joint
    double upperArm = 0.29;
    double forearm = 0.26;
    double hand = 0.10;  ///< wrist to the knuckles

    double legLength() const { return thigh + shank; }
    double armLength() const { return upperArm + forearm + hand; }
};

/// Rigid parts of a limb's side, from the trunk outward.
enum class Part { Clavicle, UpperArm, Forearm, Hand, Thigh, Shank, Foot, Toe };
inline constexpr int kPartsPerSide = 8;

/// A pose: where the pelvis is and how every part is turned against the T-pose, in the world.
struct Pose {
    Eigen::Vector3d pelvis = Eigen::Vector3d::Zero();
    Eigen::Matrix3d pelvisTurn = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d chestTurn = Eigen::Matrix3d::Identity();  ///< the spine's last joint
    Eigen::Matrix3d neckTurn = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d headTurn = Eigen::Matrix3d::Identity();
    std::array<std::array<Eigen::Matrix3d, kPartsPerSide>, 2> limbTurn;

    Eigen::Matrix3d& turn(Side side, Part part) {
        return limbTurn[static_cast<std::size_t>(side)][static_cast<std::size_t>(part)];
    }
    const Eigen::Matrix3d& turn(Side side, Part part) const {
        return limbTurn[static_cast<std::size_t>(side)][static_cast<std::size_t>(part)];
    }
};

/// Rotation of the spine's joint k of n (1-based; the n-th is the chest).
Eigen::Matrix3d spineTurn(const Pose& pose, int k, int n);

/// World positions that a pose gives to what has a role, and to the head's top.
struct Landmarks {
    std::array<Eigen::Vector3d, kRoleCount> at;
    Eigen::Vector3d headTop;

    const Eigen::Vector3d& operator[](Role role) const {
        return at[static_cast<std::size_t>(role)];
    }
    Eigen::Vector3d& operator[](Role role) { return at[static_cast<std::size_t>(role)]; }
};

Role roleOf(Side side, Part part);

/// The trunk's landmarks: pelvis, spine, chest, neck, head, clavicles, shoulders, hips.
void placeTrunk(const BodySize& size, const Pose& pose, Landmarks& marks);
/// The rest, out from shoulders and hips.
void placeLimbs(const BodySize& size, const Pose& pose, Landmarks& marks);

/// Centre of mass by the body model of method A1.
Eigen::Vector3d centreOfMassOf(const Landmarks& marks);

}  // namespace kumite::demo
