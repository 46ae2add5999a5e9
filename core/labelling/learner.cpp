#include "core/labelling/learner.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "core/base/files.h"
#include "core/labelling/distances.h"
#include "core/labelling/learning_task.h"
#include "core/labelling/reliability.h"

namespace kumite {
namespace {

/// The grid, the usual values first.
constexpr std::array<double, 4> kSearchC = {16.0, 4.0, 64.0, 256.0};
constexpr std::array<double, 5> kSearchGamma = {0.5, 0.25, 0.125, 1.0, 0.0625};  // per dimension
/// How many standard deviations other values must be better than the usual ones. Many are tried,
/// and the examples of a session are its hard actions: with less, every search of a session moved
/// the values and made the rest worse for a while.
constexpr double kClearlyBetter = 3.0;
constexpr std::size_t kSearchExamples = 300;
/// Memory and time grow with the square of the examples; beyond this many hardly anything is
/// learnt from more of them.
constexpr std::size_t kMostExamples = 2000;
/// So many of every label stay, however rare it is.
constexpr std::size_t kFewestOfLabel = 5;

/// At most about kMostExamples of them: of every label its share, evenly over the rows.
std::vector<Example> thinned(std::vector<Example> examples) {
    if (examples.size() <= kMostExamples) return examples;
    std::map<Label, std::vector<std::size_t>> byLabel;
    for (std::size_t i = 0; i < examples.size(); ++i)
        byLabel[examples[i].label].push_back(i);
    std::vector<std::size_t> kept;
    for (const auto& [label, indices] : byLabel) {
        const std::size_t share = indices.size() * kMostExamples / examples.size();
        const std::size_t count = std::min(indices.size(), std::max(kFewestOfLabel, share));
        for (std::size_t i = 0; i < count; ++i)
            kept.push_back(indices[i * indices.size() / count]);
    }
    std::sort(kept.begin(), kept.end());
    std::vector<Example> fewer;
    for (const std::size_t index : kept)
        fewer.push_back(std::move(examples[index]));
    return fewer;
}

std::vector<int> rowsOf(const std::vector<Example>& examples) {
    std::vector<int> rows;
    for (const Example& example : examples)
        rows.push_back(example.row);
    return rows;
}

Label answerOf(const Predictions& predictions, int row) {
    Label label;
    for (int aspect = 0; aspect < predictions.aspects; ++aspect)
        label.push_back(predictions.at(row, aspect).qualifier);
    return label;
}

FeatureMatrix withMirrors(const FeatureMatrix& rows) {
    FeatureMatrix all(2 * rows.rows(), rows.cols());
    all.topRows(rows.rows()) = rows;
    const auto width = static_cast<std::size_t>(rows.cols());
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        mirrorFeatures({rows.row(i).data(), width}, {all.row(rows.rows() + i).data(), width});
    }
    return all;
}

/// At most `most` items, dealt so that every class keeps its share.
std::vector<bool> stratifiedPart(std::span<const int> classes, std::size_t most,
                                 std::uint32_t seed) {
    if (classes.size() <= most) return std::vector<bool>(classes.size(), true);
    const auto parts = static_cast<int>((classes.size() + most - 1) / most);
    const std::vector<int> part = stratifiedFolds(classes, parts, seed);
    std::vector<bool> in(classes.size());
    for (std::size_t i = 0; i < in.size(); ++i)
        in[i] = part[i] == 0;
    return in;
}

/// What a cross-validation answered: true class and answer.
using Answers = std::vector<std::pair<int, int>>;

/// Mean of accuracy and of the mean recall of the classes: a machine that calls everything
/// "others" must not win only because most actions are.
double score(const Answers& answers) {
    if (answers.empty()) return 0;
    std::map<int, std::pair<int, int>> classes;  // right, all
    int right = 0;
    for (const auto& [truth, answer] : answers) {
        classes[truth].first += truth == answer;
        ++classes[truth].second;
        right += truth == answer;
    }
    double recall = 0;
    for (const auto& [name, count] : classes)
        recall += static_cast<double>(count.first) / count.second;
    return 0.5 * right / static_cast<double>(answers.size()) +
           0.5 * recall / static_cast<double>(classes.size());
}

/// Whether others are right where the usual values are wrong far more often than the reverse (a
/// sign test). `copies`: answers per independent one, where mirror images answer as well.
bool clearlyBetter(const Answers& others, const Answers& usual, double copies) {
    double better = 0, worse = 0;
    for (std::size_t i = 0; i < usual.size(); ++i) {
        const bool rightThere = others[i].first == others[i].second;
        const bool rightUsually = usual[i].first == usual[i].second;
        better += rightThere && !rightUsually;
        worse += rightUsually && !rightThere;
    }
    return (better - worse) / copies > kClearlyBetter * std::sqrt((better + worse) / copies);
}

/// The point of the grid with the highest score, if it is clearly better than `usual`; else that.
std::size_t bestPoint(const std::vector<Answers>& grid, std::size_t usual, double copies) {
    std::vector<double> scores;
    for (const Answers& answers : grid)
        scores.push_back(score(answers));
    const auto highest =
        static_cast<std::size_t>(std::max_element(scores.begin(), scores.end()) - scores.begin());
    return clearlyBetter(grid[highest], grid[usual], copies) ? highest : usual;
}

}  // namespace

