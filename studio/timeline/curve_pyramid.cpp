#include "studio/timeline/curve_pyramid.h"

#include <algorithm>
#include <cassert>

namespace kumite::studio {

namespace {

constexpr std::size_t kBlock = 16;

void join(CurveExtent& extent, float sample) {
    extent.low = std::min(extent.low, sample);
    extent.high = std::max(extent.high, sample);
}

void join(CurveExtent& extent, const CurveExtent& other) {
    extent.low = std::min(extent.low, other.low);
    extent.high = std::max(extent.high, other.high);
}

CurveExtent extentOf(float sample) {
    return {sample, sample};
}

CurveExtent extentOf(const CurveExtent& extent) {
    return extent;
}

/// The extents of every sixteen of them.
template <typename Element>
std::vector<CurveExtent> blocksOf(const std::vector<Element>& elements) {
    std::vector<CurveExtent> blocks;
    blocks.reserve((elements.size() + kBlock - 1) / kBlock);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (i % kBlock == 0)
            blocks.push_back(extentOf(elements[i]));
        else
            join(blocks.back(), elements[i]);
    }
    return blocks;
}

/// Joins what of [begin, end) fills no whole block, and narrows the range to the blocks.
template <typename Element>
void joinEnds(CurveExtent& extent, const std::vector<Element>& elements, std::size_t& begin,
              std::size_t& end) {
    const std::size_t first = (begin + kBlock - 1) / kBlock;
    const std::size_t last = end / kBlock;
    const bool blocks = first < last;
    for (std::size_t i = begin; i < (blocks ? first * kBlock : end); ++i)
        join(extent, elements[i]);
    for (std::size_t i = blocks ? last * kBlock : end; i < end; ++i)
        join(extent, elements[i]);
    begin = blocks ? first : 0;
    end = blocks ? last : 0;
}

}  // namespace

CurvePyramid::CurvePyramid(std::span<const double> samples) {
    samples_.reserve(samples.size());
    for (const double sample : samples)
        samples_.push_back(static_cast<float>(sample));
    addLevels();
}

CurvePyramid::CurvePyramid(std::span<const float> samples)
    : samples_(samples.begin(), samples.end()) {
    addLevels();
}

void CurvePyramid::addLevels() {
    if (samples_.empty()) return;
    levels_.push_back(blocksOf(samples_));
    while (levels_.back().size() > 1)
        levels_.push_back(blocksOf(levels_.back()));
}

CurveExtent CurvePyramid::extent(std::size_t begin, std::size_t end) const {
    assert(begin < end && end <= size());
    CurveExtent result = extentOf(samples_[begin]);
    joinEnds(result, samples_, begin, end);
    for (std::size_t level = 0; begin < end; ++level)
        joinEnds(result, levels_[level], begin, end);
    return result;
}

CurveExtent CurvePyramid::extent() const {
    return levels_.empty() ? CurveExtent{} : levels_.back().front();
}

}  // namespace kumite::studio
