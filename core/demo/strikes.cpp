#include "core/demo/strikes.h"

#include <algorithm>
#include <array>

namespace kumite::demo {
namespace {

constexpr std::array<Side, 2> kSides = {Side::Left, Side::Right};

/// Small differences of one action, drawn from its own seed.
struct Variation {
    explicit Variation(const PlannedAction& action)
        : random(static_cast<std::uint64_t>(action.variation), 11) {}
    Random random;
};

Strike punchIn(const PlannedAction& action, Side side) {
    Variation v(action);
    Strike strike;
    strike.side = side;
    strike.target = action.target;
    strike.effort = action.effort;
    strike.hook = v.random.chance(0.25) ? v.random.uniform(0.5, 1.0) : v.random.uniform(-0.1, 0.25);
    return strike;
}

/// A punch that begins in action i, stays out at its end and returns in the next.
Strike punchOut(const std::vector<PlannedAction>& actions, std::size_t i, Side side) {
    const PlannedAction& out = actions[i];
    Strike strike = punchIn(out, side);
    Variation v(out);
    const double share = out.technique.armOutAtBegin(side) ? 0.36 : v.random.uniform(0.12, 0.32);
    strike.start = out.begin + share * out.duration();
    strike.hit = out.end + v.random.uniform(-0.012, 0.012);
    strike.end = strike.hit + 0.35;
    if (i + 1 < actions.size()) {
        const PlannedAction& back = actions[i + 1];
        const double until = back.technique.armOutAtEnd(side) ? 0.52 : v.random.uniform(0.65, 0.95);
        strike.end = back.begin + until * back.duration();
    }
    return strike;
}

Strike quickPunch(const PlannedAction& action, Side side) {
    Strike strike = punchIn(action, side);
    Variation v(action);
    strike.hit = action.begin + v.random.uniform(0.46, 0.56) * action.duration();
    strike.start = strike.hit - std::min(0.26, 0.42 * action.duration());
    strike.end = strike.hit + 0.40 * action.duration();
    return strike;
}

Strike kickOut(const std::vector<PlannedAction>& actions, std::size_t i, Side side) {
    const PlannedAction& out = actions[i];
    Strike strike;
    strike.side = side;
    strike.kick = true;
    strike.style = out.style;
    strike.target = out.target;
    strike.effort = out.effort;
    strike.start = out.begin;
    strike.hit = out.end;
    strike.end = i + 1 < actions.size() ? actions[i + 1].end : out.end + 0.3;
    return strike;
}

}  // namespace

const char* name(Outcome outcome) {
    constexpr std::array names = {"lands", "blocked", "dodged", "short"};
    return names[static_cast<std::size_t>(outcome)];
}

std::vector<Strike> strikesOf(const Script& script) {
    std::vector<Strike> strikes;
    const auto& actions = script.actions;
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const PlannedAction& action = actions[i];
        const Technique& t = action.technique;
        for (const Side side : kSides) {
            if (t.armOutAtEnd(side)) strikes.push_back(punchOut(actions, i, side));
            if (t.punchOf(side) == Punch::FwdBwd) strikes.push_back(quickPunch(action, side));
            if (t.legOutAtEnd(side)) strikes.push_back(kickOut(actions, i, side));
        }
        if (t.isOthers() && action.manner == Manner::Feint) {
            Strike feint = quickPunch(action, leadOf(script.temper));
            feint.feint = true;
            strikes.push_back(feint);
        }
    }
    std::stable_sort(strikes.begin(), strikes.end(),
                     [](const Strike& a, const Strike& b) { return a.hit < b.hit; });
    return strikes;
}

Outcome outcomeOf(const Strike& strike, const Script& opponent, double distance) {
    const PlannedAction& answer =
        opponent.actions[static_cast<std::size_t>(opponent.actionAt(strike.hit))];
    double reach = strike.target == Target::Trunk ? 1.04 : 1.08;
    if (strike.kick) reach = strike.style == KickStyle::Knee ? 0.95 : 1.18;
    if (distance > reach) return Outcome::Short;
    if (!answer.technique.isOthers()) return Outcome::Lands;
    const double since = strike.hit - answer.begin;
    constexpr double kTimeToMove = 0.10;
    if (since < kTimeToMove || strike.hit > answer.end - 0.05) return Outcome::Lands;
    switch (answer.manner) {
        case Manner::Block:
            return strike.target == Target::Leg ? Outcome::Lands : Outcome::Blocked;
        case Manner::Slip:
        case Manner::Duck:
            return strike.target == Target::Head ? Outcome::Dodged : Outcome::Lands;
        default:
            return Outcome::Lands;
    }
}

}  // namespace kumite::demo
