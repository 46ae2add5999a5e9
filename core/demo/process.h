#pragma once

#include <vector>

#include "core/demo/random.h"
#include "core/demo/technique.h"

namespace kumite::demo {

/// How far the fighters are from each other when a choice is made.
enum class Range { Near, Middle, Far };

const char* name(Range range);
/// Near: hands reach. Middle: feet reach. `distance` between the centres of mass, metres.
Range rangeOf(double distance);

/// What makes a fighter this one and no other.
struct Temper {
    bool southpaw = false;           ///< the right foot and hand lead
    double aggression = 1;           ///< of attacks against everything else
    double punching = 1;             ///< of punches among attacks
    double kicking = 1;              ///< of kicks
    double jumping = 1;              ///< of jumps
    double combining = 1;            ///< of going on after a strike
    double leading = 1;              ///< of the leading against the rear side
    double reach = 1;                ///< of arms and legs against the larger body
    double speed = 1;                ///< of actions
    double guardHeight = 0;          ///< metres above the usual guard
    double crouch = 0;               ///< metres below the usual height
    double wanderlust = 1;           ///< of footwork
    double reaction = 0.22;          ///< seconds from an attack's begin to the answer's begin, mean
    double preferredDistance = 1.3;  ///< metres
};

/// A temper drawn from a seed, player 0 or 1.
Temper drawTemper(std::uint64_t seed, int player);

Side leadOf(const Temper& temper);

/// The choreographer's law: the probability of each technique as the next one, given the own
/// technique that ends, the opponent's in progress (method A6) and the range. One number per
/// entry of `techniques()`; the sum is 1.
std::vector<double> nextTechnique(const Temper& temper, const Technique& own,
                                  const Technique& opponent, Range range);

/// The same for the manner of an action of others, one number per Manner; `before` is that of the
/// own action that ends. Whoever bounces bounces on.
std::vector<double> nextManner(const Temper& temper, Manner before, const Technique& opponent,
                               Range range);

}  // namespace kumite::demo
