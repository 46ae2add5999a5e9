#include "core/demo/choreography.h"

#include <algorithm>
#include <cmath>

namespace kumite::demo {
namespace {

using Eigen::Vector2d;

constexpr double kNearest = 0.88;    ///< between centres of mass, metres
constexpr double kLastChoice = 1.6;  ///< seconds before the end nothing new is begun

bool isAttack(const Technique& t) {
    return t.punches() || t.kicks();
}

/// One fighter while the bout is being drawn.
struct Player {
    Script script;
    Random random;

    const PlannedAction& current() const { return script.actions.back(); }
};

double usualDuration(const PlannedAction& action) {
    const Technique& t = action.technique;
    if (t.jump == Jump::Up) return t.kicks() ? 0.66 : 0.60;
    if (t.jump == Jump::Down) return 0.62;
    if (t.kickOf(Side::Left) == Kick::DownUp || t.kickOf(Side::Right) == Kick::DownUp) return 0.78;
    if (t.kicks()) return action.style == KickStyle::Knee ? 0.52 : 0.60;
    if (t.legOutAtBegin(Side::Left) || t.legOutAtBegin(Side::Right)) return 0.56;
    if (t.punches() || !t.isOthers()) {
        const bool whole =
            t.punchOf(Side::Left) == Punch::FwdBwd || t.punchOf(Side::Right) == Punch::FwdBwd;
        return whole ? 0.52 : 0.44;
    }
    switch (action.manner) {
        case Manner::Hop:
            return 0.46;
        case Manner::Block:
        case Manner::Slip:
        case Manner::Retreat:
            return 0.52;
        case Manner::Duck:
            return 0.58;
        default:
            return 0.62;
    }
}

/// How the technique is done this time.
void drawDetails(PlannedAction& action, const PlannedAction& before, Player& player) {
    Random& random = player.random;
    action.effort = random.normalWithin(1.0, 0.07, 0.82, 1.15);
    action.variation = static_cast<int>(random.uniform(0, 1e6));
    const Technique& t = action.technique;
    if (t.kicks()) {
        const int style = random.pick(std::array{0.42, 0.46, 0.12});
        action.style = static_cast<KickStyle>(style);
        if (t.jump == Jump::Up) action.style = KickStyle::Front;
        const int target = action.style == KickStyle::Round
                               ? random.pick(std::array{0.34, 0.36, 0.30})
                               : random.pick(std::array{0.18, 0.82, 0.0});
        action.target =
            action.style == KickStyle::Knee ? Target::Trunk : static_cast<Target>(target);
    } else if (t.punches()) {
        action.target = random.chance(0.78) ? Target::Head : Target::Trunk;
    } else {
        action.style = before.style;
        action.target = before.target;
    }
    double duration = usualDuration(action) / player.script.temper.speed *
                      random.normalWithin(1.0, 0.12, 0.76, 1.3);
    const bool legMoves = t.kicks() || t.legOutAtBegin(Side::Left) || t.legOutAtBegin(Side::Right);
    const bool mayBeSlow = legMoves && t.jump == Jump::Others && action.style != KickStyle::Knee;
    if (mayBeSlow && random.chance(0.13)) {
        duration = random.uniform(1.0, 1.25);
        ForceDip dip;
        dip.time = action.begin + duration * random.uniform(0.46, 0.54);
        dip.width = random.uniform(0.30, 0.36);
        dip.depth = random.uniform(0.12, 0.22);
        action.dip = dip;
    }
    action.end = action.begin + std::max(0.36, duration);
    if (t.jump == Jump::Up) action.flightAtEnd = random.uniform(0.30, 0.34);
    if (t.isOthers() && action.manner == Manner::Hop) {
        action.flightAtEnd = random.uniform(0.11, 0.13);
    }
}

/// Distance of the centres of mass from which the strike just lands, metres.
double reachOf(const PlannedAction& action, const Temper& temper) {
    const Technique& t = action.technique;
    double reach = action.target == Target::Head ? 0.91 : 0.89;
    if (t.kicks()) {
        const bool high = action.target == Target::Head;
        switch (action.style) {
            case KickStyle::Front:
                reach = high ? 0.90 : 1.03;
                break;
            case KickStyle::Round:
                reach = high ? 0.89 : 1.0;
                break;
            case KickStyle::Knee:
                reach = 0.76;
                break;
        }
        if (t.legOutAtEnd(leadOf(temper))) reach -= 0.05;
        reach -= 0.05;  // better too near than short
        if (t.jump == Jump::Up) reach += 0.05;
    }
    return reach * temper.reach;
}

/// Where to be at the action's end. `opponent`: where the other is expected then.
Vector2d stationFor(const PlannedAction& action, const Vector2d& here, const Vector2d& opponent,
                    Player& player) {
    Random& random = player.random;
    const Temper& temper = player.script.temper;
    const Vector2d way = opponent - here;
    const double distance = std::max(0.3, way.norm());
    const Vector2d forward = way / distance;
    const Vector2d aside(forward.y(), -forward.x());
    double ahead = random.normal(0, 0.03);
    double sideways = random.normal(0, 0.03);
    const Technique& t = action.technique;
    if (isAttack(t)) {
        ahead += std::max(-0.12, distance - reachOf(action, temper));
    } else if (!t.isOthers()) {
        ahead += t.punches() ? 0.0
                             : std::clamp(0.4 * (distance - temper.preferredDistance), -0.14, 0.05);
    } else {
        const double homing = distance - temper.preferredDistance;
        switch (action.manner) {
            case Manner::Guard:
                ahead += 0.4 * homing;
                break;
            case Manner::Feint:
                ahead += 0.10 + 0.2 * homing;
                break;
            case Manner::StepIn:
                ahead += std::max(0.12, 0.7 * homing);
                break;
            case Manner::StepOut:
                ahead += std::min(-0.18, 0.9 * homing);
                break;
            case Manner::Circle:
                sideways += (random.chance(0.5) ? 1 : -1) * random.uniform(0.22, 0.4);
                ahead += 0.4 * homing;
                break;
            case Manner::Hop:
                sideways += random.normal(0, 0.10);
                ahead += 0.4 * homing;
                break;
            case Manner::Block:
                ahead -= 0.05;
                break;
            case Manner::Slip:
                ahead -= 0.02;
                break;
            case Manner::Duck:
                ahead += 0.02;
                break;
            case Manner::Retreat:
                ahead -= random.uniform(0.26, 0.4);
                break;
        }
    }
    const double fastest = (isAttack(t) ? 0.95 : 0.8) * action.duration();
    Vector2d move = ahead * forward + sideways * aside;
    // The ring: whoever is far out tends back to the middle.
    const double out = here.norm();
    if (out > 1.6) move -= 0.10 * (out - 1.6) * here / out;
    if (move.norm() > fastest) move *= fastest / move.norm();
    Vector2d there = here + move;
    const Vector2d gap = there - opponent;
    const bool knee = t.kicks() && action.style == KickStyle::Knee;
    const double nearest = knee ? 0.74 : kNearest;
    if (gap.norm() < nearest) there = opponent + gap.normalized() * nearest;
    return there;
}

Vector2d expectedAt(const Script& script, double time) {
    return time >= script.actions.back().end ? script.actions.back().station
                                             : script.stationAt(time);
}

/// Begins the next action of `mover` where its current one ends.
void beginNext(Player& mover, const Player& opponent, double seconds) {
    const PlannedAction before = mover.current();
    PlannedAction next;
    next.begin = before.end;
    const Vector2d there = expectedAt(opponent.script, next.begin);
    const Range range = rangeOf((there - before.station).norm());
    const Technique& inProgress = opponent.script
                                      .actions[static_cast<std::size_t>(opponent.script.actionAt(
                                          std::nextafter(next.begin, 0.0)))]
                                      .technique;
    const std::vector<double> law =
        nextTechnique(mover.script.temper, before.technique, inProgress, range);
    if (next.begin < seconds - kLastChoice) {
        next.technique = techniques()[static_cast<std::size_t>(mover.random.pick(law))];
        next.choice = Choice{indexOf(before.technique), indexOf(inProgress), range};
    } else {
        // The bell: what is out comes back, nothing new is begun.
        for (std::size_t i = 0; i < law.size(); ++i) {
            if (law[i] > 0 && !techniques()[i].anyOutAtEnd()) {
                next.technique = techniques()[i];
                break;
            }
        }
    }
    if (next.technique.isOthers()) {
        const auto manners = nextManner(mover.script.temper, before.manner, inProgress, range);
        const bool late = next.begin >= seconds - kLastChoice;
        next.manner = late ? Manner::Guard : static_cast<Manner>(mover.random.pick(manners));
    }
    drawDetails(next, before, mover);
    // Two boundaries in one frame would leave open who saw what.
    constexpr double kApart = 0.06;
    const double gap = next.end - opponent.current().end;
    if (std::abs(gap) < kApart) next.end += kApart - gap;
    next.station = stationFor(next, before.station, expectedAt(opponent.script, next.end), mover);
    mover.script.actions.push_back(next);
}

/// An attack begins: what the other idles at ends a reaction time later.
void provoke(Player& defender, const PlannedAction& attack) {
    PlannedAction& idle = defender.script.actions.back();
    if (!idle.technique.isOthers() || isDefence(idle.manner) || idle.begin >= attack.begin) return;
    const double lag =
        defender.random.normalWithin(defender.script.temper.reaction, 0.035, 0.14, 0.32);
    const double end = attack.begin + lag;
    constexpr double kShortest = 0.38;
    if (end - idle.begin < kShortest || end > idle.end + 0.2 || end > attack.end - 0.06) return;
    const double share = (end - idle.begin) / idle.duration();
    const Vector2d from = defender.script.stationAt(idle.begin);
    idle.station = from + std::min(1.0, share) * (idle.station - from);
    idle.end = end;
}

/// The last boundary is the bout's end; what would be too short joins its neighbour.
void endAt(Script& script, double seconds) {
    constexpr double kShortest = 0.35;
    auto& actions = script.actions;
    while (actions.size() > 1 && actions.back().begin > seconds - kShortest)
        actions.pop_back();
    actions.back().end = seconds;
    actions.back().flightAtEnd = 0;
}

}  // namespace

int Script::actionAt(double time) const {
    const auto after = std::upper_bound(
        actions.begin(), actions.end(), time,
        [](double value, const PlannedAction& action) { return value < action.begin; });
    return std::max(0, static_cast<int>(after - actions.begin()) - 1);
}

Vector2d Script::stationAt(double time) const {
    const int index = actionAt(time);
    const PlannedAction& action = actions[static_cast<std::size_t>(index)];
    const Vector2d from = index == 0 ? start : actions[static_cast<std::size_t>(index) - 1].station;
    const double s = std::clamp((time - action.begin) / action.duration(), 0.0, 1.0);
    return from + s * (action.station - from);
}

std::array<Script, 2> choreograph(std::uint64_t seed, double seconds) {
    std::array<Player, 2> players = {Player{{}, Random(seed, 1)}, Player{{}, Random(seed, 2)}};
    for (std::size_t i = 0; i < 2; ++i) {
        Player& player = players[i];
        player.script.temper = drawTemper(seed, static_cast<int>(i));
        player.script.start = Vector2d(0, i == 0 ? -0.75 : 0.75);
        PlannedAction first;
        first.end = player.random.uniform(0.45, 0.6) + 0.1 * static_cast<double>(i);
        first.station = player.script.start;
        player.script.actions.push_back(first);
    }
    for (;;) {
        const std::size_t who = players[0].current().end <= players[1].current().end ? 0 : 1;
        if (players[who].current().end >= seconds) break;
        beginNext(players[who], players[1 - who], seconds);
        if (isAttack(players[who].current().technique)) {
            provoke(players[1 - who], players[who].current());
        }
    }
    for (Player& player : players)
        endAt(player.script, seconds);
    return {players[0].script, players[1].script};
}

}  // namespace kumite::demo
