#pragma once

#include <span>
#include <vector>

namespace kumite {

/// How two ways to cut one stream differ. Frames, in order.
struct BoundaryComparison {
    int both = 0;            ///< boundaries that stand for each other
    std::vector<int> onlyA;  ///< without a partner in B
    std::vector<int> onlyB;  ///< without a partner in A
};

/// Pairs the boundaries of A and B (frames in order of time, each at most once) that lie within
/// `reach` frames of each other, nearest pairs first; of pairs as near, the earlier.
BoundaryComparison compareBoundaries(std::span<const int> a, std::span<const int> b, double reach);

}  // namespace kumite
