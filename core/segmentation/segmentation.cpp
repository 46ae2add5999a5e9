#include "core/segmentation/segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kumite {
namespace {

/// What the corrections say about one minimum.
struct MinimumState {
    bool kept = false;                   ///< prominent enough to be a boundary by itself
    std::optional<std::size_t> remover;  ///< the correction that removed it
    std::optional<std::size_t> mover;    ///< the correction that moved it
    std::optional<std::size_t> keeper;   ///< the correction that accepted it
    std::optional<std::size_t> adder;    ///< the added boundary that stands for it
};

/// A boundary and the correction that put it where it is, if one did.
struct Candidate {
    Boundary boundary;
    std::optional<std::size_t> correction;
};

/// Finds out what each correction means.
class Matcher {
public:
    Matcher(std::span<const ForceMinimum> minima, double threshold,
            std::span<const Correction> corrections, double reach, int frameCount)
        : states(minima.size()),
          meant(corrections.size()),
          matched(corrections.size(), true),
          minima_(minima),
          reach_(reach) {
        for (std::size_t i = 0; i < minima.size(); ++i) {
            states[i].kept = minima[i].prominence >= threshold;
        }
        const auto isInside = [&](int frame) { return frame > 0 && frame < frameCount - 1; };
        for (std::size_t i = 0; i < corrections.size(); ++i) {
            const Correction& correction = corrections[i];
            if (correction.kind == Correction::Kind::Remove) {
                claim(correction.frame, i, &MinimumState::remover);
            } else if (correction.kind == Correction::Kind::Keep) {
                claim(correction.frame, i, &MinimumState::keeper);
            } else if (correction.kind == Correction::Kind::Move && isInside(correction.to)) {
                claim(correction.frame, i, &MinimumState::mover);
            } else if (correction.kind == Correction::Kind::Move || !isInside(correction.frame)) {
                matched[i] = false;
            }
        }
        // Additions last: they stand for what no hand has touched.
        for (std::size_t i = 0; i < corrections.size(); ++i) {
            const Correction& correction = corrections[i];
            if (correction.kind != Correction::Kind::Add) continue;
            const double reach = correction.beside ? 0.0 : reach_;
            meant[i] = nearest(correction.frame, reach, [](const MinimumState& state) {
                return state.kept && !state.remover && !state.mover && !state.adder;
            });
            if (meant[i]) states[static_cast<std::size_t>(*meant[i])].adder = i;
        }
    }

    std::vector<MinimumState> states;       ///< one per minimum
    std::vector<std::optional<int>> meant;  ///< one per correction
    std::vector<bool> matched;              ///< one per correction: has it an effect?

private:
    void claim(int frame, std::size_t correction,
               std::optional<std::size_t> MinimumState::*claimant) {
        const auto minimum = nearest(frame, reach_, [&](const MinimumState& state) {
            return !(state.*claimant).has_value();
        });
        meant[correction] = minimum;
        matched[correction] = minimum.has_value();
        if (minimum) states[static_cast<std::size_t>(*minimum)].*claimant = correction;
    }

    /// The nearest minimum within reach of a frame among those that `accept` lets through; one
    /// that cuts counts as half as far; of two as near, the earlier.
    template <typename Accept>
    std::optional<int> nearest(int frame, double reach, const Accept& accept) const {
        const auto isBefore = [](const ForceMinimum& m, double f) { return m.frame < f; };
        auto it = std::lower_bound(minima_.begin(), minima_.end(), frame - reach, isBefore);
        std::optional<int> best;
        double bestDistance = 0;
        for (; it != minima_.end() && it->frame <= frame + reach; ++it) {
            const auto index = static_cast<std::size_t>(it - minima_.begin());
            const double distance = std::abs(it->frame - frame) * (states[index].kept ? 0.5 : 1.0);
            if (!accept(states[index]) || (best && distance >= bestDistance)) continue;
            best = static_cast<int>(index);
            bestDistance = distance;
        }
        return best;
    }

