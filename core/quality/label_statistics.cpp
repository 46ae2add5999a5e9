#include "core/quality/label_statistics.h"

#include <cmath>
#include <map>

namespace kumite {
namespace {

using Counts = std::map<std::vector<std::string>, int>;

Counts ngramsOf(std::span<const LabelSequence> sequences, int n) {
    Counts counts;
    for (const LabelSequence& sequence : sequences) {
        for (auto begin = sequence.begin(); sequence.end() - begin >= n; ++begin)
            ++counts[LabelSequence(begin, begin + n)];
    }
    return counts;
}

int totalOf(const Counts& counts) {
    int total = 0;
    for (const auto& [ngram, count] : counts)
        total += count;
    return total;
}

}  // namespace

NgramCount countNgrams(std::span<const LabelSequence> sequences, int n) {
    const Counts counts = ngramsOf(sequences, n);
    return {static_cast<int>(counts.size()), totalOf(counts)};
}

double ngramDistance(std::span<const LabelSequence> a, std::span<const LabelSequence> b, int n) {
    Counts first = ngramsOf(a, n), second = ngramsOf(b, n);
    const int ofFirst = totalOf(first), ofSecond = totalOf(second);
    if (ofFirst == 0 || ofSecond == 0) return ofFirst == ofSecond ? 0.0 : 1.0;
    for (const auto& [ngram, count] : second)
        first.try_emplace(ngram, 0);
    double sum = 0;
    for (const auto& [ngram, count] : first) {
        const auto other = second.find(ngram);
        const int counted = other == second.end() ? 0 : other->second;
        sum += std::abs(static_cast<double>(count) / ofFirst -
                        static_cast<double>(counted) / ofSecond);
    }
    return 0.5 * sum;
}

}  // namespace kumite
