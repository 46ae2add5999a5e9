#include "core/labelling/query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace kumite {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Candidates for each place in a batch: the least certain ones, among which spread decides.
constexpr int kCandidatesPerPlace = 4;

constexpr std::size_t kMostReferences = 1000;

/// One round's cross-validation trembles by some percent and before this many says little; means
/// over so many rounds do not.
constexpr std::size_t kRoundsTogether = 10;
constexpr double kGain = 0.01;

double meanOf(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

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
    : actions_(features, settings.mirrored), settings_(settings) {
    if (features.rows() == 0) return;
    const auto count = static_cast<std::size_t>(features.rows());
    std::vector<int> references;
    for (std::size_t i = 0; i < count; i += 1 + count / (kMostReferences + 1))
        references.push_back(static_cast<int>(i));
    const FeatureMatrix chosen = rowsAt(actions_.rows(), references);
    toReferences_ = squaredDistances(actions_.rows(), chosen);
    if (settings.mirrored) {
        toReferences_ = toReferences_.cwiseMin(squaredDistances(actions_.mirrors(), chosen));
    }
    toReferences_ = toReferences_.cwiseSqrt();
}

/// The row that brings the references nearest to what is asked; of equals the first. `covered`:
/// how near each reference is already.
int QueryQueue::mostRepresentative(const std::vector<int>& among,
                                   const Eigen::RowVectorXf& covered) const {
    int best = among.front();
    float most = -1;
    for (const int row : among) {
        const float gain = (covered - toReferences_.row(row)).cwiseMax(0.0f).sum();
        if (gain <= most) continue;
        most = gain;
        best = row;
    }
    return best;
}

std::vector<int> QueryQueue::next(const std::vector<bool>& answered,
                                  const Predictions* predictions) {
    bool takenBack = counted_.size() != answered.size();
    for (std::size_t i = 0; !takenBack && i < answered.size(); ++i)
        takenBack = counted_[i] && !answered[i];
    if (takenBack) {
        counted_.assign(answered.size(), false);
        nearest_.assign(answered.size(), kFar);
    }
    std::vector<int> open;
    // Nothing is nearer than the farthest at first.
    Eigen::RowVectorXf covered = Eigen::RowVectorXf::Constant(
        toReferences_.cols(), toReferences_.size() > 0 ? toReferences_.maxCoeff() : 0.0f);
    for (std::size_t i = 0; i < answered.size(); ++i) {
        if (!answered[i]) {
            open.push_back(static_cast<int>(i));
        } else {
            covered = covered.cwiseMin(toReferences_.row(static_cast<Eigen::Index>(i)));
            if (!counted_[i]) keepNearest(nearest_, actions_.squaredTo(static_cast<int>(i)));
            counted_[i] = true;
        }
    }
    if (static_cast<int>(answered.size() - open.size()) < settings_.start) predictions = nullptr;
    std::vector<int> batch;
    std::vector<double> toBatch(answered.size(), kFar);
    const auto take = [&](int row) {
        batch.push_back(row);
        keepNearest(toBatch, actions_.squaredTo(row));
        covered = covered.cwiseMin(toReferences_.row(row));
        std::erase(open, row);
    };
    const auto size = std::min(static_cast<std::size_t>(settings_.batch), open.size());
    const auto explore =
        static_cast<std::size_t>(std::lround(settings_.explore * static_cast<double>(size)));
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
    }
    std::vector<double> nearest = nearest_;  // also to what this batch asks
    // At first what stands for many; later what is like nothing shown so far.
    while (batch.size() < size) {
        keepNearest(nearest, toBatch);
        take(predictions ? farthest(open, nearest) : mostRepresentative(open, covered));
    }
    return batch;
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
    if (expected.size() < kRoundsTogether) return false;
    const auto last = expected.last(kRoundsTogether);
    if (meanOf(last.last(kRoundsTogether / 2)) >= target) return true;
    if (expected.size() < 2 * kRoundsTogether) return false;
    const auto before = expected.last(2 * kRoundsTogether).first(kRoundsTogether);
    return meanOf(last) - meanOf(before) < kGain;
}

}  // namespace kumite
