#pragma once

#include <array>
#include <vector>

#include "core/interaction/action_parameters.h"

namespace kumite {

/// Both fighters of a take as tracks; null where there is none.
using TakeTracks = std::array<const FighterTrack*, 2>;

/// What the geometry of a bout is made of, beside its graph: every action's summary (by action of
/// B; those of fighters without a track stay empty) and every transition's frame of reference.
struct BoutNumbers {
    std::array<std::vector<ActionSummary>, 2> summaries;
    std::array<std::vector<TransitionGround>, 2> grounds;

    bool operator==(const BoutNumbers&) const = default;
};
/// `tracks` by take. Every transition's fighters need one.
BoutNumbers boutNumbers(const CoupledGraph& graph, const std::vector<TakeTracks>& tracks);

/// What a transition's numbers are: (n¹ᵢ, n²ⱼ, n¹ᵢ₊₁), or for an avatar (n¹ᵢ, n²ⱼ, c, n¹ᵢ₊₁) with
/// its target c, where it stands half a second later (method A8, A9).
enum class TransitionNumbers { Plain, WithTarget };

/// The numbers of every transition of a mover, row by row: 6·(3 + k) columns, two more with
/// targets. A transition so near its take's end that its target is not known has a row of NaN.
Eigen::MatrixXd transitionMatrix(const CoupledGraph& graph, const BoutNumbers& numbers, int mover,
                                 const PoseSpace& space, int k,
                                 TransitionNumbers kind = TransitionNumbers::Plain);

}  // namespace kumite
