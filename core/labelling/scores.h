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

/// Cohen's κ of one aspect between two people, over the actions that both labelled; nothing where
/// that is none. 1 where both always say the same single thing.
std::optional<double> cohensKappa(std::span<const int> first, std::span<const int> second);

}  // namespace kumite
