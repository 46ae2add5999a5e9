#include "core/labelling/reliability.h"

#include <algorithm>

namespace kumite {

Reliability::Reliability(std::span<const JudgedAnswer> answers) {
    std::vector<JudgedAnswer> sorted(answers.begin(), answers.end());
    std::stable_sort(
        sorted.begin(), sorted.end(),
        [](const JudgedAnswer& a, const JudgedAnswer& b) { return a.margin < b.margin; });
    for (const JudgedAnswer& answer : sorted) {
        steps_.push_back({answer.margin, answer.right ? 1 : 0, 1});
        // Neighbours that would fall become one.
        while (steps_.size() > 1 && steps_[steps_.size() - 2].share() >= steps_.back().share()) {
            const Step last = steps_.back();
            steps_.pop_back();
            steps_.back().right += last.right;
            steps_.back().count += last.count;
        }
    }
}

double Reliability::at(double margin) const {
    if (steps_.empty()) return 0.5;
    auto step = std::upper_bound(steps_.begin(), steps_.end(), margin,
                                 [](double value, const Step& each) { return value < each.from; });
    if (step != steps_.begin()) --step;
    return (step->right + 1.0) / (step->count + 2.0);
}

}  // namespace kumite
