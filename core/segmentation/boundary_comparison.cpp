#include "core/segmentation/boundary_comparison.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace kumite {
namespace {

struct Pair {
    int distance = 0;
    std::size_t a = 0;
    std::size_t b = 0;
};

std::vector<int> unpaired(std::span<const int> frames, const std::vector<bool>& paired) {
    std::vector<int> rest;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (!paired[i]) rest.push_back(frames[i]);
    }
    return rest;
}

}  // namespace

BoundaryComparison compareBoundaries(std::span<const int> a, std::span<const int> b, double reach) {
    std::vector<Pair> near;
    std::size_t first = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        while (first < b.size() && b[first] < a[i] - reach)
            ++first;
        for (std::size_t j = first; j < b.size() && b[j] <= a[i] + reach; ++j) {
            near.push_back({std::abs(a[i] - b[j]), i, j});
        }
    }
    std::sort(near.begin(), near.end(), [](const Pair& x, const Pair& y) {
        return std::tie(x.distance, x.a, x.b) < std::tie(y.distance, y.a, y.b);
    });
    std::vector<bool> pairedA(a.size()), pairedB(b.size());
    BoundaryComparison result;
    for (const Pair& pair : near) {
        if (pairedA[pair.a] || pairedB[pair.b]) continue;
        pairedA[pair.a] = pairedB[pair.b] = true;
        ++result.both;
    }
    result.onlyA = unpaired(a, pairedA);
    result.onlyB = unpaired(b, pairedB);
    return result;
}

}  // namespace kumite
