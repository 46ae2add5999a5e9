#pragma once

#include "core/demo/fight.h"
#include "core/demo/truth.h"

namespace kumite::demo {

/// What the plan of a bout says about it, in frames. `frameCount` of the take at `rate`.
Truth truthOf(const std::array<FighterPlan, 2>& plans, double rate, int frameCount,
              std::uint64_t seed);

}  // namespace kumite::demo
