#pragma once

#include <span>
#include <string>
#include <vector>

namespace kumite {

/// The labels of one fighter's actions in order, as text. Sequences that do not follow one another
/// (takes, fighters) stay apart: no n-gram goes across.
using LabelSequence = std::vector<std::string>;

/// n-grams of labels: n neighbours in a sequence.
struct NgramCount {
    int distinct = 0;
    int total = 0;
    /// Share of distinct ones; 0 of none. Falls with length: compare what is as long.
    double share() const { return total > 0 ? static_cast<double>(distinct) / total : 0.0; }
};
NgramCount countNgrams(std::span<const LabelSequence> sequences, int n);

/// How far apart the relative frequencies of n-grams are: total variation distance, half the sum
/// of absolute differences, in [0, 1]. 1 if one side has none and the other has some.
double ngramDistance(std::span<const LabelSequence> a, std::span<const LabelSequence> b, int n);

}  // namespace kumite
