#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/labelling/learner.h"
#include "core/labelling/rules.h"
#include "core/project/analysis.h"
#include "core/project/labels.h"

namespace kumite {

/// All actions of a project's fighters (those whose recording is there and whose body is known),
/// one row each: what the machine learns from and speaks about.
struct ActionTable {
    struct Row {
        FighterAddress fighter;
        int action = 0;
    };
    std::vector<Row> rows;
    FeatureMatrix features;
    Findings findings;
};
ActionTable actionTable(const Project& project, const Analysis& analysis,
                        const Progress& progress = {});

/// The actions that a hand labelled, with what it said; aspects that it left open are unknown.
std::vector<Example> handExamples(const Project& project, const Analysis& analysis,
                                  const ActionTable& table);

/// Why the rules said what they said of an action.
struct RuleReasons {
    Reaction reaction;
    Move move;
    std::string react;  ///< in words; empty where the rule could not speak
    std::string moves;
};

/// A label for every action: by hand where a hand spoke; of the machine where it learnt; of the
/// rules, which look at the opponent's labels found so far.
struct Proposals {
    std::vector<FighterLabels> fighters;            ///< every fighter that has actions
    std::vector<std::vector<RuleReasons>> reasons;  ///< beside `fighters`, one per action
};
Proposals propose(const Project& project, const Analysis& analysis, const ActionTable& table,
                  const Predictions& predictions);

/// The labels that graphs and models are made of: what a hand said or somebody accepted, per
/// fighter that has actions. Where such a label leaves *move* or *react* open, the rules fill it
/// in; actions of which nothing is known stay unknown as a whole.
std::vector<FighterLabels> effectiveLabels(const Project& project, const Analysis& analysis);

/// Searches the parameters unless the project's record was made from the same examples and
/// settings, trains, predicts with calibrated confidences and proposes.
struct AutoLabels {
    Proposals proposals;
    ModelRecord model;
    int examples = 0;
    double expectedAccuracy = 0;  ///< of the learnt aspects where no hand spoke
};
AutoLabels labelAutomatically(const Project& project, const Analysis& analysis,
                              const Progress& progress = {});

}  // namespace kumite
