#include "studio/workspaces/label/learnt_labels.h"

#include <tuple>

namespace kumite::studio {

namespace {

std::vector<int> peaksOf(const ActionTable& table, const Analysis& analysis) {
    std::vector<int> peaks;
    for (const ActionTable::Row& row : table.rows) {
        const auto& actions = analysis.at(row.fighter).segmentation->actions;
        peaks.push_back(actions[static_cast<std::size_t>(row.action)].peak);
    }
    return peaks;
}

std::vector<std::vector<std::shared_ptr<const FighterMotion>>> motionsOf(const Analysis& analysis) {
    std::vector<std::vector<std::shared_ptr<const FighterMotion>>> motions;
    for (const auto& take : analysis.takes) {
        auto& fighters = motions.emplace_back();
        for (const FighterAnalysis& fighter : take)
            fighters.push_back(fighter.motion);
    }
    return motions;
}

LearntLabels begun(const LearningInput& input) {
    LearntLabels learnt;
    learnt.ground = input.ground;
    learnt.vocabulary = input.project.labelling.vocabulary;
    learnt.examples = input.examples;
    learnt.parameters = input.parameters;
    return learnt;
}

/// What to ask about next.
std::vector<int> nextBatch(const LearningInput& input, const Predictions& predictions) {
    LearningGround& ground = *input.ground;
    std::vector<bool> answered(ground.table.rows.size(), false);
    for (const Example& example : input.examples)
        answered[static_cast<std::size_t>(example.row)] = true;
    return ground.queue.next(answered, input.examples.empty() ? nullptr : &predictions);
}

}  // namespace

LearningGround::LearningGround(ActionTable actions, const Analysis& analysis,
                               const QuerySettings& settings)
    : table(std::move(actions)),
      peaks(peaksOf(table, analysis)),
      motions(motionsOf(analysis)),
      queue(table.features, settings) {}

bool LearningGround::knows(const Analysis& analysis, FighterAddress fighter) const {
    const auto take = static_cast<std::size_t>(fighter.take);
    const auto player = static_cast<std::size_t>(fighter.player);
    return take < motions.size() && player < motions[take].size() &&
           motions[take][player] == analysis.at(fighter).motion;
}

std::optional<int> LearningGround::rowOf(FighterAddress fighter, int peak) const {
    const auto key = [](FighterAddress address, int frame) {
        return std::tuple(address.take, address.player, frame);
    };
    // Rows stand in order of takes, players and time.
    std::size_t low = 0;
    std::size_t high = peaks.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        const bool before = key(table.rows[middle].fighter, peaks[middle]) < key(fighter, peak);
        (before ? low : high) = before ? middle + 1 : middle;
    }
    if (low == peaks.size() || peaks[low] != peak || table.rows[low].fighter != fighter) {
        return std::nullopt;
    }
    return static_cast<int>(low);
}

LearntLabels learnMargins(const LearningInput& input, const LearntLabels* before,
                          const Progress& progress) {
    const LabelSettings& settings = input.project.labelling;
    const ActionTable& table = input.ground->table;
    const TrainingSet set(*settings.vocabulary, table.features, input.examples, settings.learning);
    LearntLabels learnt = begun(input);
    learnt.predictions = set.predict(input.parameters, false, progress);
    if (before && before->ground == learnt.ground) {
        takeOverConfidences(learnt.predictions, before->predictions);
    }
    learnt.proposals = propose(input.project, input.analysis, table, learnt.predictions);
    learnt.batch = nextBatch(input, learnt.predictions);
    return learnt;
}

LearntLabels learnThoroughly(const LearningInput& input, bool search, const Progress& progress) {
    const LabelSettings& settings = input.project.labelling;
    const ActionTable& table = input.ground->table;
    const TrainingSet set(*settings.vocabulary, table.features, input.examples, settings.learning);
    LearntLabels learnt = begun(input);
    if (search) learnt.parameters = set.searchParameters(progress.part(0, 0.5));
    learnt.predictions = set.predict(learnt.parameters, true, progress.part(0.5, 0.8));
    learnt.expectedAccuracy =
        set.expectedAccuracy(learnt.parameters, learnt.predictions, progress.part(0.8, 1.0));
    learnt.calibrated = true;
    learnt.proposals = propose(input.project, input.analysis, table, learnt.predictions);
    return learnt;
}

void takeOverConfidences(Predictions& labels, const Predictions& sure) {
    if (labels.values.size() != sure.values.size()) return;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        Prediction& label = labels.values[i];
        const Prediction& known = sure.values[i];
        if (label.blind || label.qualifier != known.qualifier) continue;
        label.confidence = known.confidence;
        if (label.second == known.second) label.secondConfidence = known.secondConfidence;
    }
}

}  // namespace kumite::studio
