#include "core/demo/figure.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/demo/limbs.h"
#include "core/motion/two_bone.h"

namespace kumite::demo {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Yaw, then lean, then tilt.
Matrix3d turned(double yaw, double lean, double tilt) {
    return aboutY(yaw) * aboutX(lean) * aboutZ(-tilt);
}

void poseTrunk(const Posture& p, double facing, Pose& pose) {
    pose.pelvisTurn = turned(facing + of(p, Control::PelvisYaw), of(p, Control::PelvisLean),
                             of(p, Control::PelvisTilt));
    pose.chestTurn = pose.pelvisTurn * turned(of(p, Control::SpineYaw), of(p, Control::SpineLean),
                                              of(p, Control::SpineTilt));
    // The head looks at the opponent whatever the trunk does, but goes along with a third of its
    // lean and tilt.
    const Vector3d up = pose.chestTurn.col(1);
    const Vector3d forward = aboutY(facing) * Vector3d::UnitZ();
    const Vector3d left = aboutY(facing) * Vector3d::UnitX();
    const double lean = 0.35 * std::asin(std::clamp(up.dot(forward), -1.0, 1.0));
    const double tilt = -0.4 * std::asin(std::clamp(up.dot(left), -1.0, 1.0));
    pose.headTurn = turned(facing + of(p, Control::HeadYaw), lean + of(p, Control::HeadLean),
                           tilt + of(p, Control::HeadTilt));
    pose.neckTurn =
        Quaterniond(pose.chestTurn).slerp(0.5, Quaterniond(pose.headTurn)).toRotationMatrix();
}

}  // namespace

double facingAt(const ComPath& own, const ComPath& opponent, double time) {
    const Vector3d way = opponent.position(time) - own.position(time);
    return std::atan2(way.x(), way.z());
}

std::span<const Strike> strikesNear(const FighterPlan& plan, double time) {
    constexpr double kWindow = 2.0;
    const auto byHit = [](const Strike& strike, double t) { return strike.hit < t; };
    const auto& all = plan.strikes;
    const auto from = std::lower_bound(all.begin(), all.end(), time - kWindow, byHit);
    const auto to = std::lower_bound(from, all.end(), time + kWindow, byHit);
    return {from, to};
}

Figure figureAt(const FighterPlan& plan, const ComPath& opponent, double time) {
    const Posture posture = plan.posture.at(time);
    const double facing = facingAt(plan.centreOfMass, opponent, time);
    const Vector3d wanted = plan.centreOfMass.position(time);
    Figure figure;
    figure.pose.pelvis = wanted - Vector3d(0, 0.05, 0);
    poseTrunk(posture, facing, figure.pose);
    const std::array<FootGoal, 2> feet = {footGoal(plan, opponent, posture, Side::Left, time),
                                          footGoal(plan, opponent, posture, Side::Right, time)};
    constexpr int kMostRounds = 12;
    constexpr double kCloseEnough = 2e-6;  // metres
    for (int round = 0; round < kMostRounds; ++round) {
        for (const Side side : {Side::Left, Side::Right}) {
            figure.pose.turn(side, Part::Clavicle) = figure.pose.chestTurn;
        }
        placeTrunk(plan.size, figure.pose, figure.marks);
        poseArms(plan, posture, facing, time, figure);
        placeTrunk(plan.size, figure.pose, figure.marks);
        for (const Side side : {Side::Left, Side::Right}) {
            poseLeg(plan.size, side, feet[static_cast<std::size_t>(side)], figure);
        }
        placeLimbs(plan.size, figure.pose, figure.marks);
        const Vector3d miss = wanted - centreOfMassOf(figure.marks);
        if (miss.norm() < kCloseEnough) break;
        figure.pose.pelvis += 1.15 * miss;
    }
    return figure;
}

double guardHeightOf(const BodySize& size) {
    // At its lightest, when the body is highest: knees bent to about 150°, the trunk a little
    // ahead; the centre of mass lies above the hips.
    return 0.98 * size.legLength() + size.ankleHeight + size.hipDrop + 0.02;
}

}  // namespace kumite::demo