struct TrainingSet::Data {
    const Vocabulary& vocabulary;
    LearningSettings settings;
    std::vector<Example> examples;    ///< as given, thinned
    std::vector<int> handRows;        ///< of all that were given
    std::vector<Label> labels;        ///< of the training rows: examples, then their mirrors
    FeatureMatrix among;              ///< squared distances among the training rows
    FeatureMatrix toAll;              ///< from all rows of the features to the training rows
    std::vector<LearningTask> tasks;  ///< what is learnt

    Data(const Vocabulary& v, LearningSettings s) : vocabulary(v), settings(s) {}

    std::size_t rowCount() const { return labels.size(); }

    /// The training rows that a task learns from, with their classes, of the examples that `in`
    /// lets through.
    TaskRows rowsFor(const LearningTask& task, const std::vector<bool>& in) const {
        TaskRows rows;
        for (std::size_t i = 0; i < rowCount(); ++i) {
            if (!in[i % examples.size()]) continue;
            const auto name = task.classOf(labels[i]);
            if (!name) continue;
            rows.indices.push_back(static_cast<int>(i));
            rows.classes.push_back(*name);
            rows.examples += i < examples.size();
        }
        return rows;
    }

    /// What machines that had not seen an example and its mirror image say about both.
    Answers crossValidate(const LearningTask& task, const std::vector<bool>& in,
                          const std::vector<int>& folds, const MsvmKernel& kernel, double c) const {
        Answers answers;
        for (int fold = 0; fold < settings.folds; ++fold) {
            std::vector<bool> training = in;
            for (std::size_t i = 0; i < training.size(); ++i)
                training[i] = training[i] && folds[i] != fold;
            const TaskRows rows = rowsFor(task, training);
            if (rows.classCount() < 2) continue;
            const Msvm machine(kernel, rows.indices, rows.classes, c);
            for (std::size_t i = 0; i < rowCount(); ++i) {
                const std::size_t example = i % examples.size();
                if (!in[example] || folds[example] != fold) continue;
                const auto truth = task.classOf(labels[i]);
                if (!truth) continue;
                answers.emplace_back(*truth,
                                     machine.predictRow(kernel, static_cast<int>(i)).choice);
            }
        }
        return answers;
    }

    static const MsvmParameters& parametersOf(const LearningTask& task,
                                              const ParameterSet& parameters) {
        return parameters[static_cast<std::size_t>(task.slot)];
    }
};

TrainingSet::TrainingSet(const Vocabulary& vocabulary, const FeatureMatrix& features,
                         std::vector<Example> examples, const LearningSettings& settings)
    : data_(std::make_unique<Data>(vocabulary, settings)) {
    data_->tasks = learningTasks(vocabulary, settings.limbFirst);
    data_->handRows = rowsOf(examples);
    data_->examples = thinned(std::move(examples));
    for (const Example& example : data_->examples)
        data_->labels.push_back(example.label);
    if (data_->examples.empty()) {
        data_->toAll.resize(features.rows(), 0);
        return;
    }
    FeatureMatrix training = rowsAt(features, rowsOf(data_->examples));
    if (settings.mirrored) {
        training = withMirrors(training);
        for (const Example& example : data_->examples)
            data_->labels.push_back(mirroredLabel(vocabulary, example.label));
    }
    const Standardiser standardiser(training);
    training = standardiser.apply(training);
    data_->among = squaredDistances(training, training);
    data_->toAll = squaredDistances(standardiser.apply(features), training);
}

TrainingSet::~TrainingSet() = default;
TrainingSet::TrainingSet(TrainingSet&&) noexcept = default;

const std::vector<Example>& TrainingSet::examples() const {
    return data_->examples;
}

