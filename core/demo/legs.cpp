#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/demo/limbs.h"
#include "core/motion/two_bone.h"

namespace kumite::demo {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// The ankle of a foot whose toe is at `toe`, turned by yaw, heel raised by `pitch`.
Vector3d ankleOver(const BodySize& size, const Vector3d& toe, double yaw, double pitch) {
    return toe +
           aboutY(yaw) * aboutX(pitch) * Vector3d(0, size.ankleHeight - size.toeHeight, -size.foot);
}

Vector3d toeOf(const BodySize& size, const Plant& plant) {
    return {plant.toe.x(), size.toeHeight, plant.toe.y()};
}

double between(double a, double b, double s) {
    return a + s * std::remainder(b - a, 2 * std::numbers::pi);
}

/// Zero with zero slope at both ends, 1 in the middle.
double arch(double s) {
    return 16 * s * s * (1 - s) * (1 - s);
}

/// Position on the curve of fifth order with these positions and speeds and no acceleration at
/// both ends.
Vector3d quintic(const Vector3d& a, const Vector3d& speedA, const Vector3d& b,
                 const Vector3d& speedB, double duration, double s) {
    const double s3 = s * s * s;
    const double position = s3 * (10 + s * (-15 + 6 * s));
    const double out = s + s3 * (-6 + s * (8 - 3 * s));
    const double in = s3 * (-4 + s * (7 - 3 * s));
    return a + position * (b - a) + duration * (out * speedA + in * speedB);
}

FootGoal stepGoal(const FighterPlan& plan, const Plant& from, const Plant& to, Swing kind,
                  double time) {
    const BodySize& size = plan.size;
    const double s = (time - from.end) / (to.begin - from.end);
    const double onward = minimumJerk((s - 0.1) / 0.8);
    FootGoal goal;
    goal.yaw = between(from.yaw, to.yaw, onward);
    goal.toe = toeOf(size, from) + onward * (toeOf(size, to) - toeOf(size, from));
    double lift = 0.105;
    double pitch = 0.30;
    if (kind == Swing::Hop) {
        lift = 0.085;
        pitch = 0.45;
    } else if (kind == Swing::Jump) {
        const double start = plan.centreOfMass.position(from.end).y();
        const double middle = plan.centreOfMass.position((from.end + to.begin) / 2).y();
        lift = 0.09 + std::max(0.0, middle - start);
        pitch = 0.6;
    }
    goal.toe.y() += lift * arch(s);
    goal.pitch = pitch * arch(s);
    goal.ankle = ankleOver(size, goal.toe, goal.yaw, goal.pitch);
    goal.turn = aboutY(goal.yaw) * aboutX(goal.pitch);
    goal.hasToe = true;
    return goal;
}

/// The kick whose foot is in the air at a time.
const Strike* kickAt(const FighterPlan& plan, Side side, double liftOff, double landing) {
    for (const Strike& strike : strikesNear(plan, liftOff)) {
        if (strike.kick && strike.side == side && strike.hit > liftOff && strike.hit < landing)
            return &strike;
    }
    return nullptr;
}

/// A kick is five points of the ankle: off the ground, knee up, out, knee up, down.
FootGoal kickGoal(const FighterPlan& plan, const ComPath& opponent, const Plant& from,
                  const Plant& to, const Strike& kick, Side side, double time) {
    const BodySize& size = plan.size;
    const double x = sign(side);
    const auto hipAt = [&](double t) -> Vector3d {
        const double facing = facingAt(plan.centreOfMass, opponent, t);
        return plan.centreOfMass.position(t) + aboutY(facing) * Vector3d(0.08 * x, -0.05, 0);
    };
    const auto frameAt = [&](double t) { return aboutY(facingAt(plan.centreOfMass, opponent, t)); };
    Vector3d folded =
        Vector3d::Zero();  // ankle against the hip with the knee up, in the facing frame
    switch (kick.style) {
        case KickStyle::Front:
            folded = {0.02 * x, -0.36, 0.24};
            break;
        case KickStyle::Round:
            folded = {0.34 * x, -0.30, 0.02};
            break;
        case KickStyle::Knee:
            folded = {0.02 * x, -0.46, 0.05};
            break;
    }
    if (kick.target == Target::Leg) folded += Vector3d(0.04 * x, -0.16, 0.0);
    const double up = from.end + 0.46 * (kick.hit - from.end);
    const double back = kick.hit + 0.46 * (to.begin - kick.hit);
    const Vector3d ground = ankleOver(size, toeOf(size, from), from.yaw, 0.25);
    const Vector3d landing = ankleOver(size, toeOf(size, to), to.yaw, 0);
    // The sole, the instep or the knee shall be at the point; this is where the ankle is then.
    Vector3d out = kick.point;
    if (kick.style == KickStyle::Front) {
        out -= kSole * (kick.point - hipAt(kick.hit)).normalized();
    } else if (kick.style == KickStyle::Knee) {
        out += frameAt(kick.hit) * Vector3d(0, -0.97 * size.shank, -0.22 * size.shank);
    }
    const Vector3d foldedUp = hipAt(up) + frameAt(up) * folded;
    const Vector3d foldedBack = hipAt(back) + frameAt(back) * (folded + Vector3d(0, -0.05, 0.05));
    const Vector3d still = Vector3d::Zero();
    const Vector3d speedUp =
        0.5 * ((foldedUp - ground) / (up - from.end) + (out - foldedUp) / (kick.hit - up));
    const Vector3d speedBack =
        0.5 * ((foldedBack - out) / (back - kick.hit) + (landing - foldedBack) / (to.begin - back));
    FootGoal goal;
    const auto part = [&](const Vector3d& a, const Vector3d& va, double ta, const Vector3d& b,
                          const Vector3d& vb, double tb) {
        goal.ankle = quintic(a, va, b, vb, tb - ta, (time - ta) / (tb - ta));
    };
    if (time < up) {
        part(ground, still, from.end, foldedUp, speedUp, up);
    } else if (time < kick.hit) {
        part(foldedUp, speedUp, up, out, still, kick.hit);
    } else if (time < back) {
        part(out, still, kick.hit, foldedBack, speedBack, back);
    } else {
        part(foldedBack, speedBack, back, landing, still, to.begin);
    }
    const double s = (time - from.end) / (to.begin - from.end);
    goal.yaw = between(from.yaw, to.yaw, minimumJerk(s));
    goal.turn = aboutY(goal.yaw) * aboutX(0.25 * (1 - minimumJerk(s * 3)));
    // The foot hangs from the shank once it is clear of the ground; the ankle never goes lower
    // than it stands.
    goal.ankle.y() = std::max(goal.ankle.y(), size.ankleHeight);
    goal.free = minimumJerk((goal.ankle.y() - size.ankleHeight - 0.06) / 0.2);
    goal.point = kick.style == KickStyle::Front ? 0.25 : 0.75;
    const Matrix3d frame = frameAt(time);
    const Vector3d knee =
        kick.style == KickStyle::Round ? Vector3d(0.95 * x, 0, 0.3) : Vector3d(0.12 * x, 0, 1.0);
    goal.knee = frame * knee;
    return goal;
}

}  // namespace

