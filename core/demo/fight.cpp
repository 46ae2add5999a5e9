#include "core/demo/fight.h"

#include <cmath>

#include <Eigen/Geometry>

#include "core/demo/com_plan.h"
#include "core/motion/two_bone.h"

namespace kumite::demo {
namespace {

using Eigen::Vector3d;

Vector3d towardAttacker(const Figure& defender, const Vector3d& attacker) {
    Vector3d way = attacker - defender.marks[Role::Neck];
    way.y() = 0;
    return way.normalized();
}

/// The place on the defender's body that a strike of this kind can reach.
Vector3d surfacePoint(const Strike& strike, const Figure& defender, const Vector3d& attacker) {
    const Landmarks& m = defender.marks;
    const Vector3d near = towardAttacker(defender, attacker);
    // A round kick and a hook come from the attacker's side.
    const Vector3d aside = Vector3d::UnitY().cross(near);
    const bool round = strike.kick && strike.style == KickStyle::Round;
    const double swing = round ? 0.75 : 0.7 * std::max(0.0, strike.hook);
    const Vector3d from = (near - sign(strike.side) * swing * aside).normalized();
    switch (strike.target) {
        case Target::Head:
            return (m[Role::Head] + m.headTop) / 2 + 0.115 * from;
        case Target::Trunk: {
            const double height = strike.kick ? 0.45 : 0.62;
            const Vector3d middle = m[Role::Pelvis] + height * (m[Role::Neck] - m[Role::Pelvis]);
            return middle + 0.15 * from;
        }
        case Target::Leg: {
            // The nearer thigh, above the knee.
            const Side nearer =
                (m[Role::LeftKnee] - attacker).norm() < (m[Role::RightKnee] - attacker).norm()
                    ? Side::Left
                    : Side::Right;
            const Vector3d knee = m[roleOf(nearer, Part::Shank)];
            const Vector3d hip = m[roleOf(nearer, Part::Thigh)];
            return knee + 0.3 * (hip - knee) + 0.08 * from;
        }
    }
    return m[Role::Neck];
}

/// In front of the guard, where gloves and forearms stop what comes.
Vector3d guardPoint(const Strike& strike, const Figure& defender, const Vector3d& attacker) {
    const Vector3d near = towardAttacker(defender, attacker);
    const Vector3d surface = surfacePoint(strike, defender, attacker);
    return surface + 0.16 * near;
}

/// Where the head or trunk would be if the opponent stood in guard.
Vector3d undodgedPoint(const Strike& strike, const FighterPlan& defender,
                       const Vector3d& attacker) {
    Vector3d body = defender.centreOfMass.position(strike.hit);
    body.y() = guardHeightOf(defender.size) - defender.script.temper.crouch;
    Vector3d near = attacker - body;
    near.y() = 0;
    return body + Vector3d(0, strike.target == Target::Head ? 0.60 : 0.22, 0) +
           0.14 * near.normalized();
}

/// As far as the limb goes toward a point.
Vector3d withinReach(const Strike& strike, const FighterPlan& plan, const Figure& figure,
                     const Vector3d& point) {
    const BodySize& size = plan.size;
    if (strike.kick) {
        const Vector3d hip = figure.marks[roleOf(strike.side, Part::Thigh)];
        const double longest =
            strike.style == KickStyle::Knee
                ? 0.99 * size.thigh
                : 0.985 * size.legLength() + (strike.style == KickStyle::Front ? kSole : 0.0);
        const Vector3d way = point - hip;
        return way.norm() > longest ? Vector3d(hip + longest * way.normalized()) : point;
    }
    const Vector3d shoulder = figure.marks[roleOf(strike.side, Part::UpperArm)];
    const double longest = 0.995 * size.armLength();
    const Vector3d way = point - shoulder;
    return way.norm() > longest ? Vector3d(shoulder + longest * way.normalized()) : point;
}

/// Aims every strike of `attacker` at where the defender's body is.
void aim(FighterPlan& attacker, const FighterPlan& defender) {
    for (Strike& strike : attacker.strikes) {
        const Figure other = figureAt(defender, attacker.centreOfMass, strike.hit);
        const Figure own = figureAt(attacker, defender.centreOfMass, strike.hit);
        const Vector3d here = attacker.centreOfMass.position(strike.hit);
        Vector3d point = Vector3d::Zero();
        switch (strike.outcome) {
            case Outcome::Blocked:
                point = guardPoint(strike, other, here);
                break;
            case Outcome::Dodged:
                point = undodgedPoint(strike, defender, here);
                break;
            case Outcome::Lands:
            case Outcome::Short:
                point = surfacePoint(strike, other, here);
                break;
        }
        strike.point = withinReach(strike, attacker, own, point);
        if (strike.outcome == Outcome::Lands || strike.outcome == Outcome::Short) {
            constexpr double kTouches = 0.05;  // metres
            strike.outcome =
                (strike.point - point).norm() < kTouches ? Outcome::Lands : Outcome::Short;
        }
    }
}

}  // namespace

Vector3d strikingPoint(const BodySize& size, const Strike& strike, const Figure& figure) {
    const Landmarks& m = figure.marks;
    if (!strike.kick) {
        return m[roleOf(strike.side, Part::Hand)] +
               figure.pose.turn(strike.side, Part::Hand) *
                   Vector3d(sign(strike.side) * size.hand, 0, 0);
    }
    switch (strike.style) {
        case KickStyle::Front: {
            const Vector3d ankle = m[roleOf(strike.side, Part::Foot)];
            return ankle + kSole * (ankle - m[roleOf(strike.side, Part::Shank)]).normalized();
        }
        case KickStyle::Round:
            return m[roleOf(strike.side, Part::Foot)];
        case KickStyle::Knee:
            return m[roleOf(strike.side, Part::Shank)];
    }
    return m[Role::Pelvis];
}

std::array<FighterPlan, 2> planFight(std::uint64_t seed, double seconds,
                                     const std::array<BodySize, 2>& bodies) {
    std::array<Script, 2> scripts = choreograph(seed, seconds);
    const auto planOf = [&](std::size_t i) {
        const Script& own = scripts[i];
        const Script& other = scripts[1 - i];
        const std::uint64_t stream = 2 * seed + i;
        ComPath path = planCentreOfMass(own, other, guardHeightOf(bodies[i]), stream);
        Feet feet = planFeet(own, other, path, stream);
        return FighterPlan{bodies[i],       own,
                           std::move(path), std::move(feet),
                           strikesOf(own),  PosturePlan(own, {}, stream),
                           stream};
    };
    std::array<FighterPlan, 2> plans = {planOf(0), planOf(1)};
    for (std::size_t i = 0; i < 2; ++i) {
        const FighterPlan& opponent = plans[1 - i];
        for (Strike& strike : plans[i].strikes) {
            const Vector3d way = opponent.centreOfMass.position(strike.hit) -
                                 plans[i].centreOfMass.position(strike.hit);
            strike.outcome = outcomeOf(strike, opponent.script, std::hypot(way.x(), way.z()));
            strike.point = opponent.centreOfMass.position(strike.hit) + Vector3d(0, 0.4, 0);
        }
    }
    // A hit moves the one who is hit, and a raised leg the one who kicks: aim again.
    constexpr int kRounds = 2;
    for (int round = 0; round < kRounds; ++round) {
        aim(plans[0], plans[1]);
        aim(plans[1], plans[0]);
        for (std::size_t i = 0; i < 2; ++i) {
            plans[i].posture = PosturePlan(plans[i].script, plans[1 - i].strikes, plans[i].seed);
        }
    }
    return plans;
}

}  // namespace kumite::demo
