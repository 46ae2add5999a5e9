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
    const double outward = sign(side);
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
    Planner(const Script& script, const Script& opponent, const ComPath& path, std::uint64_t seed)
        : script_(script), opponent_(opponent), path_(path), random_(seed, 7) {
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

    Vector2d bodyAt(double time) const {
        const Eigen::Vector3d body = path_.position(time);
        return {body.x(), body.z()};
    }

    Home homeAt(Side side, double time) const {
        const double facing = yawToward(bodyAt(time), opponent_.stationAt(time));
        return homeOf(script_.temper, side, bodyAt(time), facing);
    }

    /// Lifts the foot at `from`; it lands at `to`, where it will be of most use.
    void swing(Side side, double from, double to, Swing kind) {
        swingTo(homeAt(side, to + 0.25), side, from, to, kind);
    }

    void swingTo(Home home, Side side, double from, double to, Swing kind) {
        FootTrack& t = track(side);
        t.plants.back().end = from;
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
        if (next.technique.kicks() && next.technique.jump == Jump::Others) {
            stepUnder(next, time - length / 2, std::min(time + length / 2, latest));
            return;
        }
        constexpr double kWorthAStep = 0.075;
        step(time - length / 2, std::min(time + length / 2, latest), kWorthAStep, true);
        // The other foot follows in the middle of a longer action where it is left far behind.
        const bool free = !next.technique.kicks() && next.technique.jump == Jump::Others;
        if (free && next.duration() > 0.5) {
            constexpr double kLeftBehind = 0.17;
            const double middle = next.begin + next.duration() / 2;
            step(middle - 0.11, middle + 0.11, kLeftBehind, false);
        }
    }

    /// Sets the foot that will carry a kick where the body will be when the leg is out.
    void stepUnder(const PlannedAction& kick, double from, double to) {
        const Side support = kick.technique.legOutAtEnd(Side::Left) ? Side::Right : Side::Left;
        if (!isFree(support, from) || !isFree(other(support), from)) return;
        const Vector2d body = bodyAt(kick.end);
        const Vector2d forward = (opponent_.stationAt(kick.end) - body).normalized();
        const double outward = sign(support);
        const bool lead = support == leadOf(script_.temper);
        Home home;
        home.toe = body + (lead ? 0.10 : 0.05) * forward;
        home.yaw = std::atan2(forward.x(), forward.y()) + outward * (lead ? 0.2 : 0.6);
        constexpr double kFarEnough = 0.10;
        if ((home.toe - track(support).plants.back().toe).norm() < kFarEnough) return;
        swingTo(home, support, from, to, Swing::Step);
    }

    /// Moves the foot that is farthest from home, if that is worth a step.
    void step(double from, double to, double worth, bool mayTap) {
        std::array<double, 2> need{};
        for (const Side side : kSides) {
            if (!isFree(side, from) || !isFree(other(side), from)) return;
            const Home home = homeAt(side, to + 0.25);
            const Plant& plant = track(side).plants.back();
            need[static_cast<std::size_t>(side)] =
                (home.toe - plant.toe).norm() + 0.2 * std::abs(wrapped(home.yaw - plant.yaw));
        }
        const Side side = need[0] >= need[1] ? Side::Left : Side::Right;
        const double most = std::max(need[0], need[1]);
        constexpr double kRestless = 0.3;
        const bool restless = mayTap && random_.chance(kRestless * script_.temper.wanderlust);
        if (most < worth && !restless) return;
        // A restless foot taps where it stands, the one that has rested longer.
        const Side tapping =
            track(Side::Left).plants.back().begin <= track(Side::Right).plants.back().begin
                ? Side::Left
                : Side::Right;
        swing(most < worth ? tapping : side, from, to, Swing::Step);
    }

    const Script& script_;
    const Script& opponent_;
    const ComPath& path_;
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

Feet planFeet(const Script& script, const Script& opponent, const ComPath& centreOfMass,
              std::uint64_t seed) {
    return Planner(script, opponent, centreOfMass, seed).plan();
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
