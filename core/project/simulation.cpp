#include "core/project/simulation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/project/labelling.h"

namespace kumite {
namespace {

/// A parameter search is worth its time when the examples have grown by a third.
constexpr double kSearchAgain = 1.33;

/// True inner boundaries of a fighter, in its frames.
std::vector<int> trueBoundaries(const Project& project, FighterAddress address,
                                const Truth& truth) {
    const Fighter& fighter = fighterAt(project, address);
    std::set<int> frames;
    for (const TimedLabel& label : truth.labels) {
        if (label.player != address.player + 1) continue;
        const Span span = spanOn(project, address, label);
        for (const double seconds : {span.begin, span.end})
            frames.insert(static_cast<int>(std::lround(seconds * fighter.rate)));
    }
    const int last = framesOf(fighter).size() - 1;
    frames.erase(frames.begin(), frames.upper_bound(0));
    frames.erase(frames.lower_bound(last), frames.end());
    return {frames.begin(), frames.end()};
}

/// Pairs boundaries with true ones, nearest pairs first; what has no partner within reach is left.
struct Unpaired {
    std::vector<int> spurious;
    std::vector<int> missing;
};
Unpaired pairUp(const std::vector<int>& found, const std::vector<int>& truth, double reach) {
    struct Pair {
        int distance;
        std::size_t found, truth;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (std::size_t j = 0; j < truth.size(); ++j) {
            const int distance = std::abs(found[i] - truth[j]);
            if (distance <= reach) pairs.push_back({distance, i, j});
        }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    std::vector<bool> foundTaken(found.size()), truthTaken(truth.size());
    for (const Pair& pair : pairs) {
        if (foundTaken[pair.found] || truthTaken[pair.truth]) continue;
        foundTaken[pair.found] = truthTaken[pair.truth] = true;
    }
    Unpaired unpaired;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!foundTaken[i]) unpaired.spurious.push_back(found[i]);
    }
    for (std::size_t j = 0; j < truth.size(); ++j) {
        if (!truthTaken[j]) unpaired.missing.push_back(truth[j]);
    }
    return unpaired;
}

/// The true label of every row: of the true action that overlaps it longest.
std::vector<Label> trueLabels(const Project& project, const Analysis& analysis,
                              const ActionTable& table, const Truth& truth) {
    std::vector<Label> labels;
    for (const ActionTable::Row& row : table.rows) {
        const double rate = fighterAt(project, row.fighter).rate;
        const Action& action =
            analysis.at(row.fighter).segmentation->actions[static_cast<std::size_t>(row.action)];
        const TimedLabel* best = nullptr;
        double longest = 0;
        for (const TimedLabel& label : truth.labels) {
            if (label.player != row.fighter.player + 1) continue;
            const Span span = spanOn(project, row.fighter, label);
            const double overlap =
                std::min(span.end, action.end / rate) - std::max(span.begin, action.begin / rate);
            if (overlap <= longest) continue;
            longest = overlap;
            best = &label;
        }
        Label label(static_cast<std::size_t>(project.labelling.vocabulary->size()), kUnknown);
        if (best) label = ActionLabel{0, best->aspects}.label();
        labels.push_back(std::move(label));
    }
    return labels;
}

/// A session under way.
class Session {
public:
    Session(CorrectedProject corrected, const Truth& truth, const SimulationSettings& settings)
        : project_(std::move(corrected.project)),
          analysis_(std::move(corrected.analysis)),
          settings_(settings),
          table_(actionTable(project_, analysis_)),
          truth_(trueLabels(project_, analysis_, table_, truth)),
          answered_(table_.rows.size(), false),
          queue_(table_.features, settings.query) {}

