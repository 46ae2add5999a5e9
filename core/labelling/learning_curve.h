#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/labelling/learner.h"
#include "core/labelling/query.h"

namespace kumite {

/// How well the machine knows the rest after a number of labels, in two orders.
struct OrderPoint {
    int labelled = 0;
    double asked =
        0;  ///< share found right, the labels given in the order of the queue's questions
    double random = 0;  ///< the same labels given in random order; mean of `kRandomDraws`
};

/// Asked order against random order over one set of hand labels.
struct OrderCurves {
    int examples = 0;  ///< hand labels that took part
    int heldOut = 0;   ///< answers behind each point: every example is held out once
    std::vector<OrderPoint> points;
};
inline constexpr int kRandomDraws = 3;
/// With fewer examples there is no curve; of more than the most a stratified part takes part.
inline constexpr int kFewestForCurves = 20;
inline constexpr int kMostForCurves = 200;

/// Estimates what asking is worth from the labels that exist. They are dealt into folds; a fold is
/// held out, and from the others machines learn with more and more labels, once in the order in
/// which the queue would ask for them, and in random orders. Both are judged on the same held-out
/// labels, which neither has seen, so that the two differ by the order alone. Shares are of
/// examples whose learnt aspects are all right. Labels that were themselves asked for are harder
/// than others: both curves lie lower than for the whole bout. Deterministic; cancellable.
OrderCurves orderCurves(const Vocabulary& vocabulary, const FeatureMatrix& features,
                        const std::vector<Example>& examples, const LearningSettings& settings,
                        const ParameterSet& parameters, const Progress& progress = {});

/// Asking reaches with `asked` labels what random order reaches with `random`.
struct OrderGain {
    int asked = 0;
    int random = 0;
};
/// The last point at which the random order is not better than the asked order before it; nothing
/// where asking is not ahead anywhere.
std::optional<OrderGain> orderGain(const OrderCurves& curves);

}  // namespace kumite
