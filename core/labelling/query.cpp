#include "core/labelling/query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "core/labelling/distances.h"

namespace kumite {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Candidates for each place in a batch: the least certain ones, among which spread decides.
constexpr int kCandidatesPerPlace = 4;

constexpr std::size_t kRoundsWithoutGain = 3;
constexpr double kGain = 0.005;

void keepNearest(std::vector<double>& nearest, const std::vector<double>& distances) {
    for (std::size_t i = 0; i < nearest.size(); ++i)
        nearest[i] = std::min(nearest[i], distances[i]);
}

/// Takes the place that is farthest from everything taken; of equals the first.
int farthest(const std::vector<int>& among, const std::vector<double>& nearest) {
    return *std::max_element(among.begin(), among.end(), [&](int a, int b) {
        return nearest[static_cast<std::size_t>(a)] < nearest[static_cast<std::size_t>(b)];
    });
}

}  // namespace

QueryQueue::QueryQueue(const FeatureMatrix& features, const QuerySettings& settings)
    : settings_(settings) {
    if (features.rows() == 0) return;
    const Standardiser standardiser(features);
    rows_ = standardiser.apply(features);
    if (!settings.mirrored) return;
    mirrors_.resize(features.rows(), features.cols());
    const auto width = static_cast<std::size_t>(features.cols());
    for (Eigen::Index i = 0; i < features.rows(); ++i)
        mirrorFeatures({features.row(i).data(), width}, {mirrors_.row(i).data(), width});
    mirrors_ = standardiser.apply(mirrors_);
}

std::vector<double> QueryQueue::distancesTo(int row) const {
    Eigen::VectorXf distances = (rows_.rowwise() - rows_.row(row)).rowwise().squaredNorm();
    if (settings_.mirrored) {
        distances =
            distances.cwiseMin((rows_.rowwise() - mirrors_.row(row)).rowwise().squaredNorm());
    }
    return {distances.begin(), distances.end()};
}

std::vector<int> QueryQueue::next(const std::vector<bool>& answered,
                                  const Predictions* predictions) const {
    std::vector<int> open;
    std::vector<double> toAnswered(answered.size(), kFar);
    for (std::size_t i = 0; i < answered.size(); ++i) {
        if (!answered[i]) {
            open.push_back(static_cast<int>(i));
        } else {
            keepNearest(toAnswered, distancesTo(static_cast<int>(i)));
        }
    }
    std::vector<int> batch;
    std::vector<double> toBatch(answered.size(), kFar);
    const auto take = [&](int row) {
        batch.push_back(row);
        keepNearest(toBatch, distancesTo(row));
        std::erase(open, row);
    };
    const auto size = std::min(static_cast<std::size_t>(settings_.batch), open.size());
    const auto explore = static_cast<std::size_t>(std::lround(settings_.explore * size));
    if (predictions) {
        std::vector<double> margin(answered.size());
        for (const int row : open)
            margin[static_cast<std::size_t>(row)] = smallestMargin(*predictions, row);
        std::vector<int> least = open;
        std::stable_sort(least.begin(), least.end(), [&](int a, int b) {
            return margin[static_cast<std::size_t>(a)] < margin[static_cast<std::size_t>(b)];
        });
        least.resize(std::min(least.size(), kCandidatesPerPlace * size));
        while (batch.size() + explore < size) {
            const int row = batch.empty() ? least.front() : farthest(least, toBatch);
            take(row);
            std::erase(least, row);
        }
    } else if (size > 0 && std::find(answered.begin(), answered.end(), true) == answered.end()) {
        // The first of all: the action nearest to the mean one, which is the origin.
        take(*std::min_element(open.begin(), open.end(), [&](int a, int b) {
            return rows_.row(a).squaredNorm() < rows_.row(b).squaredNorm();
        }));
    }
    std::vector<double> nearest = toAnswered;
    keepNearest(nearest, toBatch);
    while (batch.size() < size) {
        const int row = farthest(open, nearest);
        take(row);
        keepNearest(nearest, toBatch);
    }
    return batch;
}

double smallestMargin(const Predictions& predictions, int row) {
    double smallest = kFar;
    for (int aspect = 0; aspect < predictions.aspects; ++aspect) {
        const Prediction& prediction = predictions.at(row, aspect);
        if (!prediction.blind) smallest = std::min(smallest, prediction.margin);
    }
    return smallest;
}

std::vector<int> randomQueries(const std::vector<bool>& answered, int count, std::uint32_t seed) {
    std::vector<int> open;
    for (std::size_t i = 0; i < answered.size(); ++i) {
        if (!answered[i]) open.push_back(static_cast<int>(i));
    }
    std::mt19937 random(seed);
    const auto size = std::min(static_cast<std::size_t>(std::max(0, count)), open.size());
    for (std::size_t i = 0; i < size; ++i)
        std::swap(open[i], open[i + random() % (open.size() - i)]);
    open.resize(size);
    return open;
}

bool mayStop(std::span<const double> expected, double target) {
    if (expected.empty()) return false;
    if (expected.back() >= target) return true;
    if (expected.size() <= kRoundsWithoutGain) return false;
    const double before = expected[expected.size() - 1 - kRoundsWithoutGain];
    return expected.back() - before < kGain;
}

}  // namespace kumite
