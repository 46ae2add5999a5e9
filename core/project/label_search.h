#pragma once

#include <span>
#include <vector>

#include "core/labelling/label_filter.h"
#include "core/project/labels.h"

namespace kumite {

/// What a filter over this project can say. Refers to the project.
FilterWords filterWords(const Project& project);

/// An action that a filter lets through.
struct FoundAction {
    FighterAddress fighter;
    int action = 0;    ///< index
    double begin = 0;  ///< seconds on the take's clock
    double end = 0;
    std::vector<AspectValue> values;  ///< what the filter looked at
    LabelFilter::Match match;

    Label label() const;
};

/// All actions that pass, take by take, player by player, in order of time. What stands in the
/// project counts; beside `proposals` (of the same segmentation) only what a hand said does, and
/// they say the rest.
std::vector<FoundAction> findActions(const Project& project, const Analysis& analysis,
                                     const LabelFilter& filter,
                                     std::span<const FighterLabels> proposals = {});

}  // namespace kumite
