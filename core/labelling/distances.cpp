#include "core/labelling/distances.h"

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

}  // namespace kumite
