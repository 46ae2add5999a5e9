#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/labelling/distances.h"
#include "core/labelling/learner.h"

namespace kumite {

/// Which actions a user should label next (method A4).
struct QuerySettings {
    /// Small batches win: five reach the accuracy of ten with a third fewer labels.
    int batch = 5;
    /// Share of a batch that looks for kinds of action that nobody has shown yet: the actions that
    /// are farthest from all labelled ones.
    double explore = 0.2;
    bool mirrored = true;  ///< an action is as near as its mirror image
    /// Until so many actions are labelled, those are asked that stand for most: margins of a
    /// machine that has seen a handful lead astray.
    int start = 20;
};

/// Orders questions over the rows of one feature matrix. Deterministic.
class QueryQueue {
public:
    QueryQueue(const FeatureMatrix& features, const QuerySettings& settings);

    /// The next batch: rows with the smallest margin over the aspects that have learnt something,
    /// spread over feature space so that one batch does not ask the same question twice. Without
    /// predictions (nothing labelled yet) rows that stand for most of all. `answered`: one per row.
    std::vector<int> next(const std::vector<bool>& answered,
                          const Predictions* predictions = nullptr);

private:
    int mostRepresentative(const std::vector<int>& among, const Eigen::RowVectorXf& covered) const;

    ActionDistances actions_;
    /// Distance of every row to every reference: every so many rows, at most a thousand.
    FeatureMatrix toReferences_;
    /// How near every row is to what is answered; kept from call to call.
    std::vector<double> nearest_;
    std::vector<bool> counted_;  ///< rows that `nearest_` knows to be answered
    QuerySettings settings_;
};

/// The baseline: `count` rows drawn from those not answered yet.
std::vector<int> randomQueries(const std::vector<bool>& answered, int count, std::uint32_t seed);

/// Whether labelling more by hand will hardly help: the expected accuracy of the last five rounds
/// has reached `target` in the mean, from the tenth round on; or the last ten rounds brought less
/// than one percent over the ten before. `expected`: one per round.
bool mayStop(std::span<const double> expected, double target = 0.95);

}  // namespace kumite