    Simulation run(const Progress& progress) {
        Simulation result;
        result.actions = static_cast<int>(table_.rows.size());
        const int budget = static_cast<int>(std::lround(settings_.budget * result.actions));
        std::vector<double> expected;
        std::optional<Predictions> predictions;
        while (static_cast<int>(examples_.size()) < budget) {
            progress.update(static_cast<double>(examples_.size()) / budget);
            answer(budget, predictions ? &*predictions : nullptr);
            const TrainingSet set(*project_.labelling.vocabulary, table_.features, examples_,
                                  project_.labelling.learning);
            const auto now = static_cast<double>(examples_.size());
            const bool last = static_cast<int>(examples_.size()) >= budget;
            if (last || now >= kSearchAgain * searchedAt_) {
                result.model.parameters = set.searchParameters();
                searchedAt_ = now;
            }
            predictions = set.predict(result.model.parameters, false);
            expected.push_back(set.expectedAccuracy(result.model.parameters, *predictions));
            result.scores = judgeRest(*predictions);
            result.curve.push_back({static_cast<int>(examples_.size()), expected.back(),
                                    result.scores.limbAccuracy, result.scores.labelAccuracy});
            if (!result.stopHint && mayStop(expected)) {
                result.stopHint = static_cast<int>(examples_.size());
            }
        }
        result.labelled = static_cast<int>(examples_.size());
        result.model.trainingHash = trainingHash(
            table_.features, examples_, project_.labelling.learning, result.model.parameters);
        progress.update(1.0);
        return result;
    }

private:
    /// The user answers the next batch, also in the project, where the rules look.
    void answer(int budget, const Predictions* predictions) {
        const int open = budget - static_cast<int>(examples_.size());
        std::vector<int> batch;
        if (settings_.active) {
            batch = queue_.next(answered_, predictions);
        } else {
            batch = randomQueries(answered_, settings_.query.batch,
                                  settings_.seed + static_cast<std::uint32_t>(examples_.size()));
        }
        batch.resize(std::min(batch.size(), static_cast<std::size_t>(open)));
        for (const int row : batch) {
            answered_[static_cast<std::size_t>(row)] = true;
            const Label& label = truth_[static_cast<std::size_t>(row)];
            examples_.push_back({row, label});
            const auto& [fighter, action] = table_.rows[static_cast<std::size_t>(row)];
            if (auto edit = setWholeLabel(project_, analysis_, fighter, {{action}}, label)) {
                project_ = std::move(edit->project);
            }
        }
    }

    Scores judgeRest(const Predictions& predictions) const {
        const Proposals proposals = propose(project_, analysis_, table_, predictions);
        std::vector<Label> truth, answers;
        for (std::size_t row = 0; row < table_.rows.size(); ++row) {
            if (answered_[row]) continue;
            const auto& [fighter, action] = table_.rows[row];
            const auto found = std::find_if(
                proposals.fighters.begin(), proposals.fighters.end(),
                [&, address = fighter](const FighterLabels& f) { return f.fighter == address; });
            truth.push_back(truth_[row]);
            answers.push_back(found->labels[static_cast<std::size_t>(action)].label());
        }
        return judge(*project_.labelling.vocabulary, truth, answers);
    }

    Project project_;
    Analysis analysis_;
    SimulationSettings settings_;
    ActionTable table_;
    std::vector<Label> truth_;
    std::vector<bool> answered_;
    QueryQueue queue_;
    std::vector<Example> examples_;
    double searchedAt_ = 0;
};

}  // namespace

CorrectedProject correctFromTruth(const Project& project, int take, const Truth& truth,
                                  const Progress& progress) {
    CorrectedProject result;
    result.project = project;
    result.project.takes = {project.takes.at(static_cast<std::size_t>(take))};
    result.project.labelling.model.reset();
    for (Fighter& fighter : result.project.takes.front().fighters) {
        fighter.labels = LabelTrack();
        fighter.corrections.clear();
    }
    result.analysis = analyse(result.project, {}, progress);
    const auto apply = [&](MaybeEdit edit) {
        if (!edit) return;
        result.project = std::move(edit->project);
        result.analysis = analyse(result.project, result.analysis);
    };
    const int players = static_cast<int>(result.project.takes.front().fighters.size());
    for (int player = 0; player < players; ++player) {
        const FighterAddress address{0, player};
        if (!result.analysis.at(address).segmentation) continue;
        const Fighter& fighter = fighterAt(result.project, address);
        const double rate = fighter.rate;
        const std::vector<int> trueFrames = trueBoundaries(result.project, address, truth);
        std::vector<int> found;
        for (const Boundary& boundary : result.analysis.at(address).segmentation->boundaries) {
            if (boundary.source != BoundarySource::End) found.push_back(boundary.frame);
        }
        const Unpaired unpaired = pairUp(found, trueFrames, kCorrectionReach * rate);
        for (const int frame : unpaired.spurious) {
            apply(removeBoundary(result.project, result.analysis, address, frame));
            ++result.removed;
        }
        for (const int frame : unpaired.missing) {
            apply(addBoundary(result.project, result.analysis, address, frame));
            ++result.added;
        }
    }
    return result;
}

Simulation simulateSession(const Project& project, int take, const Truth& truth,
                           const SimulationSettings& settings, const Progress& progress) {
    if (!(settings.budget > 0) || settings.budget > 1) {
        throw Error("The budget is a share of all actions, above 0 and at most 1.");
    }
    CorrectedProject corrected = correctFromTruth(project, take, truth, progress.part(0, 0.2));
    const int removed = corrected.removed;
    const int added = corrected.added;
    Session session(std::move(corrected), truth, settings);
    Simulation result = session.run(progress.part(0.2, 1.0));
    result.removed = removed;
    result.added = added;
    return result;
}

}  // namespace kumite
