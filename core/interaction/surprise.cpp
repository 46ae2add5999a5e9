#include "core/interaction/surprise.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

/// log P(l | l1, l2, n) of the observed label by a model without this transition. The other labels
/// share what the observed one leaves them as they did with it: of EQU5 and EQU7 that is exact.
double logPosterior(const TransitionModel& model, const LabelTriple& triple,
                    const Eigen::VectorXd& numbers, double logLabel, double logDensity) {
    const auto seen = static_cast<std::size_t>(triple.next);
    std::vector<double> logs = model.labels.logProbabilities(triple.own, triple.opponent);
    double rest = std::log1p(-std::exp(logLabel)) - std::log1p(-std::exp(logs[seen]));
    if (!std::isfinite(rest)) rest = 0;  // nothing is left to the others
    const std::vector<double> densities = model.geometry.logDensities(numbers);
    for (std::size_t label = 0; label < logs.size(); ++label)
        logs[label] += rest + densities[label];
    logs[seen] = logLabel + logDensity;
    return logs[seen] - logSum(logs);
}

}  // namespace

double valueOf(const Surprise& surprise, SurpriseKind kind) {
    if (kind == SurpriseKind::Label) return surprise.label;
    return kind == SurpriseKind::Geometry ? surprise.geometry : surprise.both;
}

std::vector<Surprise> surprises(const TransitionModel& model) {
    std::vector<Surprise> all;
    std::vector<std::size_t> known;
    double sum = 0;
    for (const LabelTriple& triple : labelTriples(model.graph->transitionsOf(model.mover))) {
        const auto row = static_cast<Eigen::Index>(all.size());
        const Eigen::VectorXd numbers = model.numbers.row(row).transpose();
        const double label = model.labels.logWithout(triple);
        Surprise surprise{-label, 0, -label};
        if (model.geometry.trained() && !numbers.hasNaN()) {
            const double density = model.geometry.logDensityWithout(numbers, triple.next);
            surprise.geometry = -density;
            surprise.both = -logPosterior(model, triple, numbers, label, density);
            sum += surprise.geometry;
            known.push_back(all.size());
        }
        all.push_back(surprise);
    }
    for (const std::size_t i : known)
        all[i].geometry -= sum / static_cast<double>(known.size());
    return all;
}

double uniformSurprise(const TransitionModel& model) {
    return std::log(std::max(1, model.labels.nodeCount()));
}

}  // namespace kumite