ParameterSet TrainingSet::searchParameters(const Progress& progress) const {
    const Data& data = *data_;
    ParameterSet best = defaultParameters(data.vocabulary);
    if (data.examples.empty()) return best;
    struct Search {
        const LearningTask* task;
        std::vector<bool> in;               ///< examples that take part
        std::vector<int> folds;             ///< of every example
        std::vector<Answers> answers = {};  ///< of every point of the grid
    };
    std::vector<MsvmParameters> grid;
    std::vector<Search> searches;
    for (const LearningTask& task : data.tasks) {
        std::vector<int> classes;
        for (const Example& example : data.examples)
            classes.push_back(task.classOf(example.label).value_or(kUnknown));
        Search search{&task, stratifiedPart(classes, kSearchExamples, data.settings.seed),
                      stratifiedFolds(classes, data.settings.folds, data.settings.seed)};
        if (data.rowsFor(task, search.in).classCount() > 1) searches.push_back(std::move(search));
    }
    double done = 0;
    const double all = static_cast<double>(kSearchGamma.size() * searches.size());
    for (const double gammaPerDimension : kSearchGamma) {
        const MsvmKernel kernel(data.among, gammaPerDimension / kFeatureCount);
        for (Search& search : searches) {
            progress.update(done++ / all);
            for (const double c : kSearchC)
                search.answers.push_back(
                    data.crossValidate(*search.task, search.in, search.folds, kernel, c));
        }
        for (const double c : kSearchC)
            grid.push_back({c, kernel.gamma()});
    }
    progress.update(1.0);
    if (searches.empty()) return best;
    // What is best for all aspects together rests on the most answers; an aspect goes its own way
    // only where that is better by more than chance.
    std::vector<Answers> together(grid.size());
    for (const Search& search : searches) {
        for (std::size_t i = 0; i < grid.size(); ++i) {
            const Answers& answers = search.answers[i];
            together[i].insert(together[i].end(), answers.begin(), answers.end());
        }
    }
    const double copies = data.settings.mirrored ? 2 : 1;
    const std::size_t common = bestPoint(together, 0, copies);
    std::fill(best.begin(), best.end(), grid[common]);
    for (const Search& search : searches) {
        best[static_cast<std::size_t>(search.task->slot)] =
            grid[bestPoint(search.answers, common, copies)];
    }
    return best;
}

Predictions TrainingSet::predict(const ParameterSet& parameters, bool probabilities,
                                 const Progress& progress) const {
    const Data& data = *data_;
    const auto rows = static_cast<int>(data.toAll.rows());
    Predictions predictions{data.vocabulary.size(), {}};
    predictions.values.resize(static_cast<std::size_t>(rows) * data.vocabulary.aspects.size());
    if (data.examples.empty()) return predictions;
    const std::vector<bool> everyone(data.examples.size(), true);
    KernelCache kernels(data.among);
    for (std::size_t t = 0; t < data.tasks.size(); ++t) {
        progress.update(static_cast<double>(t) / static_cast<double>(data.tasks.size()));
        const LearningTask& task = data.tasks[t];
        const TaskMachine machine(task, data.rowsFor(task, everyone), kernels,
                                  Data::parametersOf(task, parameters), probabilities,
                                  data.settings.seed);
        for (int row = 0; row < rows; ++row) {
            const auto width = static_cast<std::size_t>(data.toAll.cols());
            machine.answer({data.toAll.row(row).data(), width}, &predictions.at(row, 0));
        }
    }
    for (int row = 0; row < rows; ++row)
        resolveConflicts(data.vocabulary, &predictions.at(row, 0));
    progress.update(1.0);
    return predictions;
}

Predictions TrainingSet::unseen(const ParameterSet& parameters, const Progress& progress) const {
    const Data& data = *data_;
    const std::size_t aspects = data.vocabulary.aspects.size();
    Predictions result{static_cast<int>(aspects), {}};
    result.values.resize(data.examples.size() * aspects);
    if (data.examples.size() < 2) return result;
    std::map<Label, int> names;
    std::vector<int> classes;
    for (const Example& example : data.examples) {
        classes.push_back(
            names.try_emplace(example.label, static_cast<int>(names.size())).first->second);
    }
    const std::vector<int> folds =
        stratifiedFolds(classes, data.settings.folds, data.settings.seed);
    KernelCache kernels(data.among);
    for (int fold = 0; fold < data.settings.folds; ++fold) {
        progress.update(static_cast<double>(fold) / data.settings.folds);
        std::vector<bool> training(data.examples.size());
        for (std::size_t i = 0; i < training.size(); ++i)
            training[i] = folds[i] != fold;
        for (const LearningTask& task : data.tasks) {
            const TaskMachine machine(task, data.rowsFor(task, training), kernels,
                                      Data::parametersOf(task, parameters), false,
                                      data.settings.seed);
            for (std::size_t i = 0; i < training.size(); ++i) {
                if (training[i]) continue;
                const auto row = data.among.row(static_cast<Eigen::Index>(i));
                machine.answer({row.data(), data.rowCount()}, &result.at(static_cast<int>(i), 0));
            }
        }
    }
    for (std::size_t i = 0; i < data.examples.size(); ++i)
        resolveConflicts(data.vocabulary, &result.at(static_cast<int>(i), 0));
    progress.update(1.0);
    return result;
}

