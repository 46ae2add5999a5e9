#pragma once

#include <algorithm>

namespace kumite {

/// A half-open range of frames [begin, end). The only meaning of "range" in the project: `A:B` on
/// the command line, `frames` in the project file and loops over frames all read it this way.
struct FrameRange {
    int begin = 0;
    int end = 0;

    int size() const { return std::max(0, end - begin); }
    bool empty() const { return end <= begin; }
    bool contains(int frame) const { return frame >= begin && frame < end; }

    bool operator==(const FrameRange&) const = default;
};

}  // namespace kumite
