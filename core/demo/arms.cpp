#include <cmath>

#include <Eigen/Geometry>

#include "core/demo/limbs.h"
#include "core/motion/two_bone.h"

namespace kumite::demo {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double of2(const Posture& p, Side side, Control left, Control right) {
    return of(p, side == Side::Left ? left : right);
}

/// How far a punch is out at a time, 0 to 1: late and fast out, slower back.
double extension(const Strike& strike, double time) {
    if (time <= strike.start || time >= strike.end) return 0;
    if (time <= strike.hit) {
        const double s = (time - strike.start) / (strike.hit - strike.start);
        return minimumJerk(std::pow(s, 1.25));
    }
    return 1 - minimumJerk((time - strike.hit) / (strike.end - strike.hit));
}

struct Arm {
    Vector3d knuckles;  ///< where they shall be, world
    double out = 0;     ///< 0 in guard, 1 at the target
    double hook = 0;
};

Arm armAt(const FighterPlan& plan, const Posture& posture, const Landmarks& marks, double facing,
          Side side, double time) {
    const double turned =
        facing + 0.5 * (of(posture, Control::PelvisYaw) + of(posture, Control::SpineYaw));
    const Matrix3d frame = aboutY(turned);
    const Vector3d guard =
        marks[Role::Neck] +
        frame * Vector3d(sign(side) * of2(posture, side, Control::LeftAside, Control::RightAside),
                         of2(posture, side, Control::LeftUp, Control::RightUp),
                         of2(posture, side, Control::LeftAhead, Control::RightAhead));
    Arm arm{guard, 0, 0};
    for (const Strike& strike : strikesNear(plan, time)) {
        if (strike.kick || strike.side != side) continue;
        const double e = extension(strike, time) * (strike.feint ? 0.42 : 1.0);
        if (e <= 0) continue;
        arm.knuckles += e * (strike.point - guard);
        // A hook swings out to its side on the way.
        const Vector3d outward = frame * Vector3d(sign(side), -0.1, 0.15);
        arm.knuckles += 0.26 * strike.hook * 4 * e * (1 - e) * outward;
        arm.out = std::min(1.0, arm.out + e);
        arm.hook = std::max(arm.hook, strike.hook * e);
    }
    return arm;
}

}  // namespace

void poseArms(const FighterPlan& plan, const Posture& posture, double facing, double time,
              Figure& figure) {
    const BodySize& size = plan.size;
    const Matrix3d& chest = figure.pose.chestTurn;
    for (const Side side : {Side::Left, Side::Right}) {
        const Arm arm = armAt(plan, posture, figure.marks, facing, side, time);
        const double x = sign(side);
        // The shoulder goes along: forward with the punch, up with a raised hand.
        const double forward = 0.12 + 0.33 * arm.out;
        const double raised = 0.06 + 0.12 * arm.out;
        const Matrix3d clavicle = chest * aboutY(-x * forward) * aboutZ(x * raised);
        figure.pose.turn(side, Part::Clavicle) = clavicle;
        const Vector3d shoulder = figure.marks[roleOf(side, Part::Clavicle)] +
                                  clavicle * Vector3d(size.clavicle * x, 0.02, 0);
        // Where the elbow points is carried along from an arm held ahead, by the shortest way: no
        // direction that an arm can take turns it over.
        const double hook = std::max(0.0, arm.hook);
        const Vector3d ahead = chest * Vector3d(0, -0.3, 1).normalized();
        const Vector3d elbow = chest * Vector3d(x * (0.4 + 0.8 * hook), -1.0 + 0.8 * hook, -0.3);
        const Vector3d pole =
            Eigen::Quaterniond::FromTwoVectors(ahead, arm.knuckles - shoulder) * elbow;
        // The fist goes on straight from the forearm.
        const TwoBone bones =
            bend(shoulder, arm.knuckles, pole, size.upperArm, size.forearm + size.hand);
        const Vector3d upper = bones.middle - shoulder;
        const Vector3d lower = bones.end - bones.middle;
        // In the T-pose the forearm bends ahead: y is the hinge, f × along.
        Vector3d hinge = (lower - lower.dot(upper.normalized()) * upper.normalized());
        if (hinge.norm() < 1e-5) hinge = -pole;
        const Vector3d along = x * upper.normalized();
        const Vector3d above = hinge.cross(along);
        const Matrix3d upperTurn = turnWithX(along, above);
        const Vector3d foreAlong = x * lower.normalized();
        // The fist turns palm down as it goes out.
        const double twist = x * (-0.9 + 1.3 * arm.out);
        const Matrix3d fore = turnWithX(foreAlong, upperTurn.col(1));
        figure.pose.turn(side, Part::UpperArm) = upperTurn;
        figure.pose.turn(side, Part::Forearm) = fore * aboutX(0.6 * twist);
        figure.pose.turn(side, Part::Hand) = fore * aboutX(twist);
    }
}

}  // namespace kumite::demo
