#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/interaction/geometry_term.h"
#include "core/interaction/label_term.h"

namespace kumite {

/// What a mover does next, learnt from the coupled graph (method A8): a value, safe to read from
/// any thread.
struct TransitionModel {
    std::shared_ptr<const CoupledGraph> graph;
    int mover = 0;  ///< player index
    LabelTerm labels;
    TransitionCounts counts;
    GeometryTerm geometry;  ///< untrained where the mover has no transition
    /// A row (n¹ᵢ, n²ⱼ, n¹ᵢ₊₁) per transition of the mover, or (n¹ᵢ, n²ⱼ, c, n¹ᵢ₊₁) of an avatar.
    Eigen::MatrixXd numbers;
    /// Of each row's n¹ᵢ₊₁, what it adds to the turned numbers of its label's Gaussian.
    Eigen::MatrixXd nextTurned;
};
/// `numbers` as transitionMatrix gives them. A transition whose row holds a NaN teaches the label
/// term alone and is never a candidate's example.
TransitionModel learnTransitionModel(std::shared_ptr<const CoupledGraph> graph, int mover,
                                     LabelEstimator estimator, const GeometrySettings& settings,
                                     Eigen::MatrixXd numbers, const Progress& progress = {});

/// One candidate for the mover's next label.
struct NextLabel {
    int node = 0;           ///< of the mover
    double label = 0;       ///< label term: a probability
    double geometry = 0;    ///< geometry term of the best example, made to sum to 1 over the nodes
    double product = 0;     ///< both together, a probability; the label term alone without a moment
    double logDensity = 0;  ///< of the best example, of the numbers as given
    /// The transition (of the mover) whose next action fits the moment best (equation 12).
    std::optional<int> bestTransition;
    int examples = 0;          ///< transitions with the same own, opponent's and next label
    int ownExamples = 0;       ///< with the same own and next label
    int opponentExamples = 0;  ///< with the same opponent's and next label
    int nextExamples = 0;      ///< with the same next label
};

/// What-if: all of the mover's nodes as the next one, the likeliest first (ties: in the order of
/// nodes). kAnyNode leaves open what somebody does. `moment`: n¹ᵢ and n²ⱼ as they are now, for an
/// avatar's model with the target that is wished for behind them (see transitionNumbers), which
/// brings the geometry term in; a node without any example then has nothing that could follow, and
/// a product of 0.
std::vector<NextLabel> nextLabels(const TransitionModel& model, int own, int opponent,
                                  const Eigen::VectorXd* moment = nullptr);

}  // namespace kumite
