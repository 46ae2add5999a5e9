#pragma once

#include "core/demo/choreography.h"
#include "core/demo/com_path.h"

namespace kumite::demo {

/// Plans the centre of mass of a fighter from its script: one knot per boundary, where its station
/// is, shifted and lifted as kicks, jumps, slips and ducks need, lightest where actions meet.
/// `height`: of the centre of mass in the usual guard, metres. Needs both scripts because the
/// directions are toward the opponent.
ComPath planCentreOfMass(const Script& script, const Script& opponent, double height,
                         std::uint64_t seed);

}  // namespace kumite::demo
