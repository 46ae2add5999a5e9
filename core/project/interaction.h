#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/interaction/bout_numbers.h"
#include "core/interaction/transition_model.h"
#include "core/project/labelling.h"

namespace kumite {

/// How a model is learnt. Not part of the document: a way of looking at it.
struct InteractionSettings {
    LabelEstimator estimator = LabelEstimator::Equ7;
    GeometrySettings geometry;
    int components = 3;  ///< k, principal components of local poses, 1 … 51
    /// WithTarget: two dimensions more, for movers that are led by a place to be (38 at k = 3).
    TransitionNumbers numbers = TransitionNumbers::Plain;

    bool operator==(const InteractionSettings&) const = default;
};

/// A fighter's part of the principal component analysis, and what it was made from.
struct FighterPoses {
    std::shared_ptr<const FighterMotion> motion;
    std::shared_ptr<const FighterBody> body;
    std::shared_ptr<const PoseMoments> moments;
};

/// The coupled graph of a project's labelled actions and what is learnt from it. Stages are shared
/// with the last one as long as their inputs stay equal: an unchanged pointer means unchanged
/// values. Once derived none is null; a project without labels has an empty graph.
struct Interaction {
    InteractionSettings settings;
    std::vector<FighterPoses> fighterPoses;
    std::shared_ptr<const PoseSpace> poses;
    std::shared_ptr<const CoupledGraph> graph;
    std::shared_ptr<const BoutNumbers> numbers;
    std::array<std::shared_ptr<const TransitionModel>, 2> models;  ///< by mover
    Findings findings;                                             ///< what was left out, and why
};

/// Derives the graph and both models. A pure function: the same project and settings give the same
/// values, with or without `previous`. Labels that count are those of the project (said by a hand
/// or accepted); see effectiveLabels. Takes need two fighters to show transitions. Cancellable.
Interaction deriveInteraction(const Project& project, const Analysis& analysis,
                              const InteractionSettings& settings = {},
                              const Interaction& previous = {}, const Progress& progress = {});

/// One sentence that says what to do where there is nothing to learn from; nothing otherwise.
std::optional<std::string> whyNoModel(const Project& project, const Interaction& interaction);

/// The tracks of a project's fighters, by take; they refer to the analysis.
struct BoutTracks {
    std::vector<std::unique_ptr<FighterTrack>> all;
    std::vector<TakeTracks> takes;
};
BoutTracks boutTracks(const Analysis& analysis);

/// A moment of a take as a mover would decide at it: what both are doing, by the rule of method A6
/// (at the frame where an action begins, the one that ends there).
struct Moment {
    int own = kAnyNode;  ///< nodes; kAnyNode: not labelled
    int opponent = kAnyNode;
    int ownAction = -1;  ///< of B; -1: none
    int opponentAction = -1;
    /// n¹ᵢ and n²ⱼ over whole actions, in the frame of reference of this moment, and in a model
    /// with targets where the mover really is half a second later; empty where one of them is
    /// missing.
    Eigen::VectorXd numbers;
    /// The observed transition whose next action begins at this very frame.
    std::optional<int> transition;
};
/// At a frame of the mover's take; mover 0 or 1.
Moment momentAt(const Analysis& analysis, const Interaction& interaction, int take, int frame,
                int mover);

/// What-if at a moment: nextLabels with both terms where the moment has numbers.
std::vector<NextLabel> nextLabels(const Interaction& interaction, int mover, const Moment& moment);

}  // namespace kumite
