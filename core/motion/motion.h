#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/frame_range.h"
#include "core/motion/skeleton.h"

namespace kumite {

/// A skeleton and its channel values over time, kept exactly as the file stores them, so that
/// what was not edited is written back bit for bit. Positions in file units, angles in degrees.
struct Motion {
    std::shared_ptr<const Skeleton> skeleton;
    double frameTime = 1.0 / 30.0;  ///< seconds, as the file's header says (which may lie)
    int frameCount = 0;
    std::vector<double> channels;  ///< frameCount × skeleton->channelCount, row by row

    std::span<const double> frame(int index) const {
        const auto width = static_cast<std::size_t>(skeleton->channelCount);
        return {channels.data() + width * static_cast<std::size_t>(index), width};
    }
    FrameRange frames() const { return {0, frameCount}; }

    /// Throws Error if sizes disagree, the skeleton is invalid, the frame time is not a positive
    /// number or a channel value is not finite.
    void validate() const;
};

/// The frame rate that a header's frame time means: 1/frameTime, brought to a whole number or to
/// an NTSC rate (30/1.001 …) where it lies within 0.05 % of one, because headers round
/// (`.0083333` is 120 Hz). Hz.
double rateOf(double frameTime);

}  // namespace kumite
