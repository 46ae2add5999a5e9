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
/// section 3.1); more so the shallow, high and crowded ones, and those under a foot in flight.
Vector priorWeights() {
    return Vector(-4.5, -1.6, 6.0, -0.8, 0.2);
}

/// How firmly it is believed: corrections outweigh it after a handful.
Vector priorPrecision() {
    return Vector(0.5, 2.0, 2.0, 2.0, 2.0);
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

std::vector<Example> examplesOf(const SuspicionInput& input, std::size_t fighter) {
    std::vector<int> cutting;
    for (std::size_t i = 0; i < input.minima.size(); ++i) {
        if (input.minima[i].prominence >= input.threshold) cutting.push_back(static_cast<int>(i));
    }
    const std::vector<double> distance = gaps(input, cutting);
    std::vector<Example> examples;
    for (std::size_t i = 0; i < cutting.size(); ++i) {
        const ForceMinimum& minimum = input.minima[static_cast<std::size_t>(cutting[i])];
        Example example;
        // Each feature is 0 for an everyday minimum, so that the first weight is the base rate.
        const double scale = std::max(input.threshold, 1e-3);
        example.features << 1.0, std::log(std::max(minimum.prominence, 1e-6) / (4.0 * scale)),
            minimum.force - 0.8, std::log(std::clamp(distance[i], 0.02, 2.0) / 0.3),
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
        // A hand that moved a boundary meant it to be one.
        if (boundary.source == BoundarySource::Moved) judge(*boundary.minimum, 0.0);
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
    constexpr int kIterations = 25;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        Vector gradient = priorPrecision().cwiseProduct(weights - prior);
        Matrix hessian = priorPrecision().asDiagonal();
        for (const Example& example : examples) {
            const double share = example.judged ? 1.0 : quiet;
            const double p = logistic(weights.dot(example.features));
            gradient += share * (p - example.target) * example.features;
            hessian += share * p * (1.0 - p) * example.features * example.features.transpose();
        }
        const Vector step = hessian.ldlt().solve(gradient);
        weights -= step;
        if (step.norm() < 1e-9) break;
    }
    return weights;
}

}  // namespace

std::vector<Suspicion> rankSuspicion(std::span<const SuspicionInput> fighters) {
    std::vector<Example> examples;
    std::vector<Suspicion> result;
    for (std::size_t i = 0; i < fighters.size(); ++i) {
        const std::vector<Example> own = examplesOf(fighters[i], i);
        examples.insert(examples.end(), own.begin(), own.end());
        result.emplace_back(fighters[i].minima.size(), 0.0);
    }
    const Vector weights = fit(examples);
    for (const Example& example : examples) {
        result[example.fighter][static_cast<std::size_t>(example.minimum)] =
            logistic(weights.dot(example.features));
    }
    return result;
}

}  // namespace kumite
