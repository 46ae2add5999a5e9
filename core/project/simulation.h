#pragma once

#include <cstdint>
#include <vector>

#include "core/labelling/query.h"
#include "core/labelling/scores.h"
#include "core/project/label_files.h"

namespace kumite {

/// A user who answers from the truth, so that strategies can be compared.
struct SimulationSettings {
    bool active = true;    ///< asks where the machine is least certain; else in random order
    double budget = 0.10;  ///< share of all actions that the user labels
    std::uint32_t seed = 1;
    QuerySettings query;
};

/// The session after a number of answers.
struct CurvePoint {
    int labelled = 0;
    double expectedAccuracy = 0;  ///< as the user would see it: cross-validation on the answers
    double limbAccuracy = 0;      ///< on the actions not labelled, as labelAccuracy
    double labelAccuracy = 0;
};

struct Simulation {
    int actions = 0;  ///< after the segmentation was corrected
    int removed = 0;  ///< boundaries that the user removed, and added
    int added = 0;
    int labelled = 0;
    Scores scores;  ///< judged only on actions that no hand labelled
    std::vector<CurvePoint> curve;
    std::optional<int> stopHint;  ///< answers after which mayStop was first true
    ModelRecord model;
};

/// The true cut and labels of a take: what readLabels gives for a truth.json. A project's labels
/// and corrections in force are not used: the user starts from detection.
struct Truth {
    std::vector<TimedLabel> labels;
};

/// Plays a session on the take that the truth is about (index). First the user corrects the
/// segmentation: boundaries without a true one within 0.1 s go, true ones without a boundary come.
/// Then batches are asked, answered and learnt until the budget is used up.
Simulation simulateSession(const Project& project, int take, const Truth& truth,
                           const SimulationSettings& settings, const Progress& progress = {});

/// The segmentation corrected as above.
struct CorrectedProject {
    Project project;
    Analysis analysis;
    int removed = 0;
    int added = 0;
};
CorrectedProject correctFromTruth(const Project& project, int take, const Truth& truth,
                                  const Progress& progress = {});

}  // namespace kumite
