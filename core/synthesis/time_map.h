#pragma once

#include <array>

namespace kumite {

/// How far an action may be stretched or pressed (method A9): time shown over time recorded.
inline constexpr double kLeastWarp = 0.8;
inline constexpr double kMostWarp = 1.25;

/// Which moment of an action is shown when: a monotone, smooth curve from frames shown since the
/// action began to frames of its recording since it began there (both at the bout's rate). Cubic
/// Hermite between knots, so that the pace never jumps inside an action.
class TimeMap {
public:
    struct Knot {
        double shown = 0;
        double source = 0;
        double pace = 1;  ///< source frames per frame shown
    };

    TimeMap() = default;
    /// As recorded.
    explicit TimeMap(double sourceFrames);

    /// From the frame `shown` on, `moment` (source frames) is reached after `toMoment` frames more
    /// and the end after `toEnd` more; both follow the pace at `shown` without a jump and end at
    /// the recorded one. A moment at or beyond the end, or already past, is the end.
    TimeMap from(double shown, double moment, double toMoment, double toEnd) const;

    double sourceAt(double shown) const;
    double paceAt(double shown) const;
    /// When a moment of the recording is shown; clamped to the action.
    double shownAt(double source) const;
    double shownFrames() const { return knots_[last_].shown; }
    double sourceFrames() const { return knots_[last_].source; }

private:
    std::size_t segmentAt(double shown) const;

    std::array<Knot, 4> knots_{};
    std::size_t last_ = 1;
};

/// How two actions are brought to meet: each is given how long it takes to its moment as recorded,
/// and what share of that time it shall take.
struct Meeting {
    double own = 1;  ///< warp: time shown over time recorded, kLeastWarp … kMostWarp
    double other = 1;
    double error = 0;  ///< seconds by which the wanted lag is missed: own moment later than wanted
};
/// `own` and `other`: seconds until the moments as recorded (negative: it is past, then nothing
/// warps it); `lag`: seconds by which the own moment shall come after the other's. The least change
/// of both, in the mean of squares of their warps, that reaches the lag. `otherMayWarp`: false for
/// one that must stay as it is.
Meeting meet(double own, double other, double lag, bool otherMayWarp);

}  // namespace kumite
