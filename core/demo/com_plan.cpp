#include "core/demo/com_plan.h"

#include <algorithm>
#include <cmath>

#include "core/demo/footwork.h"

namespace kumite::demo {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// What a boundary between two actions asks of the centre of mass, in the fighter's own frame.
struct Wish {
    double left = 0;      ///< metres toward the fighter's left
    double ahead = 0;     ///< metres toward the opponent
    double up = 0;        ///< metres above the usual height
    double rise = 0;      ///< vertical speed, m/s
    double travel = 0.8;  ///< share of the stations' speed that it keeps
};

Wish wishAt(const PlannedAction& ending, const PlannedAction& beginning, Side lead) {
    Wish wish;
    const Technique& t = ending.technique;
    for (const Side side : {Side::Left, Side::Right}) {
        const double outward = sign(side);
        if (t.legOutAtEnd(side)) {
            wish.left -= 0.09 * outward;               // over the foot that carries
            wish.ahead += side == lead ? 0.04 : 0.11;  // the rear leg takes the hips along
            const bool low = ending.target == Target::Leg;
            wish.up += low ? 0.05 : (ending.target == Target::Head ? 0.115 : 0.09);
            wish.travel = 0.3;
        }
        if (t.armOutAtEnd(side)) {
            wish.ahead += 0.05 * ending.effort;
            wish.up -= ending.target == Target::Trunk ? 0.05 : 0.012;
        }
    }
    if (beginning.technique.kicks() && !t.kicks()) wish.rise += 0.12;
    if (t.legOutAtBegin(Side::Left) || t.legOutAtBegin(Side::Right)) wish.rise -= 0.10;
    if (t.jump == Jump::Up) {
        wish.rise = 0;
        wish.up = 0.10 + kGravity * ending.flightAtEnd * ending.flightAtEnd / 8;
        wish.left = 0;
        wish.travel = 1;
    } else if (ending.flightAtEnd > 0) {
        wish.up = 0.01 + kGravity * ending.flightAtEnd * ending.flightAtEnd / 8;
        wish.travel = 1;
    }
    const auto dips = [](const PlannedAction& action) {
        return action.technique.isOthers() && action.manner == Manner::Duck;
    };
    if (beginning.technique.jump == Jump::Up) {
        wish.up -= 0.03;
        wish.rise -= 0.22;
    }
    if (t.jump == Jump::Down) {
        wish.up -= 0.03;
        wish.rise += 0.15;
    }
    if (dips(beginning)) wish.rise -= 0.36 * beginning.effort;
    if (dips(ending)) wish.rise += 0.36 * ending.effort;
    if (ending.technique.isOthers() && ending.manner == Manner::Slip) {
        wish.left += (ending.variation % 2 ? 0.09 : -0.09);
        wish.up -= 0.03;
    }
    return wish;
}

/// The longer an action, the smaller its swings in force: the body would bob too far otherwise.
double lightest(const PlannedAction& a, const PlannedAction& b, Random& random) {
    const double longest = std::max(a.duration(), b.duration());
    const double swing = 0.13 / longest * random.uniform(0.5, 1.25);
    return 1.0 - std::clamp(swing, 0.07, 0.36);
}

}  // namespace

ComPath planCentreOfMass(const Script& script, const Script& opponent, double height,
                         std::uint64_t seed) {
    Random random(seed, 5);
    const auto& actions = script.actions;
    std::vector<ComKnot> knots(actions.size() + 1);
    std::vector<std::optional<ForceDip>> dips;
    for (const PlannedAction& action : actions)
        dips.push_back(action.dip);

    const double usual = height - script.temper.crouch;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        ComKnot& knot = knots[i];
        const bool first = i == 0;
        const bool last = i == actions.size();
        knot.time = first ? 0 : actions[i - 1].end;
        const Vector2d station = first ? script.start : actions[i - 1].station;
        Wish wish;
        if (!first && !last) {
            wish = wishAt(actions[i - 1], actions[i], leadOf(script.temper));
            knot.force = lightest(actions[i - 1], actions[i], random);
            // Feet leave the ground a little before all force is gone.
            const double flight = actions[i - 1].flightAtEnd;
            knot.flight = flight > 0 ? flight - 0.06 : 0.0;
        }
        if (first) knot.force = 1;
        wish.up += random.normal(0, 0.006);
        const double facing = yawToward(station, opponent.stationAt(knot.time));
        const Vector2d forward(std::sin(facing), std::cos(facing));
        const Vector2d left(std::cos(facing), -std::sin(facing));
        const Vector2d ground = station + wish.ahead * forward + wish.left * left;
        knot.position = Vector3d(ground.x(), usual + wish.up, ground.y());
        Vector2d speed = Vector2d::Zero();
        if (!first && !last) {
            const Vector2d before = i == 1 ? script.start : actions[i - 2].station;
            const double span = actions[i].end - actions[i - 1].begin;
            speed = wish.travel * (actions[i].station - before) / span;
        }
        knot.velocity = Vector3d(speed.x(), wish.rise, speed.y());
    }
    return ComPath(knots, dips);
}

}  // namespace kumite::demo
