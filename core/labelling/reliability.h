#pragma once

#include <span>
#include <vector>

namespace kumite {

/// An answer of machines that had not seen its action.
struct JudgedAnswer {
    double margin = 0;  ///< to the next best answer
    bool right = false;
};

/// How often answers are right at a margin: it rises with the margin and takes no form beyond that
/// (isotonic regression, Ayer et al., Ann. Math. Statist. 26(4), 1955). Each step counts one right
/// and one wrong answer more than it holds (Laplace), as few answers prove little.
class Reliability {
public:
    explicit Reliability(std::span<const JudgedAnswer> answers);

    /// 0 to 1; 0.5 where there was no answer.
    double at(double margin) const;

private:
    struct Step {
        double from = 0;  ///< smallest margin in it
        int right = 0;
        int count = 0;

        double share() const { return static_cast<double>(right) / count; }
    };
    std::vector<Step> steps_;
};

}  // namespace kumite
