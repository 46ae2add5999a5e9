#include "core/interaction/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/parallel.h"

namespace kumite {
namespace {

constexpr std::array kEstimators = {LabelEstimator::Equ5, LabelEstimator::Equ6,
                                    LabelEstimator::Equ7, LabelEstimator::Uniform};
constexpr std::array kKinds = {CovarianceKind::Full, CovarianceKind::FullRaw,
                               CovarianceKind::Diagonal, CovarianceKind::SemiTied};
constexpr std::array kTaus = {0.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};

/// Nats per sample that a sweep must gain: a hundred trainings need not be as fine as the one that
/// is used, and the figures are told to a hundredth.
constexpr double kTolerance = 1e-3;

/// Averages of one mover and one seed.
struct Scores {
    double train = 0;
    double validation = 0;
};

/// All that one mover and one seed give.
struct Round {
    std::size_t training = 0;
    std::size_t validation = 0;
    std::array<Scores, kEstimators.size()> labelTerm;
    std::array<Scores, kKinds.size()> geometryTerm;
    std::vector<Scores> density, pooled;  ///< by k
    std::vector<double> covered;
    std::array<Scores, kTaus.size()> shrinkage;
    Scores onePooled;  ///< for the k of the tables
};

/// One mover's transitions, split.
class Holdout {
public:
    Holdout(const CoupledGraph& graph, const BoutNumbers& numbers, const BoutSplit& split,
            int mover, TransitionNumbers kind)
        : graph_(graph), numbers_(numbers), mover_(mover), kind_(kind) {
        const auto& sides = split.sides[static_cast<std::size_t>(mover)];
        const auto& grounds = numbers.grounds[static_cast<std::size_t>(mover)];
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const bool known = kind == TransitionNumbers::Plain || grounds[i].target.has_value();
            if (sides[i] == HoldoutSide::Training) training_.add(i, known);
            if (sides[i] == HoldoutSide::Validation) validation_.add(i, known);
        }
    }
    bool usable() const { return !training_.known.empty() && !validation_.known.empty(); }
    std::size_t trainingCount() const { return training_.all.size(); }
    std::size_t validationCount() const { return validation_.all.size(); }

    Scores labelTerm(LabelEstimator estimator) const {
        const auto labels = [&](int player) {
            std::vector<Label> all;
            for (const GraphNode& node : graph_.nodes[static_cast<std::size_t>(player)])
                all.push_back(node.label);
            return all;
        };
        std::vector<LabelTriple> triples;
        for (const std::size_t i : training_.all)
            triples.push_back(triple(i));
        const LabelTerm term(estimator, *graph_.vocabulary, labels(mover_), labels(1 - mover_),
                             triples);
        return score(&Side::all, [&](std::size_t i) {
            const LabelTriple t = triple(i);
            return term.logProbabilities(t.own, t.opponent)[static_cast<std::size_t>(t.next)];
        });
    }

    /// Over rows of numbers by transition; `labels` false: one Gaussian for all.
    Scores geometryTerm(const Eigen::MatrixXd& rows, const GeometrySettings& settings, bool labels,
                        const Progress& progress) const {
        Eigen::MatrixXd samples(static_cast<Eigen::Index>(training_.known.size()), rows.cols());
        std::vector<int> classes;
        const auto classOf = [&](std::size_t i) { return labels ? triple(i).next : 0; };
        for (const std::size_t i : training_.known) {
            samples.row(static_cast<Eigen::Index>(classes.size())) =
                rows.row(static_cast<Eigen::Index>(i));
            classes.push_back(classOf(i));
        }
        const GeometryTerm term(settings, samples, classes, labels ? graph_.nodeCount(mover_) : 1,
                                progress);
        return score(&Side::known, [&](std::size_t i) {
            return term.logDensity(rows.row(static_cast<Eigen::Index>(i)).transpose(), classOf(i));
        });
    }

