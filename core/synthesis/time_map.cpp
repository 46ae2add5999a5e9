#include "core/synthesis/time_map.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

/// A cubic between two knots at u in [0, 1].
double hermite(const TimeMap::Knot& a, const TimeMap::Knot& b, double u) {
    const double length = b.shown - a.shown;
    const double v = 1 - u;
    return a.source * (1 + 2 * u) * v * v + b.source * u * u * (3 - 2 * u) +
           length * u * v * (a.pace * v - b.pace * u);
}

double hermitePace(const TimeMap::Knot& a, const TimeMap::Knot& b, double u) {
    const double length = b.shown - a.shown;
    const double mean = (b.source - a.source) / length;
    return 6 * u * (1 - u) * mean + a.pace * (1 - u) * (1 - 3 * u) + b.pace * u * (3 * u - 2);
}

/// A pace at a knot that keeps the cubics on both sides monotone (Fritsch and Carlson 1980).
double monotone(double pace, double before, double after) {
    return std::clamp(pace, 0.0, 2.5 * std::min(before, after));
}

}  // namespace

TimeMap::TimeMap(double sourceFrames) {
    knots_[0] = {0, 0, 1};
    knots_[1] = {sourceFrames, sourceFrames, 1};
}

TimeMap TimeMap::from(double shown, double moment, double toMoment, double toEnd) const {
    TimeMap map;
    const Knot start{shown, sourceAt(shown), paceAt(shown)};
    const double end = sourceFrames();
    map.last_ = 0;
    // What was shown keeps its time, so that the path shown can still be summed up.
    if (shown > 0) map.knots_[map.last_++] = {0, 0, start.source / shown};
    map.knots_[map.last_] = start;
    const bool inside = moment > start.source + 1e-9 && moment < end - 1e-9;
    if (inside) {
        const double before = (moment - start.source) / toMoment;
        const double after = (end - moment) / (toEnd - toMoment);
        // Time-weighted, so that the longer side changes its pace less.
        const double pace =
            monotone((before * (toEnd - toMoment) + after * toMoment) / toEnd, before, after);
        map.knots_[map.last_].pace = monotone(start.pace, before, before);
        map.knots_[++map.last_] = {shown + toMoment, moment, pace};
        map.knots_[++map.last_] = {shown + toEnd, end, monotone(1, after, after)};
    } else {
        const double mean = (end - start.source) / toEnd;
        map.knots_[map.last_].pace = monotone(start.pace, mean, mean);
        map.knots_[++map.last_] = {shown + toEnd, end, monotone(1, mean, mean)};
    }
    return map;
}

std::size_t TimeMap::segmentAt(double shown) const {
    std::size_t i = 0;
    while (i + 1 < last_ && shown >= knots_[i + 1].shown)
        ++i;
    return i;
}

double TimeMap::sourceAt(double shown) const {
    const std::size_t i = segmentAt(shown);
    const Knot& a = knots_[i];
    const Knot& b = knots_[i + 1];
    if (b.shown <= a.shown) return b.source;
    return hermite(a, b, std::clamp((shown - a.shown) / (b.shown - a.shown), 0.0, 1.0));
}

double TimeMap::paceAt(double shown) const {
    const std::size_t i = segmentAt(shown);
    const Knot& a = knots_[i];
    const Knot& b = knots_[i + 1];
    if (b.shown <= a.shown) return 1;
    return hermitePace(a, b, std::clamp((shown - a.shown) / (b.shown - a.shown), 0.0, 1.0));
}

double TimeMap::shownAt(double source) const {
    double low = knots_[0].shown;
    double high = shownFrames();
    if (source <= knots_[0].source) return low;
    if (source >= sourceFrames()) return high;
    // Monotone: halving finds it to a billionth of a frame.
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (sourceAt(middle) < source ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Meeting meet(double own, double other, double lag, bool otherMayWarp) {
    Meeting result;
    const double a = std::max(0.0, own);
    const double b = otherMayWarp ? std::max(0.0, other) : 0.0;
    // own · warp − other · warp' = lag, with the least change; a limit reached leaves the rest to
    // the other one.
    const double wanted = lag - (own - other);
    const double squares = a * a + b * b;
    if (squares > 1e-9) {
        const auto limited = [](double warp) { return std::clamp(warp, kLeastWarp, kMostWarp); };
        result.own = limited(1 + wanted * a / squares);
        if (b > 0) {
            result.other = limited(1 - (wanted - (result.own - 1) * a) / b);
            if (a > 0) result.own = limited(1 + (wanted + (result.other - 1) * b) / a);
        }
    }
    result.error = (result.own - 1) * a - (result.other - 1) * b - wanted;
    return result;
}

}  // namespace kumite
