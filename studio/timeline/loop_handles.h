#pragma once

#include <optional>

#include "studio/app/transport.h"
#include "studio/timeline/time_mapping.h"

namespace kumite::studio {

/// The ends of the loop range, which are dragged on the ruler.
enum class LoopEnd { In, Out };

/// The range that is played in a loop; nothing where none was set.
std::optional<TimeSpan> loopRange(const Transport& transport);

/// The end whose handle is under x; the nearer of both, where they meet the one that can still be
/// pulled away.
std::optional<LoopEnd> loopEndAt(const std::optional<TimeSpan>& range, const TimeMapping& mapping,
                                 double x);

/// The range with one end dragged to a moment; the ends never cross.
TimeSpan withLoopEnd(const TimeSpan& range, LoopEnd end, double seconds);

}  // namespace kumite::studio
