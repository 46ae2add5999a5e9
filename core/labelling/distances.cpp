#include "core/labelling/distances.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

/// Below this a dimension counts as without variance: the noise of floats, in metres or radians.
constexpr double kNoSpread = 1e-6;

}  // namespace

Standardiser::Standardiser(const FeatureMatrix& training)
    : mean_(Eigen::RowVectorXf::Zero(training.cols())),
      scale_(Eigen::RowVectorXf::Zero(training.cols())) {
    const Eigen::MatrixXd rows = training.cast<double>();
    const Eigen::RowVectorXd mean = rows.colwise().mean();
    const Eigen::RowVectorXd spread =
        ((rows.rowwise() - mean).colwise().squaredNorm() / static_cast<double>(training.rows()))
            .cwiseSqrt();
    mean_ = mean.cast<float>();
    for (Eigen::Index i = 0; i < spread.size(); ++i) {
        if (spread[i] > kNoSpread) scale_[i] = static_cast<float>(1.0 / spread[i]);
    }
}

FeatureMatrix Standardiser::apply(const FeatureMatrix& rows) const {
    return ((rows.rowwise() - mean_).array().rowwise() * scale_.array()).matrix();
}

FeatureMatrix squaredDistances(const FeatureMatrix& a, const FeatureMatrix& b) {
    FeatureMatrix distances = -2.0f * (a * b.transpose());
    distances.colwise() += a.rowwise().squaredNorm();
    distances.rowwise() += b.rowwise().squaredNorm().transpose();
    return distances.cwiseMax(0.0f);
}

FeatureMatrix rowsAt(const FeatureMatrix& matrix, std::span<const int> indices) {
    FeatureMatrix rows(static_cast<Eigen::Index>(indices.size()), matrix.cols());
    for (std::size_t i = 0; i < indices.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = matrix.row(indices[i]);
    return rows;
}

ActionDistances::ActionDistances(const FeatureMatrix& features, bool mirrored) {
    if (features.rows() == 0) return;
    const Standardiser standardiser(features);
    rows_ = standardiser.apply(features);
    if (!mirrored) return;
    mirrors_.resize(features.rows(), features.cols());
    const auto width = static_cast<std::size_t>(features.cols());
    for (Eigen::Index i = 0; i < features.rows(); ++i)
        mirrorFeatures({features.row(i).data(), width}, {mirrors_.row(i).data(), width});
    mirrors_ = standardiser.apply(mirrors_);
}

Eigen::VectorXf ActionDistances::squared(const FeatureMatrix& images, int row) const {
    return (rows_.rowwise() - images.row(row)).rowwise().squaredNorm();
}

std::vector<double> ActionDistances::squaredTo(int row) const {
    Eigen::VectorXf distances = squared(rows_, row);
    if (mirrors_.rows() > 0) distances = distances.cwiseMin(squared(mirrors_, row));
    return {distances.begin(), distances.end()};
}

std::vector<ActionDistances::Neighbour> ActionDistances::nearest(int row, int count) const {
    const Eigen::VectorXf plain = squared(rows_, row);
    Eigen::VectorXf mirrored = Eigen::VectorXf::Constant(plain.size(), INFINITY);
    if (mirrors_.rows() > 0) mirrored = squared(mirrors_, row);
    std::vector<Neighbour> all;
    for (int i = 0; i < static_cast<int>(plain.size()); ++i) {
        if (i == row) continue;
        const double least = std::min(plain[i], mirrored[i]);
        all.push_back(
            {i, std::sqrt(least / static_cast<double>(rows_.cols())), mirrored[i] < plain[i]});
    }
    const auto size = std::min(all.size(), static_cast<std::size_t>(std::max(0, count)));
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size), all.end(),
                      [](const Neighbour& a, const Neighbour& b) {
                          return std::pair(a.distance, a.row) < std::pair(b.distance, b.row);
                      });
    all.resize(size);
    return all;
}

}  // namespace kumite
