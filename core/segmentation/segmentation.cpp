#include "core/segmentation/segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kumite {
namespace {

/// What the corrections say about one minimum.
struct MinimumState {
    bool kept = false;  ///< prominent enough to be a boundary by itself
    bool removed = false;
    bool absorbed = false;  ///< an added boundary stands for it
    std::optional<int> movedTo;
};

/// A boundary that a hand added.
struct Added {
    int frame = 0;
    bool removed = false;
    std::optional<int> minimum;
};

/// The nearest minimum within reach of a frame among those that `accept` lets through; of two as
/// near, the earlier.
template <typename Accept>
std::optional<int> nearest(std::span<const ForceMinimum> minima, int frame, double reach,
                           const Accept& accept) {
    const auto isBefore = [](const ForceMinimum& minimum, double f) { return minimum.frame < f; };
    auto it = std::lower_bound(minima.begin(), minima.end(), frame - reach, isBefore);
    std::optional<int> best;
    int bestDistance = 0;
    for (; it != minima.end() && it->frame <= frame + reach; ++it) {
        const int index = static_cast<int>(it - minima.begin());
        const int distance = std::abs(it->frame - frame);
        if (!accept(index) || (best && distance >= bestDistance)) continue;
        best = index;
        bestDistance = distance;
    }
    return best;
}

/// Applies the corrections to the minima, one after the other.
class Corrector {
public:
    Corrector(std::span<const ForceMinimum> minima, double threshold, double reach, int frameCount)
        : states(minima.size()),
          minima_(minima),
          threshold_(threshold),
          reach_(reach),
          lastFrame_(frameCount - 1) {
        for (std::size_t i = 0; i < minima.size(); ++i) {
            states[i].kept = minima[i].prominence >= threshold;
        }
    }

    void apply(std::span<const Correction> corrections) {
        // Additions first: a removal may mean one of them, whatever the order of the list.
        for (const Correction& correction : corrections) {
            if (correction.kind == Correction::Kind::Add) add(correction);
        }
        for (const Correction& correction : corrections) {
            if (correction.kind == Correction::Kind::Remove) remove(correction);
            if (correction.kind == Correction::Kind::Move) move(correction);
        }
    }

    std::vector<MinimumState> states;  ///< one per minimum
    std::vector<Added> added;
    std::vector<Correction> unmatched;

private:
    MinimumState& state(int index) { return states[static_cast<std::size_t>(index)]; }
    bool isInside(int frame) const { return frame > 0 && frame < lastFrame_; }

    std::optional<int> meant(int frame) const {
        return meantMinimum(minima_, threshold_, frame, reach_);
    }

    void add(const Correction& correction) {
        if (!isInside(correction.frame)) {
            unmatched.push_back(correction);
            return;
        }
        std::optional<int> minimum;
        if (!correction.beside) {
            minimum = nearest(minima_, correction.frame, reach_,
                              [&](int i) { return state(i).kept && !state(i).absorbed; });
        }
        if (minimum) state(*minimum).absorbed = true;
        added.push_back({correction.frame, false, minimum});
    }

    void remove(const Correction& correction) {
        for (Added& boundary : added) {
            if (boundary.frame != correction.frame) continue;
            boundary.removed = true;
            return;
        }
        const auto minimum = meant(correction.frame);
        if (minimum) {
            state(*minimum).removed = true;
        } else {
            unmatched.push_back(correction);
        }
    }

    void move(const Correction& correction) {
        const auto minimum = meant(correction.frame);
        if (minimum && isInside(correction.to)) {
            state(*minimum).movedTo = correction.to;
        } else {
            unmatched.push_back(correction);
        }
    }

    std::span<const ForceMinimum> minima_;
    double threshold_;
    double reach_;
    int lastFrame_;
};

std::vector<Boundary> boundariesOf(const Corrector& corrector, std::span<const ForceMinimum> minima,
                                   int frameCount, Segmentation& result) {
    std::vector<Boundary> boundaries = {{0, BoundarySource::End, {}}};
    if (frameCount > 1) boundaries.push_back({frameCount - 1, BoundarySource::End, {}});
    for (const Added& added : corrector.added) {
        if (added.removed) {
            result.removedAdded.push_back(added.frame);
        } else {
            boundaries.push_back({added.frame, BoundarySource::Added, added.minimum});
        }
    }
    for (std::size_t i = 0; i < corrector.states.size(); ++i) {
        const MinimumState& state = corrector.states[i];
        const int index = static_cast<int>(i);
        if (state.absorbed || (!state.kept && !state.movedTo)) continue;
        if (state.removed) {
            result.removedMinima.push_back(index);
        } else if (state.movedTo) {
            boundaries.push_back({*state.movedTo, BoundarySource::Moved, index});
        } else {
            boundaries.push_back({minima[i].frame, BoundarySource::Detected, index});
        }
    }
    // Where two fall on one frame the hand's boundary stands; ends always stand.
    const auto rank = [](BoundarySource source) {
        return source == BoundarySource::End ? 0 : source == BoundarySource::Detected ? 2 : 1;
    };
    std::sort(boundaries.begin(), boundaries.end(), [&](const Boundary& a, const Boundary& b) {
        return std::pair(a.frame, rank(a.source)) < std::pair(b.frame, rank(b.source));
    });
    const auto last =
        std::unique(boundaries.begin(), boundaries.end(),
                    [](const Boundary& a, const Boundary& b) { return a.frame == b.frame; });
    boundaries.erase(last, boundaries.end());
    return boundaries;
}

Action actionBetween(std::span<const double> curve, int begin, int end) {
    if (end - begin < 2) return {begin, end, begin};
    const auto first = curve.begin() + begin + 1;
    return {begin, end,
            static_cast<int>(std::max_element(first, curve.begin() + end) - curve.begin())};
}

}  // namespace

std::string correctionText(const Correction& correction) {
    const std::string frame = std::to_string(correction.frame);
    switch (correction.kind) {
        case Correction::Kind::Remove:
            return "remove " + frame;
        case Correction::Kind::Add:
            return "add " + frame;
        case Correction::Kind::Move:
            return "move " + frame + " to " + std::to_string(correction.to);
    }
    return {};
}

std::optional<int> meantMinimum(std::span<const ForceMinimum> minima, double threshold, int frame,
                                double reach) {
    const auto cuts = nearest(minima, frame, reach, [&](int i) {
        return minima[static_cast<std::size_t>(i)].prominence >= threshold;
    });
    return cuts ? cuts : nearest(minima, frame, reach, [](int) { return true; });
}

Segmentation segment(std::span<const double> curve, std::span<const ForceMinimum> minima,
                     double threshold, std::span<const Correction> corrections, double reach) {
    Segmentation result;
    const int frameCount = static_cast<int>(curve.size());
    if (frameCount == 0) {
        result.unmatched.assign(corrections.begin(), corrections.end());
        return result;
    }
    Corrector corrector(minima, threshold, reach, frameCount);
    corrector.apply(corrections);
    result.boundaries = boundariesOf(corrector, minima, frameCount, result);
    result.unmatched = std::move(corrector.unmatched);
    if (frameCount == 1) result.actions.push_back({0, 0, 0});
    for (std::size_t i = 0; i + 1 < result.boundaries.size(); ++i) {
        result.actions.push_back(
            actionBetween(curve, result.boundaries[i].frame, result.boundaries[i + 1].frame));
    }
    return result;
}

}  // namespace kumite
