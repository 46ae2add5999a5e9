#include "core/demo/plan_truth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace kumite::demo {
namespace {

/// Turns times into frames of the take.
struct Clock {
    double rate;
    int frameCount;

    int frameAt(double time) const {
        return std::clamp(static_cast<int>(std::lround(time * rate)), 0, frameCount - 1);
    }
};

std::vector<double> boundaryTimes(const Script& script) {
    std::vector<double> times = {0};
    for (const PlannedAction& action : script.actions)
        times.push_back(action.end);
    return times;
}

/// The frame inside an action where the planned force is highest, the first of equals.
int peakOf(const ComPath& path, const Clock& clock, int begin, int end) {
    int peak = begin;
    double highest = -1;
    for (int frame = begin + 1; frame < end; ++frame) {
        const double force = path.force(frame / clock.rate).norm();
        if (force > highest) {
            highest = force;
            peak = frame;
        }
    }
    return peak;
}

/// Method A5: what the opponent's action that overlaps this one longest is.
std::string reactTo(const PlannedAction& action, const Script& opponent) {
    double longest = 0;
    const PlannedAction* corresponding = nullptr;
    for (auto i = static_cast<std::size_t>(opponent.actionAt(action.begin));
         i < opponent.actions.size() && opponent.actions[i].begin < action.end; ++i) {
        const PlannedAction& other = opponent.actions[i];
        const double overlap =
            std::min(action.end, other.end) - std::max(action.begin, other.begin);
        if (overlap > longest) {
            longest = overlap;
            corresponding = &other;
        }
    }
    if (!corresponding) return "others";
    if (corresponding->technique.kicks()) return "kick";
    return corresponding->technique.punches() ? "punch" : "others";
}

/// The minimum that a dip leaves in the planned force.
int dipFrame(const ComPath& path, const ForceDip& dip, const Clock& clock) {
    double lowest = 1e9;
    int frame = clock.frameAt(dip.time);
    const int from = clock.frameAt(dip.time - dip.width / 3);
    const int to = clock.frameAt(dip.time + dip.width / 3);
    for (int f = from; f <= to; ++f) {
        const double force = path.force(f / clock.rate).norm();
        if (force < lowest) {
            lowest = force;
            frame = f;
        }
    }
    return frame;
}

std::string limbOf(const Strike& strike) {
    std::string limb = strike.side == Side::Left ? "left_" : "right_";
    if (!strike.kick) return limb + "hand";
    return limb + (strike.style == KickStyle::Knee ? "knee" : "foot");
}

TrueAction actionTruth(const PlannedAction& action, const std::string& move,
                       const std::string& react, const ComPath& path, const Clock& clock) {
    TrueAction truth;
    truth.begin = clock.frameAt(action.begin);
    truth.end = clock.frameAt(action.end);
    truth.peak = peakOf(path, clock, truth.begin, truth.end);
    const Technique& t = action.technique;
    truth.label = {{"left_punch", name(t.punch[0])},
                   {"right_punch", name(t.punch[1])},
                   {"left_kick", name(t.kick[0])},
                   {"right_kick", name(t.kick[1])},
                   {"jump", name(t.jump)},
                   {"react", react},
                   {"move", move}};
    if (t.isOthers()) truth.manner = name(action.manner);
    if (action.choice) {
        const auto& all = techniques();
        truth.own = all[static_cast<std::size_t>(action.choice->own)].label();
        truth.opponent = all[static_cast<std::size_t>(action.choice->opponent)].label();
        truth.range = name(action.choice->range);
    }
    return truth;
}

TruePlayer playerTruth(const FighterPlan& plan, const FighterPlan& opponent, const Clock& clock) {
    TruePlayer player;
    const std::vector<double> times = boundaryTimes(plan.script);
    const std::vector<std::string> moves = movesOf(plan.feet, times);
    for (const double time : times)
        player.boundaries.push_back(clock.frameAt(time));
    for (std::size_t i = 0; i < plan.script.actions.size(); ++i) {
        const PlannedAction& action = plan.script.actions[i];
        player.actions.push_back(actionTruth(action, moves[i], reactTo(action, opponent.script),
                                             plan.centreOfMass, clock));
        if (action.dip && action.dip->time + action.dip->width / 2 < times.back()) {
            player.spurious.push_back(dipFrame(plan.centreOfMass, *action.dip, clock));
        }
    }
    for (std::size_t side = 0; side < 2; ++side) {
        for (const Plant& plant : plan.feet[side].plants) {
            const FrameRange range = {clock.frameAt(plant.begin), clock.frameAt(plant.end) + 1};
            if (plant.begin < times.back()) player.contacts[side].push_back(range);
        }
    }
    for (const Strike& strike : plan.strikes) {
        if (strike.feint || strike.hit > times.back()) continue;
        player.hits.push_back({clock.frameAt(strike.hit), limbOf(strike), name(strike.target),
                               name(strike.outcome), strike.point});
    }
    return player;
}

/// The rows of the law that were drawn from, each once, in the order of techniques and ranges.
std::vector<ProcessRow> processOf(const std::array<FighterPlan, 2>& plans) {
    const auto& all = techniques();
    std::vector<ProcessRow> rows;
    for (std::size_t mover = 0; mover < 2; ++mover) {
        const Script& script = plans[mover].script;
        std::map<std::tuple<int, int, int>, Choice> choices;
        for (const PlannedAction& action : script.actions) {
            if (!action.choice) continue;
            const Choice& c = *action.choice;
            choices[{c.own, c.opponent, static_cast<int>(c.range)}] = c;
        }
        for (const auto& [key, c] : choices) {
            const Technique& own = all[static_cast<std::size_t>(c.own)];
            const Technique& opponent = all[static_cast<std::size_t>(c.opponent)];
            ProcessRow row{
                static_cast<int>(mover) + 1, own.label(), opponent.label(), name(c.range), {}};
            const auto law = nextTechnique(script.temper, own, opponent, c.range);
            for (std::size_t i = 0; i < law.size(); ++i) {
                if (law[i] > 0) row.next.emplace_back(all[i].label(), law[i]);
            }
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

}  // namespace

Truth truthOf(const std::array<FighterPlan, 2>& plans, double rate, int frameCount,
              std::uint64_t seed) {
    const Clock clock{rate, frameCount};
    Truth truth;
    truth.rate = rate;
    truth.seed = seed;
    truth.players = {playerTruth(plans[0], plans[1], clock),
                     playerTruth(plans[1], plans[0], clock)};
    truth.process = processOf(plans);
    return truth;
}

}  // namespace kumite::demo
