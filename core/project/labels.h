#pragma once

#include <optional>
#include <span>

#include "core/project/edits.h"

namespace kumite {

/// The label of each of a fighter's actions, in order; all unknown where nothing is said. A label
/// belongs to the action that contains its peak; of several (a merged action) the one with the
/// highest force there counts (method A2). What an action hides is kept and comes back when a
/// boundary does. The peaks of the result are those of the actions.
std::vector<ActionLabel> actionLabels(const Fighter& fighter, const FighterAnalysis& values,
                                      int aspectCount);

// Edits. `analysis` must be that of `project`; actions by index, aspects and qualifiers by index in
// the project's vocabulary. Throw Error for indices that do not exist.

/// A hand says the qualifier of one aspect for one or several actions.
MaybeEdit setLabel(const Project& project, const Analysis& analysis, FighterAddress fighter,
                   std::span<const int> actions, int aspect, int qualifier);
/// A hand says the whole label; unknown aspects stay as they are.
MaybeEdit setWholeLabel(const Project& project, const Analysis& analysis, FighterAddress fighter,
                        std::span<const int> actions, const Label& label);
/// What a hand says about one action; unknown aspects stay as they are.
struct ActionAnswer {
    FighterAddress fighter;
    int action = 0;
    Label label;
};
/// A hand says whole labels of several actions, of whichever fighters, as one step.
MaybeEdit setLabels(const Project& project, const Analysis& analysis,
                    std::span<const ActionAnswer> answers);
/// Takes back what was said, by whomever: of one aspect, or of all.
MaybeEdit clearLabel(const Project& project, const Analysis& analysis, FighterAddress fighter,
                     std::span<const int> actions, std::optional<int> aspect = {});

/// Labels to keep: one per action of a fighter, as actionLabels gives them.
struct FighterLabels {
    FighterAddress fighter;
    std::vector<ActionLabel> labels;
};
/// Keeps what rules and machine propose, from a confidence on, as one step. Aspects that a hand has
/// set are never touched.
MaybeEdit acceptLabels(const Project& project, const Analysis& analysis,
                       std::span<const FighterLabels> proposals, double leastConfidence = 0);
/// Takes over labels with the sources they have (an import). Replaces hand-set aspects only by
/// hand-set ones.
MaybeEdit importLabels(const Project& project, const Analysis& analysis,
                       std::span<const FighterLabels> labels);

/// Fills in what `labels` say where no hand of this project has spoken yet (another person's work
/// joined to the own): what a hand has set stays, and nothing that is known gives way to a rule or
/// a machine.
MaybeEdit mergeLabels(const Project& project, const Analysis& analysis,
                      std::span<const FighterLabels> labels);

/// Another vocabulary; what was said stays where the new one has the same ids.
MaybeEdit setVocabulary(const Project& project, const Vocabulary& vocabulary);
MaybeEdit setRules(const Project& project, const RuleSettings& rules);
MaybeEdit setLearning(const Project& project, const LearningSettings& learning);
/// Remembers what a parameter search found.
MaybeEdit setModel(const Project& project, const std::optional<ModelRecord>& model);

}  // namespace kumite
