#include "core/segmentation/force_minima.h"

#include <algorithm>

namespace kumite {
namespace {

/// Per frame of `curve`, the highest value on the way to the left up to (not including) the
/// nearest lower value, or to the curve's start. One pass with a stack of frames whose values
/// rise from bottom to top.
template <typename Span>
std::vector<double> highestBeforeLower(const Span& curve) {
    struct Entry {
        double value;
        double highest;  ///< between the entry below (left out) and this one
    };
    std::vector<Entry> stack;
    std::vector<double> result;
    result.reserve(curve.size());
    for (const double value : curve) {
        double highest = value;
        while (!stack.empty() && stack.back().value >= value) {
            highest = std::max(highest, stack.back().highest);
            stack.pop_back();
        }
        stack.push_back({value, highest});
        result.push_back(highest);
    }
    return result;
}

}  // namespace

std::vector<ForceMinimum> findMinima(std::span<const double> curve) {
    const int n = static_cast<int>(curve.size());
    const auto at = [&](int frame) { return curve[static_cast<std::size_t>(frame)]; };
    const std::vector<double> left = highestBeforeLower(curve);
    std::vector<double> right =
        highestBeforeLower(std::vector<double>(curve.rbegin(), curve.rend()));
    std::reverse(right.begin(), right.end());

    std::vector<ForceMinimum> minima;
    for (int i = 1; i + 1 < n; ++i) {
        if (at(i - 1) <= at(i)) continue;
        int last = i;  // of the plateau that begins at i
        while (last + 1 < n && at(last + 1) == at(i))
            ++last;
        if (last + 1 < n && at(last + 1) > at(i)) {
            const int middle = (i + last) / 2;
            const auto m = static_cast<std::size_t>(middle);
            minima.push_back({middle, at(middle), std::min(left[m], right[m]) - at(middle)});
        }
        i = last;
    }
    return minima;
}

}  // namespace kumite
