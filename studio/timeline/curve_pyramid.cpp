#include "studio/timeline/curve_pyramid.h"

#include <algorithm>
#include <cassert>

namespace kumite::studio {

namespace {

CurveExtent joined(const CurveExtent& a, const CurveExtent& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

template <typename Number>
std::vector<CurveExtent> extentsOf(std::span<const Number> samples) {
    std::vector<CurveExtent> extents;
    extents.reserve(samples.size());
    for (const Number sample : samples) {
        const auto value = static_cast<float>(sample);
        extents.push_back({value, value});
    }
    return extents;
}

}  // namespace

CurvePyramid::CurvePyramid(std::span<const double> samples) {
    if (samples.empty()) return;
    levels_.push_back(extentsOf(samples));
    addLevels();
}

CurvePyramid::CurvePyramid(std::span<const float> samples) {
    if (samples.empty()) return;
    levels_.push_back(extentsOf(samples));
    addLevels();
}

void CurvePyramid::addLevels() {
    while (levels_.back().size() > 1) {
        const std::vector<CurveExtent>& below = levels_.back();
        std::vector<CurveExtent> level;
        level.reserve((below.size() + 1) / 2);
        for (std::size_t i = 0; i + 1 < below.size(); i += 2)
            level.push_back(joined(below[i], below[i + 1]));
        if (below.size() % 2 == 1) level.push_back(below.back());
        levels_.push_back(std::move(level));
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
