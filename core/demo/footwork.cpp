#include "core/demo/footwork.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace kumite::demo {
namespace {

using Eigen::Vector2d;

constexpr std::array<Side, 2> kSides = {Side::Left, Side::Right};
constexpr double kShortestPlant = 0.06;

struct Home {
    Vector2d toe;
    double yaw = 0;
};

/// Where a foot belongs when the body stands at `station` and faces `facing`.
Home homeOf(const Temper& temper, Side side, const Vector2d& station, double facing) {
    const bool lead = side == leadOf(temper);
    const double outward = side == Side::Left ? 1.0 : -1.0;
    const double ahead = lead ? 0.29 : -0.13;
    const double aside = outward * (lead ? 0.10 : 0.15);
    const Vector2d forward(std::sin(facing), std::cos(facing));
    const Vector2d left(std::cos(facing), -std::sin(facing));
    constexpr double kLeadTurn = -0.26;  // turned in
    constexpr double kRearTurn = 0.75;   // turned out
    return {station + ahead * forward + aside * left,
            facing + outward * (lead ? kLeadTurn : kRearTurn)};
}

double wrapped(double angle) {
    return std::remainder(angle, 2 * std::numbers::pi);
}

/// The planner's view of one fighter.
class Planner {
public:
    Planner(const Script& script, const Script& opponent, std::uint64_t seed)
        : script_(script), opponent_(opponent), random_(seed, 7) {
        for (const Side side : kSides) {
            const Home home = homeAt(side, 0);
            track(side).plants.push_back({0, kOpen, home.toe, home.yaw});
        }
    }

    Feet plan() {
        for (std::size_t i = 0; i < script_.actions.size(); ++i) {
            const PlannedAction& action = script_.actions[i];
            planKicks(action);
            if (i + 1 < script_.actions.size()) planBoundary(i);
        }
        const double end = script_.actions.back().end;
        for (const Side side : kSides)
            track(side).plants.back().end = end + 1;
        return feet_;
    }

private:
    static constexpr double kOpen = std::numeric_limits<double>::infinity();

    FootTrack& track(Side side) { return feet_[static_cast<std::size_t>(side)]; }

    Vector2d stationAt(double time) const { return script_.stationAt(time); }

    Home homeAt(Side side, double time) const {
        const double facing = yawToward(stationAt(time), opponent_.stationAt(time));
        return homeOf(script_.temper, side, stationAt(time), facing);
    }

    /// Lifts the foot at `from`; it lands at `to`, where it will be of most use.
    void swing(Side side, double from, double to, Swing kind) {
        FootTrack& t = track(side);
        t.plants.back().end = from;
        Home home = homeAt(side, to + 0.2);
        home.toe += Vector2d(random_.normal(0, 0.015), random_.normal(0, 0.015));
        home.yaw += random_.normal(0, 0.06);
        t.plants.push_back({to, kOpen, home.toe, home.yaw});
        t.swings.push_back(kind);
    }

    bool isFree(Side side, double from) {
        return track(side).plants.back().begin + kShortestPlant <= from;
    }

    void planKicks(const PlannedAction& action) {
        for (const Side side : kSides) {
            const Technique& t = action.technique;
            const double duration = action.duration();
            if (t.legOutAtBegin(side)) {
                const double share = t.kickOf(side) == Kick::DownUp ? 0.44 : 0.62;
                if (action.technique.jump != Jump::Down)
                    land(side, action.begin + share * duration);
            }
            if (t.legOutAtEnd(side) && t.jump == Jump::Others) {
                const double share = t.kickOf(side) == Kick::DownUp ? 0.56 : 0.34;
                double from = action.begin + share * duration;
                from = std::max(from, track(side).plants.back().begin + kShortestPlant);
                swing(side, from, action.end + 0.3, Swing::Kick);
            }
        }
    }

    /// Now it is known when the kicking foot lands.
    void land(Side side, double time) {
        Plant& plant = track(side).plants.back();
        const Home home = homeAt(side, time + 0.2);
        plant.begin = time;
        plant.toe = home.toe;
        plant.yaw = home.yaw;
    }

    /// The boundary at the end of action i.
    void planBoundary(std::size_t i) {
        const PlannedAction& action = script_.actions[i];
        const double time = action.end;
        if (action.flightAtEnd > 0) {
            const bool jump = action.technique.jump == Jump::Up;
            for (const Side side : kSides) {
                const bool kick = action.technique.legOutAtEnd(side);
                swing(side, time - action.flightAtEnd / 2 - (kick ? 0.06 : 0.0),
                      time + action.flightAtEnd / 2,
                      kick ? Swing::Kick : (jump ? Swing::Jump : Swing::Hop));
            }
            return;
        }
        if (action.technique.legOutAtEnd(Side::Left) || action.technique.legOutAtEnd(Side::Right))
            return;
        const PlannedAction& next = script_.actions[i + 1];
        // Room until the next thing that needs both feet.
        double latest = time + 0.15;
        if (next.technique.kicks()) latest = next.begin + 0.28 * next.duration();
        const double length = random_.uniform(0.25, 0.30);
        const double from = time - length / 2;
        const double to = std::min(time + length / 2, latest);
        step(from, to);
    }

