#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace kumite::studio {

/// The lowest and highest value of a stretch of a curve.
struct CurveExtent {
    float low = 0;
    float high = 0;
};

/// A curve with its minima and maxima over blocks of 16, 256, 4096 … samples, so that the extent of
/// any stretch is found in logarithmic time: no peak is lost at any zoom, and drawing does not
/// depend on the curve's length. Blocks as wide as a line of the memory: what an hour's curve costs
/// to draw is how many lines are fetched.
class CurvePyramid {
public:
    CurvePyramid() = default;
    explicit CurvePyramid(std::span<const double> samples);
    explicit CurvePyramid(std::span<const float> samples);

    std::size_t size() const { return samples_.size(); }
    float at(std::size_t sample) const { return samples_[sample]; }
    /// Over the samples [begin, end), which must not be empty.
    CurveExtent extent(std::size_t begin, std::size_t end) const;
    /// Over all samples; {0, 0} without any.
    CurveExtent extent() const;

private:
    void addLevels();

    std::vector<float> samples_;
    /// Each over sixteen blocks of the one before, the last one maybe fewer; the last level has
    /// one.
    std::vector<std::vector<CurveExtent>> levels_;
};

}  // namespace kumite::studio
