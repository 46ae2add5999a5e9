#pragma once

#include <span>
#include <vector>

namespace kumite {

/// A local minimum of the contact force: a candidate boundary between two actions.
struct ForceMinimum {
    int frame = 0;
    double force = 0;       ///< body weights
    double prominence = 0;  ///< body weights; method A2

    bool operator==(const ForceMinimum&) const = default;
};

/// All local minima in order of time (scipy's `find_peaks` on the negated curve): a plateau counts
/// once, at its middle rounded down; the end frames are never minima. Prominence on each side goes
/// up to the nearest lower value or the curve's end; the smaller side counts; equal minima both
/// keep their full prominence. O(n).
std::vector<ForceMinimum> findMinima(std::span<const double> curve);

}  // namespace kumite
