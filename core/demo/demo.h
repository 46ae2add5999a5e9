#pragma once

#include <array>
#include <cstdint>

#include "core/base/progress.h"
#include "core/demo/truth.h"
#include "core/motion/motion.h"

namespace kumite::demo {

struct DemoSettings {
    double seconds = 90;  ///< 1 or more
    double rate = 60;     ///< Hz, 24 to 240
    std::uint64_t seed = 1;
};

/// A made bout of two fighters: their motions on skeletons of their own in one space, and the
/// truth about it.
struct DemoBout {
    std::array<Motion, 2> motions;
    Truth truth;
};

/// Makes a bout (method D): choreography, centres of mass from planned forces, feet, postures and
/// strikes, poses. The same seed gives the same bytes on any number of threads; another rate gives
/// the same fight. Throws Error if the settings are out of range; Cancelled.
DemoBout makeDemoBout(const DemoSettings& settings, const Progress& progress = {});

}  // namespace kumite::demo
