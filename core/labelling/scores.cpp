#include "core/labelling/scores.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace kumite {
namespace {

/// The aspects with a limb that are not at their fallback, as bits.
std::vector<bool> limbsOf(const Vocabulary& vocabulary, const Label& label) {
    std::vector<bool> limbs;
    for (std::size_t i = 0; i < label.size(); ++i) {
        const Aspect& aspect = vocabulary.aspects[i];
        limbs.push_back(aspect.limb && label[i] != kUnknown && label[i] != aspect.fallback);
    }
    return limbs;
}

bool sameWhereKnown(const Label& truth, const Label& answer) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (truth[i] != kUnknown && truth[i] != answer[i]) return false;
    }
    return true;
}

AspectScore scoreOf(const Aspect& aspect, std::size_t index, std::span<const Label> truth,
                    std::span<const Label> answers) {
    const std::size_t count = aspect.qualifiers.size();
    AspectScore score;
    score.confusion.assign(count, std::vector<int>(count + 1, 0));
    int right = 0;
    int all = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (truth[i][index] == kUnknown) continue;
        const int answer = answers[i][index];
        ++score.confusion[static_cast<std::size_t>(truth[i][index])]
                         [answer == kUnknown ? count : static_cast<std::size_t>(answer)];
        right += answer == truth[i][index];
        ++all;
    }
    score.accuracy = all > 0 ? static_cast<double>(right) / all : 0.0;
    double sum = 0;
    int seen = 0;
    for (std::size_t q = 0; q < count; ++q) {
        int inTruth = score.confusion[q][count];
        int inAnswers = 0;
        for (std::size_t other = 0; other < count; ++other) {
            inTruth += score.confusion[q][other];
            inAnswers += score.confusion[other][q];
        }
        if (inTruth + inAnswers == 0) continue;
        ++seen;
        sum += 2.0 * score.confusion[q][q] / (inTruth + inAnswers);
    }
    score.macroF1 = seen > 0 ? sum / seen : 0.0;
    return score;
}

/// Every aspect at its fallback; those without one at what is most frequent in the truth.
double baseline(const Vocabulary& vocabulary, std::span<const Label> truth) {
    std::map<Label, int> constants;
    const Label others = othersLabel(vocabulary);
    for (const Label& label : truth) {
        Label constant = others;
        for (std::size_t i = 0; i < label.size(); ++i) {
            if (constant[i] == kUnknown) constant[i] = label[i];
        }
        if (sameWhereKnown(label, constant)) ++constants[constant];
    }
    int best = 0;
    for (const auto& [constant, count] : constants)
        best = std::max(best, count);
    return truth.empty() ? 0.0 : static_cast<double>(best) / static_cast<double>(truth.size());
}

}  // namespace

Scores judge(const Vocabulary& vocabulary, std::span<const Label> truth,
             std::span<const Label> answers) {
    assert(truth.size() == answers.size());
    Scores scores;
    scores.actions = static_cast<int>(truth.size());
    int strikes = 0;
    int limbs = 0;
    int labels = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        labels += sameWhereKnown(truth[i], answers[i]);
        const std::vector<bool> trueLimbs = limbsOf(vocabulary, truth[i]);
        if (std::find(trueLimbs.begin(), trueLimbs.end(), true) == trueLimbs.end()) continue;
        ++strikes;
        limbs += limbsOf(vocabulary, answers[i]) == trueLimbs;
    }
    scores.limbAccuracy = strikes > 0 ? static_cast<double>(limbs) / strikes : 0.0;
    scores.labelAccuracy =
        truth.empty() ? 0.0 : static_cast<double>(labels) / static_cast<double>(truth.size());
    scores.baselineAccuracy = baseline(vocabulary, truth);
    for (std::size_t i = 0; i < vocabulary.aspects.size(); ++i)
        scores.aspects.push_back(scoreOf(vocabulary.aspects[i], i, truth, answers));
    return scores;
}

std::optional<double> cohensKappa(std::span<const JudgementTable> tables) {
    double all = 0, same = 0, byChance = 0;
    for (const JudgementTable& table : tables) {
        std::vector<double> first(table.size()), second(table.size());
        double judged = 0;
        for (std::size_t i = 0; i < table.size(); ++i) {
            for (std::size_t j = 0; j < table.size(); ++j) {
                first[i] += table[i][j];
                second[j] += table[i][j];
                judged += table[i][j];
            }
            same += table[i][i];
        }
        for (std::size_t i = 0; i < table.size() && judged > 0; ++i)
            byChance += first[i] * second[i] / judged;
        all += judged;
    }
    if (all == 0) return std::nullopt;
    return byChance >= all ? 1.0 : (same - byChance) / (all - byChance);
}

}  // namespace kumite