FootGoal footGoal(const FighterPlan& plan, const ComPath& opponent, const Posture& posture,
                  Side side, double time) {
    const BodySize& size = plan.size;
    const FootTrack& track = plan.feet[static_cast<std::size_t>(side)];
    const auto index = static_cast<std::size_t>(track.plantAt(time));
    const Plant& plant = track.plants[index];
    const double facing = facingAt(plan.centreOfMass, opponent, time);
    const double pelvisYaw = facing + of(posture, Control::PelvisYaw);
    const auto kneeAlong = [&](double yaw) -> Vector3d {
        return aboutY(between(yaw, pelvisYaw, 0.35)) * Vector3d(0.10 * sign(side), 0, 1.0);
    };
    if (time <= plant.end) {
        FootGoal goal;
        goal.planted = true;
        goal.hasToe = true;
        goal.toe = toeOf(size, plant);
        const bool leaves = index + 1 < track.plants.size();
        const double leaving = leaves ? minimumJerk(1 - (plant.end - time) / 0.12) : 0.0;
        const double settled = index == 0 ? 1.0 : minimumJerk((time - plant.begin) / 0.12);
        const double pivot =
            of(posture, side == Side::Left ? Control::LeftPivot : Control::RightPivot);
        goal.yaw = plant.yaw + settled * (1 - leaving) * pivot;
        // Heels are light: the rear one is up, and before a foot leaves, its heel does.
        const bool rear = side != leadOf(plan.script.temper);
        const double restingHeel = rear ? 0.22 : 0.05;
        double pitch = restingHeel * settled;
        if (leaves) {
            const bool kick = track.swings[index] == Swing::Kick;
            pitch += leaving * ((kick ? 0.25 : 0.0) - pitch);
        }
        goal.ankle = ankleOver(size, goal.toe, goal.yaw, pitch);
        goal.turn = aboutY(goal.yaw) * aboutX(pitch);
        goal.pitch = pitch;
        goal.knee = kneeAlong(goal.yaw);
        return goal;
    }
    const Plant& next = track.plants[index + 1];
    if (track.swings[index] == Swing::Kick) {
        if (const Strike* kick = kickAt(plan, side, plant.end, next.begin)) {
            FootGoal goal = kickGoal(plan, opponent, plant, next, *kick, side, time);
            const double raised = minimumJerk((goal.ankle.y() - size.ankleHeight) / 0.5);
            goal.knee = raised * goal.knee + (1 - raised) * kneeAlong(goal.yaw);
            return goal;
        }
    }
    FootGoal goal = stepGoal(plan, plant, next, track.swings[index], time);
    goal.knee = kneeAlong(goal.yaw);
    return goal;
}

