#include "core/labelling/learning_curve.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/labelling/distances.h"

namespace kumite {
namespace {

constexpr int kPoints = 10;

/// Numbers of labels at which the curve has points: multiples of the step, up to all.
std::vector<int> pointsUpTo(int all) {
    const int step = std::max(QuerySettings().batch, (all + kPoints - 1) / kPoints);
    std::vector<int> points;
    for (int n = step; n < all; n += step)
        points.push_back(n);
    points.push_back(all);
    return points;
}

std::vector<int> classesOf(const std::vector<Example>& examples) {
    std::map<Label, int> names;
    std::vector<int> classes;
    for (const Example& example : examples) {
        classes.push_back(
            names.try_emplace(example.label, static_cast<int>(names.size())).first->second);
    }
    return classes;
}

/// The examples with the features of their own rows alone: row i belongs to example i.
struct Examples {
    FeatureMatrix features;
    std::vector<Example> list;
};

Examples partOf(const FeatureMatrix& features, std::vector<Example> examples, std::uint32_t seed) {
    const auto most = static_cast<std::size_t>(kMostForCurves);
    if (examples.size() > most) {
        const int parts = static_cast<int>((examples.size() + most - 1) / most);
        const std::vector<int> part = stratifiedFolds(classesOf(examples), parts, seed);
        std::vector<Example> kept;
        for (std::size_t i = 0; i < examples.size(); ++i) {
            if (part[i] == 0) kept.push_back(std::move(examples[i]));
        }
        examples = std::move(kept);
    }
    std::vector<int> rows;
    for (Example& example : examples) {
        rows.push_back(example.row);
        example.row = static_cast<int>(rows.size()) - 1;
    }
    return {rowsAt(features, rows), std::move(examples)};
}

/// One held-out fold, and the pool of the others, from which labels are given. Of what is held out
/// the queue knows nothing.
class Fold {
public:
    Fold(const Vocabulary& vocabulary, const Examples& examples, const std::vector<int>& folds,
         int heldOut, const LearningSettings& settings, const ParameterSet& parameters)
        : vocabulary_(vocabulary),
          examples_(examples),
          settings_(settings),
          parameters_(parameters) {
        for (std::size_t i = 0; i < folds.size(); ++i)
            (folds[i] == heldOut ? heldOut_ : pool_).push_back(static_cast<int>(i));
    }

    /// Right answers on what is held out after each number of labels, in the queue's order.
    std::vector<int> asked(const std::vector<int>& points) const {
        QuerySettings query;
        query.mirrored = settings_.mirrored;
        query.batch = points.front();
        QueryQueue queue(rowsAt(examples_.features, pool_), query);
        return grow(points, [&](const std::vector<bool>& answered, int, const Predictions* said) {
            return queue.next(answered, said);
        });
    }
    std::vector<int> random(const std::vector<int>& points, std::uint32_t seed) const {
        return grow(points, [&](const std::vector<bool>& answered, int count, const Predictions*) {
            return randomQueries(answered, count, seed + static_cast<std::uint32_t>(count));
        });
    }

private:
    /// `choose` speaks of places in the pool.
    template <typename Choose>
    std::vector<int> grow(const std::vector<int>& points, const Choose& choose) const {
        std::vector<bool> answered(pool_.size(), false);
        std::vector<Example> given;
        std::optional<Predictions> said;
        std::vector<int> right;
        for (const int point : points) {
            const int open = point - static_cast<int>(given.size());
            std::vector<int> batch = choose(answered, open, said ? &*said : nullptr);
            batch.resize(std::min(batch.size(), static_cast<std::size_t>(open)));
            for (const int place : batch) {
                answered[static_cast<std::size_t>(place)] = true;
                const int row = pool_[static_cast<std::size_t>(place)];
                given.push_back(examples_.list[static_cast<std::size_t>(row)]);
            }
            const Predictions all = TrainingSet(vocabulary_, examples_.features, given, settings_)
                                        .predict(parameters_, false);
            said = ofPool(all);
            right.push_back(judge(all));
        }
        return right;
    }

    Predictions ofPool(const Predictions& all) const {
        Predictions pool{all.aspects, {}};
        for (const int row : pool_) {
            for (int a = 0; a < all.aspects; ++a)
                pool.values.push_back(all.at(row, a));
        }
        return pool;
    }

    int judge(const Predictions& said) const {
        int right = 0;
        for (const int row : heldOut_) {
            Label answer;
            for (int a = 0; a < said.aspects; ++a)
                answer.push_back(said.at(row, a).qualifier);
            right += learntAspectsMatch(
                vocabulary_, examples_.list[static_cast<std::size_t>(row)].label, answer);
        }
        return right;
    }

    const Vocabulary& vocabulary_;
    const Examples& examples_;
    std::vector<int> heldOut_;
    std::vector<int> pool_;
    const LearningSettings& settings_;
    const ParameterSet& parameters_;
};

}  // namespace

OrderCurves orderCurves(const Vocabulary& vocabulary, const FeatureMatrix& features,
                        const std::vector<Example>& examples, const LearningSettings& settings,
                        const ParameterSet& parameters, const Progress& progress) {
    OrderCurves curves;
    const Examples part = partOf(features, examples, settings.seed);
    curves.examples = static_cast<int>(part.list.size());
    if (curves.examples < kFewestForCurves) return curves;
    const std::vector<int> folds =
        stratifiedFolds(classesOf(part.list), settings.folds, settings.seed);
    // The same numbers of labels in every fold: those that the smallest rest has.
    std::vector<int> sizes(static_cast<std::size_t>(settings.folds), 0);
    for (const int fold : folds)
        ++sizes[static_cast<std::size_t>(fold)];
    const std::vector<int> points =
        pointsUpTo(curves.examples - *std::max_element(sizes.begin(), sizes.end()));
    for (const int labelled : points)
        curves.points.push_back({labelled, 0, 0});
    const auto add = [&](const std::vector<int>& right, double OrderPoint::*share, int runs) {
        for (std::size_t i = 0; i < right.size(); ++i)
            curves.points[i].*share += static_cast<double>(right[i]) / curves.examples / runs;
    };
    const int runs = settings.folds * (1 + kRandomDraws);
    int run = 0;
    for (int f = 0; f < settings.folds; ++f) {
        const Fold fold(vocabulary, part, folds, f, settings, parameters);
        progress.update(static_cast<double>(run++) / runs);
        add(fold.asked(points), &OrderPoint::asked, 1);
        for (int draw = 0; draw < kRandomDraws; ++draw) {
            progress.update(static_cast<double>(run++) / runs);
            const auto seed = settings.seed + 1000u * static_cast<std::uint32_t>(draw + 1) +
                              static_cast<std::uint32_t>(f);
            add(fold.random(points, seed), &OrderPoint::random, kRandomDraws);
        }
    }
    curves.heldOut = curves.examples;
    progress.update(1.0);
    return curves;
}

std::optional<OrderGain> orderGain(const OrderCurves& curves) {
    const auto& points = curves.points;
    for (std::size_t last = points.size(); last-- > 0;) {
        for (std::size_t first = 0; first < last; ++first) {
            if (points[first].asked >= points[last].random)
                return OrderGain{points[first].labelled, points[last].labelled};
        }
    }
    return std::nullopt;
}

}  // namespace kumite
