#pragma once

#include <array>

#include "core/demo/figure.h"
#include "core/demo/suit.h"

namespace kumite::demo {

/// Plans a whole bout for two bodies: scripts, centres of mass, feet, strikes with their aims and
/// outcomes, postures. A strike that lands is aimed at where the opponent's head, trunk or leg
/// really is at that moment.
std::array<FighterPlan, 2> planFight(std::uint64_t seed, double seconds,
                                     const std::array<BodySize, 2>& bodies);

/// Where a strike touches at a time: knuckles, sole, instep or knee.
Eigen::Vector3d strikingPoint(const BodySize& size, const Strike& strike, const Figure& figure);

}  // namespace kumite::demo
