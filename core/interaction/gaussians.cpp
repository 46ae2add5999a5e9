#include "core/interaction/gaussians.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/interaction/log_determinant.h"

namespace kumite {
namespace {

/// Variance that every class has in every direction, of standardised numbers: without shrinkage and
/// with fewer samples than dimensions the likelihood would have no highest point.
constexpr double kTiny = 1e-10;

/// The covariances as columns of one matrix (their lower triangles), so that a weighted sum of them
/// and aᵀW a of all are one product each.
class CovarianceStack {
public:
    explicit CovarianceStack(std::span<const ClassMoments> classes)
        : size_(classes.front().covariance.rows()),
          columns_(size_ * (size_ + 1) / 2, static_cast<Eigen::Index>(classes.size())) {
        for (std::size_t m = 0; m < classes.size(); ++m) {
            Eigen::Index first = 0;
            for (Eigen::Index j = 0; j < size_; first += size_ - j, ++j) {
                columns_.col(static_cast<Eigen::Index>(m)).segment(first, size_ - j) =
                    classes[m].covariance.col(j).tail(size_ - j);
                columns_(first, static_cast<Eigen::Index>(m)) += kTiny;
            }
        }
    }
    /// The lower triangle of the sum; above it nothing is said.
    void weightedSum(const Eigen::VectorXd& weights, Eigen::MatrixXd& sum) {
        packed_.noalias() = columns_ * weights;
        Eigen::Index first = 0;
        for (Eigen::Index j = 0; j < size_; first += size_ - j, ++j)
            sum.col(j).tail(size_ - j) = packed_.segment(first, size_ - j);
    }
    /// a W_m aᵀ for every class.
    Eigen::VectorXd along(const Eigen::VectorXd& a) {
        packed_.resize(columns_.rows());
        Eigen::Index first = 0;
        for (Eigen::Index j = 0; j < size_; first += size_ - j, ++j) {
            packed_.segment(first, size_ - j) = 2 * a[j] * a.tail(size_ - j);
            packed_[first] = a[j] * a[j];
        }
        return columns_.transpose() * packed_;
    }

private:
    Eigen::Index size_;
    Eigen::MatrixXd columns_;
    Eigen::VectorXd packed_;
};

/// Classes with the same covariance are one to the sweeps. After shrinking, all that have a single
/// sample do.
struct DistinctClasses {
    std::vector<ClassMoments> classes;
    std::vector<std::size_t> of;  ///< for each class given, its place in `classes`

    explicit DistinctClasses(std::span<const ClassMoments> given) {
        for (const ClassMoments& each : given) {
            const auto same = std::find_if(classes.begin(), classes.end(), [&](const auto& other) {
                return other.covariance == each.covariance;
            });
            of.push_back(static_cast<std::size_t>(same - classes.begin()));
            if (same == classes.end()) {
                classes.push_back(each);
            } else {
                same->count += each.count;
            }
        }
    }
};

/// Row i of A for which the likelihood is highest while all else stays (Gales 1999).
Eigen::VectorXd bestRow(const Eigen::MatrixXd& scatter, const Eigen::VectorXd& cofactors,
                        double samples) {
    const Eigen::VectorXd direction =
        scatter.selfadjointView<Eigen::Lower>().llt().solve(cofactors);
    return direction * std::sqrt(samples / cofactors.dot(direction));
}

}  // namespace

std::vector<ClassMoments> classMoments(const Eigen::MatrixXd& samples, std::span<const int> classes,
                                       int classCount) {
    const Eigen::Index size = samples.cols();
    std::vector<ClassMoments> moments(
        static_cast<std::size_t>(classCount),
        {0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)});
    for (Eigen::Index i = 0; i < samples.rows(); ++i) {
        ClassMoments& each =
            moments[static_cast<std::size_t>(classes[static_cast<std::size_t>(i)])];
        ++each.count;
        each.mean += samples.row(i).transpose();
    }
    for (ClassMoments& each : moments) {
        if (each.count > 0) each.mean /= each.count;
    }
    for (Eigen::Index i = 0; i < samples.rows(); ++i) {
        ClassMoments& each =
            moments[static_cast<std::size_t>(classes[static_cast<std::size_t>(i)])];
        const Eigen::VectorXd d = samples.row(i).transpose() - each.mean;
        each.covariance.selfadjointView<Eigen::Lower>().rankUpdate(d, 1 / each.count);
    }
    for (ClassMoments& each : moments)
        each.covariance = Eigen::MatrixXd(each.covariance.selfadjointView<Eigen::Lower>());
    return moments;
}

