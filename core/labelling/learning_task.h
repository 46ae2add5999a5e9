#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/labelling/learner.h"

namespace kumite {

/// One question to one machine: the qualifier of an aspect, or, limb first, which of the striking
/// aspects are not at their fallback (a set of bits).
struct LearningTask {
    const Vocabulary* vocabulary = nullptr;
    std::vector<int> aspects;  ///< that it decides: one, or all striking ones
    bool whichLimbs = false;   ///< the class is a set of bits over `aspects`
    bool givenLimb = false;    ///< learnt from, and asked about, strikes of this aspect only
    int slot = 0;              ///< its place in a ParameterSet

    /// The class of a training label; nothing where it does not train this task.
    std::optional<int> classOf(const Label& label) const;
};

/// The tasks of a vocabulary in the order in which they must be asked.
std::vector<LearningTask> learningTasks(const Vocabulary& vocabulary, bool limbFirst);

/// Rows of a training set that train a task, and their classes.
struct TaskRows {
    std::vector<int> indices;
    std::vector<int> classes;
    int examples = 0;  ///< without mirror images

    int classCount() const;
};

/// Kernels by γ over one matrix of squared distances; of a large one only the last is kept.
class KernelCache {
public:
    explicit KernelCache(const FeatureMatrix& squaredDistances) : distances_(squaredDistances) {}
    const MsvmKernel& at(double gamma);

private:
    const FeatureMatrix& distances_;
    std::map<double, MsvmKernel> kernels_;
};

/// A task with its trained machine; with one class seen it always answers that, and with
/// probabilities as sure as the rule of three: of n examples of one kind, others are with 95 %
/// certainty rarer than 3 / n.
class TaskMachine {
public:
    TaskMachine(const LearningTask& task, const TaskRows& rows, KernelCache& kernels,
                const MsvmParameters& parameters, bool probabilities, std::uint32_t seed);

    /// Writes the answer for one row into the predictions of its aspects. `squaredDistances`: of
    /// the row to all training rows. `aspects`: one per aspect of the vocabulary, with the answers
    /// of the tasks before.
    void answer(std::span<const float> squaredDistances, Prediction* aspects) const;

private:
    const LearningTask& task_;
    std::optional<int> only_;
    double onlyConfidence_ = 0;
    std::unique_ptr<Msvm> machine_;
};

/// Of aspects that exclude each other only the surest stays; the others go back to their fallback.
void resolveConflicts(const Vocabulary& vocabulary, Prediction* aspects);

}  // namespace kumite
