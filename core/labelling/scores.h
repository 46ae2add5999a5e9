#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/labelling/label.h"

namespace kumite {

/// How well an aspect was found.
struct AspectScore {
    double accuracy = 0;
    /// Mean over the qualifiers that occur in the truth or among the answers of their F1.
    double macroF1 = 0;
    /// confusion[truth][answer]: number of actions; a last column for unknown answers.
    std::vector<std::vector<int>> confusion;
};

/// Answers held against the truth (architecture, `label --simulate`).
struct Scores {
    int actions = 0;
    /// Over the true strikes (an aspect with a limb is not at its fallback): the same limbs found.
    double limbAccuracy = 0;
    double labelAccuracy = 0;     ///< every aspect right
    double baselineAccuracy = 0;  ///< the best constant answer with every fallback
    std::vector<AspectScore> aspects;
};

/// Both spans are the same actions. An aspect that is unknown in the truth is not judged.
Scores judge(const Vocabulary& vocabulary, std::span<const Label> truth,
             std::span<const Label> answers);

/// How often two people said which qualifier: counts[first][second].
using JudgementTable = std::vector<std::vector<int>>;

/// Cohen's κ of what two people said. Of several aspects (one table each) observed and expected
/// agreement are summed, each weighted by its judgements (pooled kappa, De Vries et al., Field
/// Methods 20(3), 2008). Nothing where there is no judgement; 1 where both always say the same
/// single thing.
std::optional<double> cohensKappa(std::span<const JudgementTable> tables);

}  // namespace kumite
