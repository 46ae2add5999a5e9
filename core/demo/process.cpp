#include "core/demo/process.h"

#include <array>
#include <numeric>

namespace kumite::demo {
namespace {

/// What an opponent's action in progress means for the one who has to choose.
enum class Threat { None, Punch, Kick, Open };

Threat threatOf(const Technique& opponent) {
    if (opponent.kicks()) return Threat::Kick;
    if (opponent.punches()) return Threat::Punch;
    return opponent.isOthers() ? Threat::None : Threat::Open;  // open: a strike comes back
}

/// Weights by range: near, middle, far.
using ByRange = std::array<double, 3>;

double at(const ByRange& weights, Range range) {
    return weights[static_cast<std::size_t>(range)];
}

double punchWeight(const Temper& temper, Side side, Punch punch, Range range, Threat threat) {
    const bool lead = side == leadOf(temper);
    double weight = 0;
    if (punch == Punch::Fwd) {
        weight = lead ? at({0.24, 0.15, 0.03}, range) : at({0.13, 0.07, 0.01}, range);
    } else {
        weight = lead ? at({0.15, 0.08, 0.015}, range) : at({0.07, 0.03, 0.005}, range);
    }
    weight *= lead ? temper.leading : 1.0;
    if (threat == Threat::Punch) weight *= punch == Punch::FwdBwd ? 1.3 : 0.5;
    if (threat == Threat::Kick) weight *= punch == Punch::FwdBwd ? 0.4 : 0.6;
    if (threat == Threat::Open) weight *= lead ? 1.2 : 1.9;  // the counter comes from the rear
    return weight * temper.punching * temper.aggression;
}

double kickWeight(const Temper& temper, Side side, Range range, Threat threat) {
    const bool lead = side == leadOf(temper);
    double weight = lead ? at({0.05, 0.13, 0.03}, range) : at({0.07, 0.16, 0.03}, range);
    weight *= lead ? temper.leading : 1.0;
    if (threat == Threat::Punch) weight *= 0.5;
    if (threat == Threat::Kick) weight *= 0.25;
    if (threat == Threat::Open) weight *= 1.4;
    return weight * temper.kicking * temper.aggression;
}

double jumpWeight(const Temper& temper, const Technique& next, Range range, Threat threat) {
    double weight =
        next.kicks() ? at({0.004, 0.022, 0.03}, range) : at({0.006, 0.008, 0.012}, range);
    if (threat == Threat::Kick && !next.kicks()) weight *= 4;  // over a low kick
    return weight * temper.jumping;
}

/// From the guard, with both hands and feet at home.
double weightFromGuard(const Temper& temper, const Technique& next, Threat threat, Range range,
                       bool justStruck) {
    if (next.isOthers()) {
        double weight = at({0.62, 0.80, 1.3}, range);
        if (threat == Threat::Punch) weight *= 2.0;
        if (threat == Threat::Kick) weight *= 2.2;
        if (threat == Threat::Open) weight *= 0.7;
        return justStruck ? 1.6 * weight : weight;
    }
    if (next.jump == Jump::Up) return jumpWeight(temper, next, range, threat);
    double weight = 0;
    for (const Side side : {Side::Left, Side::Right}) {
        if (next.kickOf(side) == Kick::Up) weight += kickWeight(temper, side, range, threat);
        const Punch punch = next.punchOf(side);
        if (punch == Punch::Fwd || punch == Punch::FwdBwd)
            weight += punchWeight(temper, side, punch, range, threat);
    }
    return weight;
}

/// With a hand or a foot out: back, or back and on.
double weightAfterStrike(const Temper& temper, const Technique& next, Threat threat, Range range) {
    if (next.kicks() && (next.punches() || next.punchOf(Side::Left) == Punch::Bwd ||
                         next.punchOf(Side::Right) == Punch::Bwd)) {
        return temper.combining * temper.kicking * at({0.12, 0.24, 0.10}, range);
    }
    const bool again = next.punches() || next.kicks();
    if (!again) {
        double weight = at({0.36, 0.44, 0.75}, range);
        if (threat == Threat::Punch || threat == Threat::Kick) weight *= 1.5;
        return weight;
    }
    const bool sameLimb = next.punchOf(Side::Left) == Punch::BwdFwd ||
                          next.punchOf(Side::Right) == Punch::BwdFwd || next.kicks();
    double weight = sameLimb ? at({0.17, 0.16, 0.06}, range) : at({0.42, 0.26, 0.08}, range);
    if (threat == Threat::Kick) weight *= 0.6;
    return temper.combining * weight;
}

void normalise(std::vector<double>& weights) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights)
        weight /= sum;
}

}  // namespace