void poseLeg(const BodySize& size, Side side, const FootGoal& goal, Figure& figure) {
    const Vector3d& hip = figure.marks[roleOf(side, Part::Thigh)];
    Vector3d ankle = goal.ankle;
    Matrix3d foot = goal.turn;
    constexpr double kLongest = 0.975;  // of the leg: knees stay a little bent
    const double longest = kLongest * size.legLength();
    if (goal.hasToe && (ankle - hip).norm() > longest) {
        double low = goal.pitch;
        double high = 1.3;
        for (int i = 0; i < 24; ++i) {
            const double middle = (low + high) / 2;
            ankle = ankleOver(size, goal.toe, goal.yaw, middle);
            ((ankle - hip).norm() > longest ? low : high) = middle;
        }
        foot = aboutY(goal.yaw) * aboutX(high);
    }
    // Carried along from a hanging leg by the shortest way: forward becomes up in a front kick.
    const Vector3d knee = Quaterniond::FromTwoVectors(Vector3d(0, -1, 0), ankle - hip) * goal.knee;
    const TwoBone bones = bend(hip, ankle, knee, size.thigh, size.shank);
    const Vector3d thigh = bones.middle - hip;
    const Vector3d shank = bones.end - bones.middle;
    const Vector3d thighDirection = thigh.normalized();
    const Vector3d ahead = knee - knee.dot(thighDirection) * thighDirection;
    Vector3d bendAhead = thighDirection * shank.dot(thighDirection) - shank;
    if (bendAhead.norm() < 1e-4) bendAhead = ahead;
    const Matrix3d thighTurn = turnWithY(-thigh, bendAhead);
    const Vector3d hinge = thighTurn.col(0);
    const Matrix3d shankTurn = turnWithY(-shank, hinge.cross(-shank.normalized()));
    if (goal.free > 0) {
        const Matrix3d pointed = shankTurn * aboutX(goal.point);
        foot = Quaterniond(foot).slerp(goal.free, Quaterniond(pointed)).toRotationMatrix();
    }
    figure.pose.turn(side, Part::Thigh) = thighTurn;
    figure.pose.turn(side, Part::Shank) = shankTurn;
    figure.pose.turn(side, Part::Foot) = foot;
    // The toes stay flat on the ground while the heel is up.
    figure.pose.turn(side, Part::Toe) = goal.planted ? aboutY(goal.yaw) : foot;
}

}  // namespace kumite::demo
