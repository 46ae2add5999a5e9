#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/labelling/query.h"
#include "core/project/labelling.h"

namespace kumite::studio {

/// All actions of a project as the machine sees them, with the queue of questions about them.
/// Made anew where boundaries or bodies change; shared by all rounds of learning until then. The
/// queue belongs to the round that runs.
struct LearningGround {
    ActionTable table;
    std::vector<int> peaks;  ///< of every row
    /// Whose actions these are, by take and player.
    std::vector<std::vector<std::shared_ptr<const FighterMotion>>> motions;
    QueryQueue queue;

    LearningGround(ActionTable actions, const Analysis& analysis, const QuerySettings& settings);

    /// Whether the fighter at this address is still the one that the ground knows there.
    bool knows(const Analysis& analysis, FighterAddress fighter) const;
    /// The row of the action whose peak that is; nothing: the ground does not know it.
    std::optional<int> rowOf(FighterAddress fighter, int peak) const;
};

/// What a round of learning found out.
struct LearntLabels {
    std::shared_ptr<const LearningGround> ground;
    SharedValue<Vocabulary> vocabulary;
    std::vector<Example> examples;  ///< what it learnt from
    ParameterSet parameters;
    Predictions predictions;  ///< by row of the ground's table
    Proposals proposals;
    /// All confidences are of this round. Else the machine gave margins only, and a confidence is
    /// that of an earlier round which said the same, or 0: not known yet.
    bool calibrated = false;
    std::optional<double> expectedAccuracy;  ///< by cross-validation; with `calibrated`
    std::vector<int> batch;                  ///< rows to ask about next
};

/// What a round starts from.
struct LearningInput {
    Project project;
    Analysis analysis;
    std::shared_ptr<LearningGround> ground;
    std::vector<Example> examples;
    ParameterSet parameters;
};

/// The quick round: margins, and confidences of `before` where the machine still says the same.
LearntLabels learnMargins(const LearningInput& input, const LearntLabels* before,
                          const Progress& progress);
/// The thorough one: with `search` the parameters, then probabilities and cross-validation.
LearntLabels learnThoroughly(const LearningInput& input, bool search, const Progress& progress);

/// Confidences of `sure` for `labels` where both say the same of the same ground.
void takeOverConfidences(Predictions& labels, const Predictions& sure);

}  // namespace kumite::studio