const char* name(Range range) {
    constexpr std::array names = {"near", "middle", "far"};
    return names[static_cast<std::size_t>(range)];
}

Range rangeOf(double distance) {
    if (distance < 1.08) return Range::Near;
    return distance < 1.4 ? Range::Middle : Range::Far;
}

Temper drawTemper(std::uint64_t seed, int player) {
    Random random(seed, 100 + static_cast<std::uint64_t>(player));
    Temper t;
    t.southpaw = random.chance(player == 0 ? 0.0 : 0.25);
    // A boxer meets a kicker; the seed says how much of each they are.
    const double boxer = player == 0 ? random.uniform(1.05, 1.4) : random.uniform(0.75, 1.0);
    t.punching = boxer;
    t.kicking = 1.0 / boxer;
    t.aggression = random.uniform(0.9, 1.2);
    t.jumping = player == 0 ? random.uniform(0.5, 0.8) : random.uniform(0.8, 1.2);
    t.combining = random.uniform(0.8, 1.3);
    t.leading = random.uniform(0.8, 1.3);
    t.reach = player == 0 ? 1.0 : 0.96;
    t.speed = random.uniform(0.92, 1.1);
    t.guardHeight = random.uniform(-0.05, 0.05);
    t.crouch = random.uniform(0.0, 0.03);
    t.wanderlust = random.uniform(0.85, 1.2);
    t.reaction = random.uniform(0.19, 0.25);
    t.preferredDistance = random.uniform(1.42, 1.56);
    return t;
}

Side leadOf(const Temper& temper) {
    return temper.southpaw ? Side::Right : Side::Left;
}

std::vector<double> nextTechnique(const Temper& temper, const Technique& own,
                                  const Technique& opponent, Range range) {
    const auto& all = techniques();
    const Threat threat = threatOf(opponent);
    std::vector<double> weights(all.size(), 0.0);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!mayFollow(own, all[i])) continue;
        weights[i] = own.anyOutAtEnd()
                         ? weightAfterStrike(temper, all[i], threat, range)
                         : weightFromGuard(temper, all[i], threat, range, !own.isOthers());
    }
    normalise(weights);
    return weights;
}

std::vector<double> nextManner(const Temper& temper, Manner before, const Technique& opponent,
                               Range range) {
    //                            guard in   out  circle hop  feint block slip duck retreat
    std::vector<double> weights;
    switch (threatOf(opponent)) {
        case Threat::Punch:
            weights = {2, 0.5, 1, 0.5, 0.3, 0.2, 7, 4.5, 2, 3};
            break;
        case Threat::Kick:
            weights = {2, 0.3, 1, 0.5, 0.5, 0.1, 7, 0.8, 1.5, 5};
            break;
        case Threat::None:
        case Threat::Open:
            weights = {4, 2.5, 2, 3.5, 2.6, 1.6, 0.4, 0.5, 0.2, 0.3};
            break;
    }
    const auto scale = [&](Manner manner, double factor) {
        weights[static_cast<std::size_t>(manner)] *= factor;
    };
    scale(Manner::StepIn, at({0.15, 1.0, 3.0}, range));
    scale(Manner::StepOut, at({3.0, 1.0, 0.1}, range));
    scale(Manner::Retreat, at({1.3, 1.0, 0.2}, range));
    scale(Manner::Feint, at({1.0, 1.2, 0.3}, range));
    scale(Manner::Circle, temper.wanderlust);
    if (before == Manner::Hop) scale(Manner::Hop, 5);
    scale(Manner::Hop, temper.wanderlust * at({0.5, 1.0, 1.2}, range));
    normalise(weights);
    return weights;
}

}  // namespace kumite::demo
