#include "core/segmentation/suspicion.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace kumite {
namespace {

constexpr int kFeatures = 5;
using Vector = Eigen::Matrix<double, kFeatures, 1>;
using Matrix = Eigen::Matrix<double, kFeatures, kFeatures>;

/// What is believed before anybody corrected anything: about 2 % of minima are spurious (paper A,
/// section 3.1); more so those that are shallower and higher than this fighter's usual ones, the
/// crowded ones, and those under a foot in flight. The weights were set on made bouts (core/demo),
/// whose truth is known.
Vector priorWeights() {
    return Vector(-5.5, -1.3, 12.0, -0.8, 0.2);
}

/// How firmly it is believed: corrections outweigh it after a handful, but one hasty decision must
/// not clear the others.
Vector priorPrecision() {
    return Vector(12.0, 4.0, 0.3, 2.0, 2.0);
}

/// Untouched minima are probably right, but nobody said so: all together they weigh 40 times as
/// much as the removed ones, never more than one each.
constexpr double kUntouchedPerRemoved = 40.0;

double footSpeedAt(const SuspicionInput& input, int frame) {
    if (input.footSpeed.empty()) return 1.0;  // neutral, see below
    return std::min(4.0, static_cast<double>(input.footSpeed[static_cast<std::size_t>(frame)]));
}

/// Seconds to the nearest other minimum that cuts, or to an end.
std::vector<double> gaps(const SuspicionInput& input, const std::vector<int>& cutting) {
    std::vector<double> result;
    const int last = static_cast<int>(input.curve.size()) - 1;
    const auto frameOf = [&](std::size_t i) {
        return input.minima[static_cast<std::size_t>(cutting[i])].frame;
    };
    for (std::size_t i = 0; i < cutting.size(); ++i) {
        const int before = i == 0 ? 0 : frameOf(i - 1);
        const int after = i + 1 == cutting.size() ? last : frameOf(i + 1);
        result.push_back(std::min(frameOf(i) - before, after - frameOf(i)) / input.rate);
    }
    return result;
}

/// One minimum that cuts: its features and what a hand said.
struct Example {
    Vector features;
    double target = 0;  ///< 1: spurious
    bool judged = false;
    std::size_t fighter = 0;
    int minimum = 0;
};

/// What is usual for a fighter: one who dances swings less than one who fights.
struct Usual {
    double prominence = 0;
    double force = 0;
};

Usual usualOf(const SuspicionInput& input, const std::vector<int>& cutting) {
    constexpr std::size_t kEnough = 20;
    if (cutting.size() < kEnough) return {4.0 * std::max(input.threshold, 1e-3), 0.8};
    std::vector<double> prominences, forces;
    for (const int i : cutting) {
        prominences.push_back(input.minima[static_cast<std::size_t>(i)].prominence);
        forces.push_back(input.minima[static_cast<std::size_t>(i)].force);
    }
    const auto median = [](std::vector<double>& values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    return {median(prominences), median(forces)};
}

std::vector<Example> examplesOf(const SuspicionInput& input, std::size_t fighter) {
    std::vector<int> cutting;
    for (std::size_t i = 0; i < input.minima.size(); ++i) {
        if (input.minima[i].prominence >= input.threshold) cutting.push_back(static_cast<int>(i));
    }
    const std::vector<double> distance = gaps(input, cutting);
    const Usual usual = usualOf(input, cutting);
    std::vector<Example> examples;
    for (std::size_t i = 0; i < cutting.size(); ++i) {
        const ForceMinimum& minimum = input.minima[static_cast<std::size_t>(cutting[i])];
        Example example;
        // Each feature is 0 for an everyday minimum, so that the first weight is the base rate.
        example.features << 1.0, std::log(std::max(minimum.prominence, 1e-6) / usual.prominence),
            minimum.force - usual.force, std::log(std::clamp(distance[i], 0.02, 2.0) / 0.3),
            footSpeedAt(input, minimum.frame) - 1.0;
        example.fighter = fighter;
        example.minimum = cutting[i];
        examples.push_back(example);
    }
    const auto judge = [&](int minimum, double target) {
        const auto it = std::find_if(examples.begin(), examples.end(),
                                     [&](const Example& e) { return e.minimum == minimum; });
        if (it == examples.end()) return;
        it->judged = true;
        it->target = target;
    };
    for (const RemovedBoundary& removed : input.segmentation->removed) {
        if (removed.minimum) judge(*removed.minimum, 1.0);
    }
    for (const Boundary& boundary : input.segmentation->boundaries) {
        // A hand that moved a boundary meant it to be one, as one that accepted it.
        if (boundary.source == BoundarySource::Moved ||
            boundary.source == BoundarySource::Accepted) {
            judge(*boundary.minimum, 0.0);
        }
    }
    return examples;
}

double logistic(double x) {
    return 1.0 / (1.0 + std::exp(-x));
}

/// Most probable weights given the prior and the examples, by Newton's method on a convex loss.
Vector fit(const std::vector<Example>& examples) {
    Vector prior = priorWeights();
    double removed = 0;
    double untouched = 0;
    for (const Example& example : examples) {
        if (example.judged) removed += example.target;
        if (!example.judged) ++untouched;
    }
    const bool anyJudged =
        std::any_of(examples.begin(), examples.end(), [](const Example& e) { return e.judged; });
    if (!anyJudged) return prior;
    const double quiet =
        untouched > 0 ? std::min(1.0, kUntouchedPerRemoved * removed / untouched) : 0.0;

    Vector weights = prior;
    constexpr int kIterations = 60;
    constexpr double kLongestStep = 1.0;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        Vector gradient = priorPrecision().cwiseProduct(weights - prior);
        Matrix hessian = priorPrecision().asDiagonal();
        for (const Example& example : examples) {
            const double share = example.judged ? 1.0 : quiet;
            const double p = logistic(weights.dot(example.features));
            gradient += share * (p - example.target) * example.features;
            hessian += share * p * (1.0 - p) * example.features * example.features.transpose();
        }
        // Far from the optimum a whole step may overshoot.
        Vector step = hessian.ldlt().solve(gradient);
        step *= std::min(1.0, kLongestStep / std::max(step.norm(), 1e-12));
        weights -= step;
        if (step.norm() < 1e-9) break;
    }
    return weights;
}

}  // namespace

std::vector<SuspicionRanking> rankSuspicion(std::span<const SuspicionInput> fighters) {
    std::vector<Example> examples;
    std::vector<SuspicionRanking> result;
    for (std::size_t i = 0; i < fighters.size(); ++i) {
        const std::vector<Example> own = examplesOf(fighters[i], i);
        examples.insert(examples.end(), own.begin(), own.end());
        const std::size_t count = fighters[i].minima.size();
        result.push_back({Suspicion(count, 0.0), std::vector<SuspicionEvidence>(count)});
    }
    const Vector weights = fit(examples);
    for (const Example& example : examples) {
        const auto minimum = static_cast<std::size_t>(example.minimum);
        SuspicionRanking& ranking = result[example.fighter];
        ranking.suspicion[minimum] = logistic(weights.dot(example.features));
        const Vector shares = weights.cwiseProduct(example.features);
        ranking.evidence[minimum] = {shares[1], shares[2], shares[3], shares[4]};
    }
    return result;
}

}  // namespace kumite