Eigen::MatrixXd pooledCovariance(std::span<const ClassMoments> classes) {
    assert(!classes.empty());
    Eigen::MatrixXd pooled =
        Eigen::MatrixXd::Zero(classes.front().covariance.rows(), classes.front().covariance.cols());
    double samples = 0;
    for (const ClassMoments& each : classes) {
        pooled += each.count * each.covariance;
        samples += each.count;
    }
    if (samples > 0) pooled /= samples;
    return pooled;
}

void shrinkToward(const Eigen::MatrixXd& pooled, double tau, std::span<ClassMoments> classes) {
    for (ClassMoments& each : classes) {
        const double weight = each.count + tau;
        each.covariance =
            each.count > 0 ? Eigen::MatrixXd((each.count * each.covariance + tau * pooled) / weight)
                           : pooled;
    }
}

SemiTied trainSemiTied(std::span<const ClassMoments> given, const SemiTiedSettings& settings,
                       const Progress& progress) {
    assert(!given.empty());
    const DistinctClasses distinct(given);
    const std::vector<ClassMoments>& classes = distinct.classes;
    const Eigen::Index size = classes.front().covariance.rows();
    const auto count = static_cast<Eigen::Index>(classes.size());
    CovarianceStack covariances(classes);
    Eigen::VectorXd counts(count);
    for (Eigen::Index m = 0; m < count; ++m)
        counts[m] = classes[static_cast<std::size_t>(m)].count;
    const double samples = counts.sum();

    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(size, size);
    Eigen::MatrixXd variances(size, count);
    const auto measure = [&]() -> double {
        for (Eigen::Index i = 0; i < size; ++i)
            variances.row(i) = covariances.along(a.row(i).transpose()).transpose();
        if (samples <= 0) return 0;
        const double logs = counts.dot(variances.array().log().matrix().colwise().sum()) / samples;
        const double constant = static_cast<double>(size) * (std::log(2 * std::numbers::pi) + 1);
        return logDeterminant(a) - 0.5 * (logs + constant);
    };

    SemiTied result;
    result.logLikelihood.push_back(measure());
    for (int sweep = 0; sweep < settings.maxSweeps && samples > 0; ++sweep) {
        progress.update(static_cast<double>(sweep) / settings.maxSweeps);
        Eigen::MatrixXd inverse = a.inverse();
        Eigen::MatrixXd scatter(size, size);
        for (Eigen::Index i = 0; i < size; ++i) {
            const Eigen::VectorXd weights = counts.cwiseQuotient(variances.row(i).transpose());
            covariances.weightedSum(weights, scatter);
            const Eigen::VectorXd row = bestRow(scatter, inverse.col(i), samples);
            // Sherman–Morrison: the inverse after row i has changed.
            const Eigen::RowVectorXd change = (row.transpose() - a.row(i)) * inverse;
            const Eigen::VectorXd column = inverse.col(i);
            inverse.noalias() -= column * change / (1 + change[i]);
            a.row(i) = row.transpose();
        }
        result.logLikelihood.push_back(measure());
        const std::size_t last = result.logLikelihood.size() - 1;
        if (result.logLikelihood[last] - result.logLikelihood[last - 1] < settings.tolerance) break;
    }
    result.transform = a;
    for (const std::size_t m : distinct.of)
        result.variances.push_back(variances.col(static_cast<Eigen::Index>(m)));
    return result;
}

}  // namespace kumite