    Eigen::MatrixXd rows(const PoseSpace& space, int k) const {
        return transitionMatrix(graph_, numbers_, mover_, space, k, kind_);
    }

private:
    LabelTriple triple(std::size_t i) const {
        const Transition& t = graph_.transitionsOf(mover_)[i];
        return {t.ownNode, t.opponentNode, t.nextNode};
    }
    /// Transitions of a side: all of them, and those whose numbers are known.
    struct Side {
        std::vector<std::size_t> all, known;
        void add(std::size_t transition, bool isKnown) {
            all.push_back(transition);
            if (isKnown) known.push_back(transition);
        }
    };
    template <typename LogOf>
    Scores score(std::vector<std::size_t> Side::*which, const LogOf& logOf) const {
        const auto mean = [&](const std::vector<std::size_t>& side) {
            double sum = 0;
            for (const std::size_t i : side)
                sum += logOf(i);
            return sum / static_cast<double>(side.size());
        };
        return {mean(training_.*which), mean(validation_.*which)};
    }

    const CoupledGraph& graph_;
    const BoutNumbers& numbers_;
    int mover_;
    TransitionNumbers kind_;
    Side training_, validation_;
};

/// Principal components of the frames of all actions that training sees.
PoseSpace trainingSpace(const CoupledGraph& graph, const BoutSplit& split,
                        const PoseSource& poses) {
    PoseMoments sum;
    for (const std::size_t player : {0, 1}) {
        for (std::size_t i = 0; i < graph.actions[player].size(); ++i) {
            if (!split.learnt[player][i]) continue;
            const BasicAction& action = graph.actions[player][i];
            sum.add(
                poses(action.take, static_cast<int>(player),
                      {action.frames.begin, std::max(action.frames.begin + 1, action.frames.end)}));
        }
    }
    return poseSpace(sum);
}

std::optional<Round> playRound(const Holdout& holdout, const PoseSpace& space,
                               const ValidationSettings& settings, const Progress& progress) {
    if (!holdout.usable()) return std::nullopt;
    Round round;
    round.training = holdout.trainingCount();
    round.validation = holdout.validationCount();
    for (std::size_t i = 0; i < kEstimators.size(); ++i)
        round.labelTerm[i] = holdout.labelTerm(kEstimators[i]);
    const Progress quiet{{}, progress.stop};
    GeometrySettings geometry = settings.geometry;
    geometry.semiTied.tolerance = std::max(geometry.semiTied.tolerance, kTolerance);
    const Eigen::MatrixXd rows = holdout.rows(space, settings.components);
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        geometry.kind = kKinds[i];
        round.geometryTerm[i] = holdout.geometryTerm(rows, geometry, true, quiet);
    }
    geometry.kind = CovarianceKind::SemiTied;
    for (std::size_t i = 0; i < kTaus.size(); ++i) {
        GeometrySettings other = geometry;
        other.shrinkage = kTaus[i];
        // Table 3 has this one already.
        round.shrinkage[i] = other == geometry ? round.geometryTerm.back()
                                               : holdout.geometryTerm(rows, other, true, quiet);
    }
    GeometrySettings one = geometry;
    one.kind = CovarianceKind::Full;
    round.onePooled = holdout.geometryTerm(rows, one, false, quiet);
    for (int k = 1; k <= settings.maxComponents; ++k) {
        const Eigen::MatrixXd more = holdout.rows(space, k);
        round.density.push_back(k == settings.components
                                    ? round.geometryTerm.back()
                                    : holdout.geometryTerm(more, geometry, true, quiet));
        round.pooled.push_back(holdout.geometryTerm(more, one, false, quiet));
        round.covered.push_back(space.covered(k));
    }
    return round;
}

/// Means over movers and seeds; the deviation is that of the seeds' means.
class Summary {
public:
    explicit Summary(const std::vector<std::array<std::optional<Round>, 2>>& rounds)
        : rounds_(rounds) {}

