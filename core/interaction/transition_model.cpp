#include "core/interaction/transition_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kumite {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// exp of logs, made to sum to 1; all 0 where nothing is possible.
std::vector<double> shares(const std::vector<double>& logs) {
    std::vector<double> values(logs.size(), 0.0);
    if (logs.empty()) return values;
    const double top = *std::max_element(logs.begin(), logs.end());
    if (top == kNothing) return values;
    double sum = 0;
    for (std::size_t i = 0; i < logs.size(); ++i)
        sum += values[i] = std::exp(logs[i] - top);
    for (double& value : values)
        value /= sum;
    return values;
}

void countExamples(const TransitionModel& model, int own, int opponent,
                   std::vector<NextLabel>& candidates) {
    for (const Transition& t : model.graph->transitionsOf(model.mover)) {
        const bool sameOwn = own == kAnyNode || t.ownNode == own;
        const bool sameOpponent = opponent == kAnyNode || t.opponentNode == opponent;
        NextLabel& next = candidates[static_cast<std::size_t>(t.nextNode)];
        next.ownExamples += sameOwn;
        next.opponentExamples += sameOpponent;
        next.examples += sameOwn && sameOpponent;
        ++next.nextExamples;
    }
}

/// Finds for every candidate the example that fits the moment best.
void findBestExamples(const TransitionModel& model, const Eigen::VectorXd& moment,
                      std::vector<NextLabel>& candidates) {
    std::vector<Eigen::VectorXd> now(candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        candidates[i].logDensity = kNothing;
        now[i] = model.geometry.turnedPart(moment, 0, static_cast<int>(i));
    }
    const std::vector<Transition>& transitions = model.graph->transitionsOf(model.mover);
    for (std::size_t i = 0; i < transitions.size(); ++i) {
        const auto node = static_cast<std::size_t>(transitions[i].nextNode);
        const double density = model.geometry.logDensityAt(
            now[node] + model.nextTurned.row(static_cast<Eigen::Index>(i)).transpose(),
            transitions[i].nextNode);
        if (!(density > candidates[node].logDensity)) continue;  // nor where it is not known
        candidates[node].logDensity = density;
        candidates[node].bestTransition = static_cast<int>(i);
    }
}

}  // namespace

TransitionModel learnTransitionModel(std::shared_ptr<const CoupledGraph> graph, int mover,
                                     LabelEstimator estimator, const GeometrySettings& settings,
                                     Eigen::MatrixXd numbers, const Progress& progress) {
    TransitionModel model;
    model.graph = std::move(graph);
    model.mover = mover;
    model.labels = learnLabelTerm(*model.graph, mover, estimator);
    model.counts = transitionCounts(*model.graph, mover);
    model.numbers = std::move(numbers);
    const std::vector<Transition>& transitions = model.graph->transitionsOf(mover);
    if (transitions.empty()) return model;
    std::vector<int> classes;
    std::vector<Eigen::Index> known;
    for (Eigen::Index i = 0; i < model.numbers.rows(); ++i) {
        if (model.numbers.row(i).hasNaN()) continue;
        known.push_back(i);
        classes.push_back(transitions[static_cast<std::size_t>(i)].nextNode);
    }
    if (known.empty()) return model;
    model.geometry = GeometryTerm(settings, model.numbers(known, Eigen::all), classes,
                                  model.graph->nodeCount(mover), progress);
    // Of n¹ᵢ₊₁, which stands last; a target's two numbers are no part of any n.
    const Eigen::Index size = model.numbers.cols() / 3;
    const auto first = static_cast<int>(model.numbers.cols() - size);
    model.nextTurned.resize(model.numbers.rows(), model.numbers.cols());
    for (Eigen::Index i = 0; i < model.numbers.rows(); ++i) {
        model.nextTurned.row(i) =
            model.geometry
                .turnedPart(model.numbers.row(i).tail(size).transpose(), first,
                            transitions[static_cast<std::size_t>(i)].nextNode)
                .transpose();
    }
    return model;
}

std::vector<NextLabel> nextLabels(const TransitionModel& model, int own, int opponent,
                                  const Eigen::VectorXd* moment) {
    const std::vector<double> logs = model.labels.logProbabilities(own, opponent);
    std::vector<NextLabel> candidates(logs.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        candidates[i].node = static_cast<int>(i);
        candidates[i].label = std::exp(logs[i]);
        candidates[i].product = candidates[i].label;
    }
    countExamples(model, own, opponent, candidates);
    if (moment && model.geometry.trained()) {
        findBestExamples(model, *moment, candidates);
        std::vector<double> densities, both;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            densities.push_back(candidates[i].logDensity);
            both.push_back(candidates[i].logDensity + logs[i]);
        }
        const std::vector<double> geometry = shares(densities);
        const std::vector<double> product = shares(both);
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            candidates[i].geometry = geometry[i];
            candidates[i].product = product[i];
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const NextLabel& a, const NextLabel& b) { return a.product > b.product; });
    return candidates;
}

}  // namespace kumite
