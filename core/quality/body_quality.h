#pragma once

#include <optional>
#include <span>

#include "core/motion/pose.h"

namespace kumite {

/// A foot point below its floor by more than this counts as in it, metres: less is the wobble of
/// the skin that a recording's markers sit on.
inline constexpr double kPenetrationDepth = 0.005;
/// Bodies in each other by more than this count, metres.
inline constexpr double kInterpenetrationDepth = 0.03;

/// A clip and where its joints are, so that no measure computes them again.
struct MeasuredBody {
    const Clip* clip = nullptr;
    JointPositions positions;
    double floor = 0;  ///< metres, see `floorHeight` in feet.h
};
MeasuredBody measuredBody(const Clip& clip, double floor);

/// Share of frame intervals in which either foot skates (feet.h); nothing without two feet.
std::optional<double> footSkateOf(const MeasuredBody& body);

/// How bodies are where they should not be.
struct Penetration {
    double share = 0;  ///< of frames, deeper than the threshold
    double worst = 0;  ///< metres; 0 if never
};
/// Of the foot points (feet.h) in the floor; nothing without feet.
std::optional<Penetration> floorPenetration(const MeasuredBody& body);

/// Of two bodies in each other, as capsules (overlap.h). Frames beyond the shorter clip are left
/// out.
Penetration interpenetration(const MeasuredBody& first, const MeasuredBody& second);

/// Mean angle between where `body` faces and the direction to `other`, over the frames in which it
/// faces anywhere; radians.
double facingError(const MeasuredBody& body, const MeasuredBody& other);

/// Between the roots of two fighters, on the floor; metres.
struct FighterDistance {
    double nearest = 0;
    double mean = 0;
    double farthest = 0;
};
FighterDistance fighterDistance(const MeasuredBody& first, const MeasuredBody& second);

/// Two moments that belong together, such as a fist at full stretch and the other's head thrown
/// back; seconds.
struct HitMoments {
    double strike = 0;
    double reaction = 0;
    double lag = 0;  ///< by which the reaction should follow the strike
};
/// Mean of how far the reactions are from their due moment, seconds; nothing without pairs.
std::optional<double> hitTimingError(std::span<const HitMoments> hits);

}  // namespace kumite