    template <typename Pick>
    Averages of(const Pick& pick) const {
        Averages result;
        std::vector<double> bySeed;
        for (const auto& movers : rounds_) {
            double train = 0, validation = 0, count = 0;
            for (const std::optional<Round>& round : movers) {
                if (!round) continue;
                const Scores scores = pick(*round);
                train += scores.train;
                validation += scores.validation;
                ++count;
            }
            if (count == 0) continue;
            result.train += train / count;
            bySeed.push_back(validation / count);
        }
        if (bySeed.empty()) return result;
        const auto n = static_cast<double>(bySeed.size());
        result.train /= n;
        for (const double value : bySeed)
            result.validation += value / n;
        for (const double value : bySeed)
            result.deviation += (value - result.validation) * (value - result.validation);
        result.deviation = bySeed.size() > 1 ? std::sqrt(result.deviation / (n - 1)) : 0.0;
        return result;
    }
    template <typename Pick>
    double mean(const Pick& pick) const {
        return of([&](const Round& round) { return Scores{pick(round), 0}; }).train;
    }

private:
    const std::vector<std::array<std::optional<Round>, 2>>& rounds_;
};

ValidationResult summed(const std::vector<std::array<std::optional<Round>, 2>>& rounds,
                        const ValidationSettings& settings) {
    const Summary summary(rounds);
    ValidationResult result;
    for (const auto& movers : rounds)
        result.seeds += movers[0].has_value() || movers[1].has_value();
    if (result.seeds == 0) return result;
    result.transitions = {
        summary.mean([](const Round& r) { return static_cast<double>(r.training); }),
        summary.mean([](const Round& r) { return static_cast<double>(r.validation); })};
    for (std::size_t i = 0; i < kEstimators.size(); ++i)
        result.labelTerm[i] = summary.of([&](const Round& r) { return r.labelTerm[i]; });
    for (std::size_t i = 0; i < kKinds.size(); ++i)
        result.geometryTerm[i] = summary.of([&](const Round& r) { return r.geometryTerm[i]; });
    result.pooled = summary.of([](const Round& r) { return r.onePooled; });
    for (std::size_t i = 0; i < kTaus.size(); ++i) {
        result.shrinkage.push_back(
            {kTaus[i], summary.of([&](const Round& r) { return r.shrinkage[i]; })});
    }
    for (int k = 1; k <= settings.maxComponents; ++k) {
        const auto i = static_cast<std::size_t>(k - 1);
        result.components.push_back({k, summary.mean([&](const Round& r) { return r.covered[i]; }),
                                     summary.of([&](const Round& r) { return r.density[i]; }),
                                     summary.of([&](const Round& r) {
                                         return Scores{
                                             r.density[i].train - r.pooled[i].train,
                                             r.density[i].validation - r.pooled[i].validation};
                                     })});
    }
    return result;
}

}  // namespace

ValidationResult crossValidate(const CoupledGraph& graph, const BoutNumbers& numbers,
                               const PoseSource& poses, const ValidationSettings& settings,
                               const Progress& progress) {
    std::vector<BoutSplit> splits;
    std::vector<PoseSpace> spaces;
    for (int i = 0; i < settings.seeds; ++i) {
        progress.update(0.1 * i / settings.seeds);
        splits.push_back(splitBout(graph, settings, settings.seed + static_cast<std::uint32_t>(i)));
        spaces.push_back(trainingSpace(graph, splits.back(), poses));
    }
    std::vector<std::array<std::optional<Round>, 2>> rounds(splits.size());
    forBlocks({0, 2 * settings.seeds}, 1, [&](FrameRange job) {
        progress.update(0.1 + 0.9 * job.begin / (2 * settings.seeds));
        const auto seed = static_cast<std::size_t>(job.begin / 2);
        const int mover = job.begin % 2;
        const Holdout holdout(graph, numbers, splits[seed], mover, settings.numbers);
        rounds[seed][static_cast<std::size_t>(mover)] =
            playRound(holdout, spaces[seed], settings, progress);
    });
    progress.update(1);
    return summed(rounds, settings);
}

}  // namespace kumite