    std::span<const ForceMinimum> minima_;
    double reach_;
};

/// All boundaries that detection and hands ask for; several may ask for one frame.
std::vector<Candidate> candidates(const Matcher& matcher, std::span<const ForceMinimum> minima,
                                  std::span<const Correction> corrections, int frameCount,
                                  Segmentation& result) {
    std::vector<Candidate> all = {{{0, BoundarySource::End, {}}, {}}};
    if (frameCount > 1) all.push_back({{frameCount - 1, BoundarySource::End, {}}, {}});
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        if (corrections[i].kind != Correction::Kind::Add || !matcher.matched[i]) continue;
        if (corrections[i].removed) {
            result.removed.push_back({corrections[i].frame, {}});
        } else {
            all.push_back({{corrections[i].frame, BoundarySource::Added, matcher.meant[i]}, i});
        }
    }
    for (std::size_t i = 0; i < minima.size(); ++i) {
        const MinimumState& state = matcher.states[i];
        const int index = static_cast<int>(i);
        if (state.adder || (!state.kept && !state.mover && !state.keeper)) continue;
        const int frame = state.mover ? corrections[*state.mover].to : minima[i].frame;
        if (state.remover) {
            result.removed.push_back({frame, index});
        } else {
            const auto source = state.mover    ? BoundarySource::Moved
                                : state.keeper ? BoundarySource::Accepted
                                               : BoundarySource::Detected;
            all.push_back({{frame, source, index}, state.mover ? state.mover : state.keeper});
        }
    }
    return all;
}

/// In order, one per frame: ends stand first, then what a hand put there.
void keepOnePerFrame(std::vector<Candidate> all, std::vector<bool>& matched, Segmentation& result) {
    const auto rank = [](const Candidate& candidate) {
        if (candidate.boundary.source == BoundarySource::End) return 0;
        return candidate.correction ? 1 : 2;
    };
    std::stable_sort(all.begin(), all.end(), [&](const Candidate& a, const Candidate& b) {
        return std::pair(a.boundary.frame, rank(a)) < std::pair(b.boundary.frame, rank(b));
    });
    for (const Candidate& candidate : all) {
        const bool taken = !result.boundaries.empty() &&
                           result.boundaries.back().frame == candidate.boundary.frame;
        if (!taken) {
            result.boundaries.push_back(candidate.boundary);
        } else if (candidate.correction) {
            matched[*candidate.correction] = false;
        }
    }
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
            return "add " + frame + (correction.removed ? " (removed)" : "");
        case Correction::Kind::Move:
            return "move " + frame + " to " + std::to_string(correction.to);
        case Correction::Kind::Keep:
            return "keep " + frame;
    }
    return {};
}

std::optional<int> boundaryOf(const Correction& correction) {
    if (correction.kind == Correction::Kind::Remove || correction.removed) return std::nullopt;
    return correction.kind == Correction::Kind::Move ? correction.to : correction.frame;
}

const Action* actionAt(const Segmentation& segmentation, int frame) {
    const auto& actions = segmentation.actions;
    if (actions.empty() || frame < actions.front().begin || frame > actions.back().end) {
        return nullptr;
    }
    const auto after =
        std::upper_bound(actions.begin(), actions.end(), frame,
                         [](int f, const Action& action) { return f < action.begin; });
    return &*std::prev(after);
}

Segmentation segment(std::span<const double> curve, std::span<const ForceMinimum> minima,
                     double threshold, std::span<const Correction> corrections, double reach) {
    Segmentation result;
    const int frameCount = static_cast<int>(curve.size());
    if (frameCount == 0) {
        result.unmatched.assign(corrections.begin(), corrections.end());
        result.meant.resize(corrections.size());
        return result;
    }
    Matcher matcher(minima, threshold, corrections, reach, frameCount);
    std::vector<bool> matched = matcher.matched;
    keepOnePerFrame(candidates(matcher, minima, corrections, frameCount, result), matched, result);
    for (std::size_t i = 0; i < corrections.size(); ++i) {
        if (!matched[i]) result.unmatched.push_back(corrections[i]);
    }
    result.meant = std::move(matcher.meant);
    if (frameCount == 1) result.actions.push_back({0, 0, 0});
    for (std::size_t i = 0; i + 1 < result.boundaries.size(); ++i) {
        result.actions.push_back(
            actionBetween(curve, result.boundaries[i].frame, result.boundaries[i + 1].frame));
    }
    return result;
}

}  // namespace kumite
