#pragma once

#include <vector>

#include "core/labelling/scores.h"
#include "core/project/labelling.h"

namespace kumite {

/// A hand-labelled action and what would have been said of it without that hand.
struct JudgedAction {
    FighterAddress fighter;
    int action = 0;
    Label hand;    ///< unknown where the hand left it open
    Label answer;  ///< of machines that had not seen this action, and of the rules
};

/// Machine and rules held against the hand labels.
struct HandJudgement {
    std::vector<JudgedAction> actions;
    Scores scores;

    /// Actions that the hand called `hand` and that were answered `answer` (kUnknown: not at all).
    std::vector<std::size_t> cell(int aspect, int hand, int answer) const;
};

/// Learnt aspects by stratified cross-validation over the hand labels, rule aspects by what the
/// rules say. `proposals` of the same project, for the rules. Cancellable.
HandJudgement judgeHandLabels(const Project& project, const Analysis& analysis,
                              const ActionTable& table, const ParameterSet& parameters,
                              const Proposals& proposals, const Progress& progress = {});

/// How many actions have another qualifier of a rule aspect in one of two sets of proposals over
/// the same actions.
struct RuleChange {
    int aspect = 0;
    int changed = 0;
    int actions = 0;
};
std::vector<RuleChange> ruleChanges(const Vocabulary& vocabulary, const Proposals& before,
                                    const Proposals& after);

}  // namespace kumite
