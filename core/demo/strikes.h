#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/demo/choreography.h"

namespace kumite::demo {

enum class Outcome { Lands, Blocked, Dodged, Short };

const char* name(Outcome outcome);

/// One hand or foot going out and coming back.
struct Strike {
    Side side = Side::Left;
    bool kick = false;
    KickStyle style = KickStyle::Front;
    Target target = Target::Head;
    double start = 0;  ///< seconds: leaves the guard or the ground
    double hit = 0;    ///< farthest out
    double end = 0;    ///< back again
    double hook = 0;   ///< how far a punch swings round, -1 to 1; straight at 0
    double effort = 1;
    bool feint = false;  ///< goes half way and aims at nothing
    Outcome outcome = Outcome::Lands;
    /// Where the knuckles, the foot or the knee shall be at `hit`, metres.
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

/// From the ankle to the sole, along the shank, metres: what a front kick hits with.
inline constexpr double kSole = 0.08;

/// All strikes of a script in order of their hits. Points and outcomes are not yet filled in.
std::vector<Strike> strikesOf(const Script& script);

/// What becomes of a strike, by what the opponent does at that time. `distance` between the
/// centres of mass at the moment of the hit, metres.
Outcome outcomeOf(const Strike& strike, const Script& opponent, double distance);

}  // namespace kumite::demo
