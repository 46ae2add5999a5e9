#pragma once

#include <vector>

#include "core/interaction/transition_model.h"

namespace kumite {

/// How unexpected an observed transition is, in nats, by a model that had been learnt without it;
/// higher is stranger.
struct Surprise {
    /// −log P(l' | l1, l2), the label term: the label follows seldom.
    double label = 0;
    /// −log P(n | l'), the geometry term, minus its mean over the transitions: places and poses are
    /// unlike those of other actions with this label. An odd pose counts by its whole distance, so
    /// that this is no probability.
    double geometry = 0;
    /// −log P(l' | l1, l2, n), both terms and Bayes' rule: seen what was done then, another label
    /// was likelier. Finds labels that are wrong.
    double both = 0;
};

/// Which of them is meant.
enum class SurpriseKind { Both, Label, Geometry };
double valueOf(const Surprise& surprise, SurpriseKind kind);

/// One per transition of the model's mover. The label term is learnt anew without each transition,
/// exactly; of the geometry term, the mean and the spread of the transition's label are (see
/// GeometryTerm::logDensityWithout). As trained, the only example of a label would seem as usual
/// as can be. A transition whose numbers are not known is judged by the label term alone.
std::vector<Surprise> surprises(const TransitionModel& model);

/// −log of an even guess among the mover's labels: where the surprise of labels (and of both)
/// begins to mean that the model is worse than knowing nothing.
double uniformSurprise(const TransitionModel& model);

}  // namespace kumite
