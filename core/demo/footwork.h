#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/demo/choreography.h"

namespace kumite::demo {

/// A foot on the ground: its toe joint does not move from `begin` to `end`.
struct Plant {
    double begin = 0;
    double end = 0;
    Eigen::Vector2d toe;  ///< x, z in metres
    double yaw = 0;       ///< of the foot when it lands, radians, 0 along +z
};

enum class Swing { Step, Hop, Jump, Kick };

/// What a foot does: plants with swings between them, `swings[i]` from plants[i] to plants[i+1].
struct FootTrack {
    std::vector<Plant> plants;
    std::vector<Swing> swings;

    bool onGround(double time) const;
    /// Index of the plant at or before a time.
    int plantAt(double time) const;
};

using Feet = std::array<FootTrack, 2>;  ///< left, right

/// Direction from one place to the other, radians, 0 along +z.
double yawToward(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// Where both feet go, from what the actions need (kicks, hops, jumps) and from where the body
/// goes: at a boundary, when the body is light, the foot that is farthest from home steps.
Feet planFeet(const Script& script, const Script& opponent, std::uint64_t seed);

/// The label's aspect `move` (method A5) of the actions between these boundaries, from the plan:
/// 'L', 'R' or 'F' at begin and end.
std::vector<std::string> movesOf(const Feet& feet, std::span<const double> boundaries);

}  // namespace kumite::demo