    void step(double from, double to) {
        std::array<double, 2> need{};
        for (const Side side : kSides) {
            if (!isFree(side, from) || !isFree(other(side), from)) return;
            const Home home = homeAt(side, to + 0.2);
            const Plant& plant = track(side).plants.back();
            need[static_cast<std::size_t>(side)] =
                (home.toe - plant.toe).norm() + 0.2 * std::abs(wrapped(home.yaw - plant.yaw));
        }
        const Side side = need[0] >= need[1] ? Side::Left : Side::Right;
        const double most = std::max(need[0], need[1]);
        constexpr double kWorthAStep = 0.085;
        constexpr double kRestless = 0.3;
        const bool restless = random_.chance(kRestless * script_.temper.wanderlust);
        if (most < kWorthAStep && !restless) return;
        // A restless foot taps where it stands, the one that has rested longer.
        const Side tapping =
            track(Side::Left).plants.back().begin <= track(Side::Right).plants.back().begin
                ? Side::Left
                : Side::Right;
        swing(most < kWorthAStep ? tapping : side, from, to, Swing::Step);
    }

    const Script& script_;
    const Script& opponent_;
    Random random_;
    Feet feet_;
};

/// A time in which one foot alone carries the body, or none ('F').
struct Stance {
    double begin = 0;
    double end = 0;
    char symbol = 'L';
};

/// All of them in order of time.
std::vector<Stance> stancesOf(const Feet& feet) {
    std::vector<double> moments = {0};
    for (const FootTrack& foot : feet) {
        for (const Plant& plant : foot.plants) {
            moments.push_back(plant.begin);
            moments.push_back(plant.end);
        }
    }
    std::sort(moments.begin(), moments.end());
    std::vector<Stance> stances;
    for (std::size_t i = 0; i + 1 < moments.size(); ++i) {
        if (moments[i] == moments[i + 1]) continue;
        const double middle = (moments[i] + moments[i + 1]) / 2;
        const bool left = feet[0].onGround(middle);
        const bool right = feet[1].onGround(middle);
        if (left && right) continue;
        stances.push_back({moments[i], moments[i + 1], left ? 'L' : (right ? 'R' : 'F')});
    }
    return stances;
}

char symbolAt(const std::vector<Stance>& stances, double time) {
    const auto after =
        std::upper_bound(stances.begin(), stances.end(), time,
                         [](double value, const Stance& stance) { return value < stance.begin; });
    if (after != stances.begin() && time <= (after - 1)->end) return (after - 1)->symbol;
    // Double stance: the nearest single one on either side.
    const auto isSingle = [](const Stance& stance) { return stance.symbol != 'F'; };
    const auto later = std::find_if(after, stances.end(), isSingle);
    const auto earlier = std::find_if(std::make_reverse_iterator(after), stances.rend(), isSingle);
    if (later == stances.end() && earlier == stances.rend()) return 'L';
    if (later == stances.end()) return earlier->symbol;
    if (earlier == stances.rend()) return later->symbol;
    return time - earlier->end < later->begin - time ? earlier->symbol : later->symbol;
}

}  // namespace

bool FootTrack::onGround(double time) const {
    const Plant& plant = plants[static_cast<std::size_t>(plantAt(time))];
    return time <= plant.end;
}

int FootTrack::plantAt(double time) const {
    const auto after =
        std::upper_bound(plants.begin(), plants.end(), time,
                         [](double value, const Plant& plant) { return value < plant.begin; });
    return std::max(0, static_cast<int>(after - plants.begin()) - 1);
}

double yawToward(const Vector2d& from, const Vector2d& to) {
    return std::atan2(to.x() - from.x(), to.y() - from.y());
}

Feet planFeet(const Script& script, const Script& opponent, std::uint64_t seed) {
    return Planner(script, opponent, seed).plan();
}

std::vector<std::string> movesOf(const Feet& feet, std::span<const double> boundaries) {
    const std::vector<Stance> stances = stancesOf(feet);
    std::vector<std::string> moves;
    for (std::size_t i = 0; i + 1 < boundaries.size(); ++i) {
        moves.push_back(
            {symbolAt(stances, boundaries[i]), '-', symbolAt(stances, boundaries[i + 1])});
    }
    return moves;
}

}  // namespace kumite::demo
