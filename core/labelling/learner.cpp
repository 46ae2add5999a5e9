#include "core/labelling/learner.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/base/files.h"
#include "core/labelling/distances.h"
#include "core/labelling/learning_task.h"

namespace kumite {
namespace {

/// The grid, the usual values first: the score of few examples is noisy, so that others must be
/// clearly better.
constexpr std::array<double, 4> kSearchC = {16.0, 4.0, 64.0, 256.0};
constexpr std::array<double, 5> kSearchGamma = {0.5, 0.25, 0.125, 1.0, 0.0625};  // per dimension
constexpr double kClearlyBetter = 0.02;
constexpr std::size_t kSearchExamples = 300;

std::vector<int> rowsOf(const std::vector<Example>& examples) {
    std::vector<int> rows;
    for (const Example& example : examples)
        rows.push_back(example.row);
    return rows;
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

/// The highest score, if it is better than that at `usual` by more than `margin`; else `usual`.
std::size_t clearlyBest(const std::vector<double>& scores, std::size_t usual, double margin) {
    const auto best = std::max_element(scores.begin(), scores.end());
    return *best > scores[usual] + margin ? static_cast<std::size_t>(best - scores.begin()) : usual;
}

/// Mean of accuracy and of the mean recall of the classes: a machine that calls everything
/// "others" must not win only because most actions are.
double score(const std::vector<std::pair<int, int>>& truthAndAnswer) {
    std::map<int, std::pair<int, int>> classes;  // right, all
    int right = 0;
    for (const auto& [truth, answer] : truthAndAnswer) {
        classes[truth].first += truth == answer;
        ++classes[truth].second;
        right += truth == answer;
    }
    double recall = 0;
    for (const auto& [name, count] : classes)
        recall += static_cast<double>(count.first) / count.second;
    return 0.5 * right / static_cast<double>(truthAndAnswer.size()) +
           0.5 * recall / static_cast<double>(classes.size());
}

}  // namespace

struct TrainingSet::Data {
    const Vocabulary& vocabulary;
    LearningSettings settings;
    std::vector<Example> examples;    ///< as given
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
        }
        return rows;
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
    for (const Example& example : examples)
        data_->labels.push_back(example.label);
    data_->examples = std::move(examples);
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
        std::vector<bool> in;             ///< examples that take part
        std::vector<int> folds;           ///< of every example
        std::vector<double> scores = {};  ///< of every point of the grid
        int judged = 0;                   ///< answers behind a score
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
            for (const double c : kSearchC) {
                std::vector<std::pair<int, int>> answers;
                for (int fold = 0; fold < data.settings.folds; ++fold) {
                    std::vector<bool> training = search.in;
                    for (std::size_t i = 0; i < training.size(); ++i)
                        training[i] = training[i] && search.folds[i] != fold;
                    const TaskRows rows = data.rowsFor(*search.task, training);
                    if (rows.classCount() < 2) continue;
                    const Msvm machine(kernel, rows.indices, rows.classes, c);
                    // Mirror images answer as well: twice the ground to judge on.
                    for (std::size_t i = 0; i < data.rowCount(); ++i) {
                        const std::size_t example = i % data.examples.size();
                        if (!search.in[example] || search.folds[example] != fold) continue;
                        const auto truth = search.task->classOf(data.labels[i]);
                        if (!truth) continue;
                        answers.emplace_back(
                            *truth, machine.predictRow(kernel, static_cast<int>(i)).choice);
                    }
                }
                search.scores.push_back(answers.empty() ? 0 : score(answers));
                search.judged = static_cast<int>(answers.size());
            }
        }
        for (const double c : kSearchC)
            grid.push_back({c, kernel.gamma()});
    }
    progress.update(1.0);
    if (searches.empty()) return best;
    // What is best for all aspects together rests on the most answers; an aspect goes its own way
    // only where that is better by more than chance.
    std::vector<double> together(grid.size(), 0.0);
    for (const Search& search : searches) {
        for (std::size_t i = 0; i < grid.size(); ++i)
            together[i] += search.scores[i] / static_cast<double>(searches.size());
    }
    const std::size_t common = clearlyBest(together, 0, kClearlyBetter);
    std::fill(best.begin(), best.end(), grid[common]);
    for (const Search& search : searches) {
        const double wrong = 1 - search.scores[common];
        const double n = search.judged;
        const double chance = 2 * std::sqrt((wrong * (1 - wrong) + 1 / n) / n);
        best[static_cast<std::size_t>(search.task->slot)] =
            grid[clearlyBest(search.scores, common, chance)];
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

std::vector<Label> TrainingSet::crossValidate(const ParameterSet& parameters,
                                              const Progress& progress) const {
    const Data& data = *data_;
    std::vector<Label> result(data.examples.size(),
                              Label(data.vocabulary.aspects.size(), kUnknown));
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
    const auto aspects = data.vocabulary.aspects.size();
    for (int fold = 0; fold < data.settings.folds; ++fold) {
        progress.update(static_cast<double>(fold) / data.settings.folds);
        std::vector<bool> training(data.examples.size());
        for (std::size_t i = 0; i < training.size(); ++i)
            training[i] = folds[i] != fold;
        std::vector<std::vector<Prediction>> answers(data.examples.size(),
                                                     std::vector<Prediction>(aspects));
        for (const LearningTask& task : data.tasks) {
            const TaskMachine machine(task, data.rowsFor(task, training), kernels,
                                      Data::parametersOf(task, parameters), false,
                                      data.settings.seed);
            for (std::size_t i = 0; i < answers.size(); ++i) {
                if (training[i]) continue;
                const auto row = data.among.row(static_cast<Eigen::Index>(i));
                machine.answer({row.data(), data.rowCount()}, answers[i].data());
            }
        }
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (training[i]) continue;
            resolveConflicts(data.vocabulary, answers[i].data());
            for (std::size_t a = 0; a < aspects; ++a)
                result[i][a] = answers[i][a].qualifier;
        }
    }
    progress.update(1.0);
    return result;
}

double TrainingSet::expectedAccuracy(const ParameterSet& parameters,
                                     const Progress& progress) const {
    const std::vector<Example>& examples = data_->examples;
    if (examples.size() < 2) return 0;
    const std::vector<Label> answers = crossValidate(parameters, progress);
    int right = 0;
    for (std::size_t i = 0; i < examples.size(); ++i)
        right += learntAspectsMatch(data_->vocabulary, examples[i].label, answers[i]);
    return static_cast<double>(right) / static_cast<double>(examples.size());
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