std::vector<Label> TrainingSet::crossValidate(const ParameterSet& parameters,
                                              const Progress& progress) const {
    const Predictions predictions = unseen(parameters, progress);
    std::vector<Label> result;
    for (int i = 0; i < static_cast<int>(data_->examples.size()); ++i)
        result.push_back(answerOf(predictions, i));
    return result;
}

double TrainingSet::expectedAccuracy(const ParameterSet& parameters, const Predictions& predictions,
                                     const Progress& progress) const {
    const std::vector<Example>& examples = data_->examples;
    if (examples.size() < 2) return 0;
    const Predictions answers = unseen(parameters, progress);
    std::vector<JudgedAnswer> judged;
    std::vector<bool> byHand(predictions.values.size() / data_->vocabulary.aspects.size());
    int right = 0;
    for (std::size_t i = 0; i < examples.size(); ++i) {
        const auto row = static_cast<int>(i);
        const bool isRight =
            learntAspectsMatch(data_->vocabulary, examples[i].label, answerOf(answers, row));
        judged.push_back({smallestMargin(answers, row), isRight});
        right += isRight;
    }
    for (const int row : data_->handRows)
        byHand[static_cast<std::size_t>(row)] = true;
    const Reliability reliability(judged);
    double sum = 0;
    int rest = 0;
    for (std::size_t row = 0; row < byHand.size(); ++row) {
        if (byHand[row]) continue;
        sum += reliability.at(smallestMargin(predictions, static_cast<int>(row)));
        ++rest;
    }
    return rest > 0 ? sum / rest
                    : static_cast<double>(right) / static_cast<double>(examples.size());
}

double smallestMargin(const Predictions& predictions, int row) {
    double smallest = std::numeric_limits<double>::infinity();
    for (int aspect = 0; aspect < predictions.aspects; ++aspect) {
        const Prediction& prediction = predictions.at(row, aspect);
        if (!prediction.blind) smallest = std::min(smallest, prediction.margin);
    }
    return smallest;
}

bool learntAspectsMatch(const Vocabulary& vocabulary, const Label& truth, const Label& answer) {
    for (std::size_t a = 0; a < truth.size(); ++a) {
        const bool learnt = vocabulary.aspects[a].classifier == Classifier::Msvm;
        if (learnt && truth[a] != kUnknown && answer[a] != truth[a]) return false;
    }
    return true;
}

ParameterSet defaultParameters(const Vocabulary& vocabulary) {
    return ParameterSet(vocabulary.aspects.size() + 1);
}

std::string trainingHash(const FeatureMatrix& features, const std::vector<Example>& examples,
                         const LearningSettings& settings, const ParameterSet& parameters) {
    std::string bytes;
    const auto append = [&](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    append(settings.mirrored);
    append(settings.limbFirst);
    append(settings.folds);
    append(settings.seed);
    for (const MsvmParameters& each : parameters) {
        append(each.c);
        append(each.gamma);
    }
    for (const Example& example : examples) {
        for (const int qualifier : example.label)
            append(qualifier);
        for (Eigen::Index i = 0; i < features.cols(); ++i)
            append(features(example.row, i));
    }
    return sha256(bytes);
}

std::vector<int> stratifiedFolds(std::span<const int> classes, int folds, std::uint32_t seed) {
    std::map<int, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < classes.size(); ++i)
        members[classes[i]].push_back(i);
    std::mt19937 random(seed);
    std::vector<int> fold(classes.size());
    int next = 0;
    for (auto& [name, items] : members) {
        // Fisher–Yates by hand: std::shuffle may differ between libraries.
        for (std::size_t i = items.size(); i > 1; --i)
            std::swap(items[i - 1], items[random() % i]);
        for (const std::size_t item : items)
            fold[item] = next++ % folds;
    }
    return fold;
}

}  // namespace kumite
