#include "studio/timeline/curve_pyramid.h"

#include <algorithm>
#include <cassert>

namespace kumite::studio {

namespace {

CurveExtent joined(const CurveExtent& a, const CurveExtent& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

CurvePyramid::CurvePyramid(std::span<const double> samples) {
    std::vector<CurveExtent> level;
    level.reserve(samples.size());
    for (const double value : samples) {
        level.push_back({static_cast<float>(value), static_cast<float>(value)});
    }
    while (!level.empty()) {
        std::vector<CurveExtent> next;
        if (level.size() > 1) {
            next.reserve((level.size() + 1) / 2);
            for (std::size_t i = 0; i < level.size(); i += 2) {
                next.push_back(i + 1 < level.size() ? joined(level[i], level[i + 1]) : level[i]);
            }
        }
        levels_.push_back(std::move(level));
        level = std::move(next);
    }
}

CurveExtent CurvePyramid::extent(std::size_t begin, std::size_t end) const {
    assert(begin < end && end <= size());
    CurveExtent result = levels_.front()[begin];
    // Single blocks at both ends, then one level up, until nothing is left between.
    for (std::size_t level = 0; begin < end; ++level) {
        const auto& blocks = levels_[level];
        if (begin % 2 == 1) result = joined(result, blocks[begin++]);
        if (begin < end && end % 2 == 1) result = joined(result, blocks[--end]);
        begin /= 2;
        end /= 2;
    }
    return result;
}

CurveExtent CurvePyramid::extent() const {
    return levels_.empty() ? CurveExtent{} : levels_.back().front();
}

}  // namespace kumite::studio
