#include "studio/timeline/loop_handles.h"

#include <algorithm>
#include <cmath>

namespace kumite::studio {

std::optional<TimeSpan> loopRange(const Transport& transport) {
    if (!transport.loopIn() && !transport.loopOut()) return std::nullopt;
    return TimeSpan{transport.loopIn().value_or(transport.span().begin),
                    transport.loopOut().value_or(transport.span().end)};
}

std::optional<LoopEnd> loopEndAt(const std::optional<TimeSpan>& range, const TimeMapping& mapping,
                                 double x) {
    constexpr double kReach = 6;  // pixels
    if (!range) return std::nullopt;
    const double toIn = std::abs(x - mapping.xOf(range->begin));
    const double toOut = std::abs(x - mapping.xOf(range->end));
    if (std::min(toIn, toOut) > kReach) return std::nullopt;
    if (toIn == toOut) return x < mapping.xOf(range->begin) ? LoopEnd::In : LoopEnd::Out;
    return toIn < toOut ? LoopEnd::In : LoopEnd::Out;
}

TimeSpan withLoopEnd(const TimeSpan& range, LoopEnd end, double seconds) {
    if (end == LoopEnd::In) return {std::min(seconds, range.end), range.end};
    return {range.begin, std::max(seconds, range.begin)};
}

}  // namespace kumite::studio
