#include "core/labelling/learning_task.h"

#include <algorithm>
#include <set>

namespace kumite {
namespace {

/// Rows of a kernel that takes 16 MB.
constexpr Eigen::Index kLargeKernel = 1000;

/// What is said is decided; where its probability came out below that of the second, the two share
/// alike.
void agreeWithDecision(Prediction& prediction) {
    if (prediction.secondConfidence <= prediction.confidence) return;
    prediction.confidence = (prediction.confidence + prediction.secondConfidence) / 2;
    prediction.secondConfidence = prediction.confidence;
}

/// Two were found to hold that cannot both: their probabilities, given that not both do. `other`
/// has been withdrawn, its confidence is still that of what it was.
void shareBetween(Prediction& kept, Prediction& other) {
    const double own = kept.confidence * (1 - other.confidence);
    const double others = (1 - kept.confidence) * other.confidence;
    const double neither = (1 - kept.confidence) * (1 - other.confidence);
    const double all = own + others + neither;
    // Both for certain: a toss-up.
    const double share = all > 0 ? own / all : 0.5;
    other.secondConfidence = all > 0 ? others / all : 0.5;
    other.confidence = 1 - other.secondConfidence;
    // What else the kept aspect might be has gained what it lost.
    if (kept.confidence < 1) kept.secondConfidence *= (1 - share) / (1 - kept.confidence);
    kept.confidence = share;
    agreeWithDecision(kept);
    agreeWithDecision(other);
}

bool isLearnt(const Aspect& aspect) {
    return aspect.classifier == Classifier::Msvm;
}

}  // namespace

std::optional<int> LearningTask::classOf(const Label& label) const {
    const auto qualifier = [&](int aspect) { return label[static_cast<std::size_t>(aspect)]; };
    if (!whichLimbs) {
        const int own = qualifier(aspects.front());
        const bool outside = givenLimb && own == (*vocabulary)[aspects.front()].fallback;
        return own == kUnknown || outside ? std::nullopt : std::optional<int>(own);
    }
    int bits = 0;
    for (std::size_t i = 0; i < aspects.size(); ++i) {
        if (qualifier(aspects[i]) == kUnknown) return std::nullopt;
        if (qualifier(aspects[i]) != (*vocabulary)[aspects[i]].fallback) bits |= 1 << i;
    }
    return bits;
}

std::vector<LearningTask> learningTasks(const Vocabulary& vocabulary, bool limbFirst) {
    std::vector<LearningTask> tasks;
    std::vector<int> striking;
    for (int i = 0; i < vocabulary.size(); ++i) {
        if (isLearnt(vocabulary[i]) && vocabulary[i].limb) striking.push_back(i);
    }
    limbFirst = limbFirst && !striking.empty() && striking.size() <= 30;
    if (limbFirst) tasks.push_back({&vocabulary, striking, true, false, vocabulary.size()});
    for (int i = 0; i < vocabulary.size(); ++i) {
        if (!isLearnt(vocabulary[i])) continue;
        tasks.push_back({&vocabulary, {i}, false, limbFirst && vocabulary[i].limb.has_value(), i});
    }
    return tasks;
}

int TaskRows::classCount() const {
    return static_cast<int>(std::set<int>(classes.begin(), classes.end()).size());
}

const MsvmKernel& KernelCache::at(double gamma) {
    if (distances_.rows() > kLargeKernel && !kernels_.contains(gamma)) kernels_.clear();
    return kernels_.try_emplace(gamma, distances_, gamma).first->second;
}

TaskMachine::TaskMachine(const LearningTask& task, const TaskRows& rows, KernelCache& kernels,
                         const MsvmParameters& parameters, bool probabilities, std::uint32_t seed)
    : task_(task) {
    if (rows.classCount() > 1) {
        machine_ = std::make_unique<Msvm>(kernels.at(parameters.gamma), rows.indices, rows.classes,
                                          parameters.c, probabilities, seed);
    } else if (!rows.classes.empty()) {
        only_ = rows.classes.front();
        if (probabilities) onlyConfidence_ = std::max(0.0, 1 - 3.0 / rows.examples);
    }
}

void TaskMachine::answer(std::span<const float> squaredDistances, Prediction* aspects) const {
    if (!only_ && !machine_) return;
    Prediction& first = aspects[task_.aspects.front()];
    const bool decidedBefore =
        task_.givenLimb && first.qualifier == (*task_.vocabulary)[task_.aspects.front()].fallback;
    if (decidedBefore) return;
    const Msvm::Answer answer = machine_ ? machine_->predict(squaredDistances)
                                         : Msvm::Answer{*only_, 0, onlyConfidence_, kUnknown, 0};
    if (!task_.whichLimbs) {
        const Prediction limb = first;
        first = {answer.choice, answer.margin, answer.probability,
                 !machine_,     answer.second, answer.secondProbability};
        if (!task_.givenLimb) return;
        // As sure as the less sure of both steps; with one qualifier seen, the first step decides.
        first.margin = machine_ ? std::min(limb.margin, answer.margin) : limb.margin;
        first.confidence = machine_ ? limb.confidence * answer.probability : limb.confidence;
        first.blind = limb.blind;
        if (!machine_ || (limb.second != kUnknown && limb.margin < answer.margin)) {
            first.second = limb.second;
            first.secondConfidence = limb.secondConfidence;
        } else {
            first.secondConfidence = limb.confidence * answer.secondProbability;
        }
        if (first.confidence > 0) agreeWithDecision(first);
        return;
    }
    for (std::size_t i = 0; i < task_.aspects.size(); ++i) {
        const bool strikes = (answer.choice >> i) & 1;
        const int fallback = *(*task_.vocabulary)[task_.aspects[i]].fallback;
        // Which strike it would be instead, only the machine of that limb could say.
        const bool orNot = machine_ && strikes && ((answer.second >> i) & 1) == 0;
        aspects[task_.aspects[i]] = {
            strikes ? kUnknown : fallback, answer.margin,           answer.probability, !machine_,
            orNot ? fallback : kUnknown,   answer.secondProbability};
    }
}

void resolveConflicts(const Vocabulary& vocabulary, Prediction* aspects) {
    const auto isSaid = [&](int aspect) {
        const int qualifier = aspects[aspect].qualifier;
        return qualifier != kUnknown && qualifier != vocabulary[aspect].fallback;
    };
    for (int i = 0; i < vocabulary.size(); ++i) {
        for (const int other : vocabulary[i].excludes) {
            if (!isSaid(i) || !isSaid(other)) continue;
            const int weaker = aspects[i].margin < aspects[other].margin ? i : other;
            Prediction& withdrawn = aspects[weaker];
            Prediction& kept = aspects[weaker == i ? other : i];
            withdrawn.second = withdrawn.qualifier;
            withdrawn.qualifier = *vocabulary[weaker].fallback;
            if (withdrawn.confidence > 0) {
                shareBetween(kept, withdrawn);
            } else {
                withdrawn.secondConfidence = withdrawn.confidence = 0;
            }
        }
    }
}

}  // namespace kumite
