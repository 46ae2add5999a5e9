#include "core/interaction/geometry_term.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/interaction/log_determinant.h"

namespace kumite {
namespace {

/// What is added to the pooled covariance, so that dimensions that never vary have some width.
constexpr double kPooledFloor = 1e-4;
/// W̄ (method A8): what the classes vary within themselves, by its unbiased estimate. Where most
/// classes have a single sample, that says little or nothing; so what all samples vary counts as
/// much as one sample per dimension.
Eigen::MatrixXd sharedCovariance(std::span<const ClassMoments> classes,
                                 const Eigen::MatrixXd& standard) {
    const auto samples = static_cast<double>(standard.rows());
    const auto dimensions = static_cast<double>(standard.cols());
    double freedom = 0;
    for (const ClassMoments& each : classes)
        freedom += std::max(0.0, each.count - 1);
    Eigen::MatrixXd shared = samples * pooledCovariance(classes);
    shared.noalias() += (dimensions / samples) * (standard.transpose() * standard);
    shared /= freedom + dimensions;
    shared.diagonal().array() += kPooledFloor;
    return shared;
}

/// Least share of the pooled variance that is left where a sample is taken out of a tiny class.
constexpr double kLeastVariance = 1e-4;
/// Variances are never 0, which only τ = 0 could bring about.
constexpr double kTiny = 1e-12;

struct Turn {
    Eigen::MatrixXd transform;
    Eigen::VectorXd variances;
};

/// Principal axes with floored variances.
Turn principal(const Eigen::MatrixXd& covariance, double floor) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(covariance);
    return {solved.eigenvectors().transpose(), solved.eigenvalues().cwiseMax(floor)};
}

/// L⁻¹ of a covariance L Lᵀ; of a singular one (no shrinkage, few samples) its principal axes.
Turn whitened(const Eigen::MatrixXd& covariance) {
    const Eigen::Index size = covariance.rows();
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    const auto pivots = factor.matrixLLT().diagonal().array();
    if (factor.info() != Eigen::Success || !(pivots.minCoeff() > std::sqrt(kTiny))) {
        return principal(covariance, kTiny);
    }
    return {factor.matrixL().solve(Eigen::MatrixXd::Identity(size, size)),
            Eigen::VectorXd::Ones(size)};
}

}  // namespace

std::string_view covarianceName(CovarianceKind kind) {
    switch (kind) {
        case CovarianceKind::Full:
            return "FULL";
        case CovarianceKind::FullRaw:
            return "FULL_RAW";
        case CovarianceKind::Diagonal:
            return "DIAGONAL";
        case CovarianceKind::SemiTied:
            break;
    }
    return "SEMITIED";
}

GeometryTerm::GeometryTerm(const GeometrySettings& settings, const Eigen::MatrixXd& samples,
                           std::span<const int> classes, int classCount, const Progress& progress)
    : settings_(settings) {
    assert(samples.rows() > 0 && samples.rows() == static_cast<Eigen::Index>(classes.size()));
    centre_ = samples.colwise().mean().transpose();
    Eigen::MatrixXd standard = samples.rowwise() - centre_.transpose();
    scale_ = (standard.colwise().squaredNorm() / static_cast<double>(samples.rows()))
                 .cwiseSqrt()
                 .transpose();
    // What never varies has no scale of its own.
    for (double& scale : scale_) {
        if (!(scale > 1e-12)) scale = 1;
    }
    standard.array().rowwise() /= scale_.transpose().array();

    std::vector<ClassMoments> moments = classMoments(standard, classes, classCount);
    const Eigen::Index size = standard.cols();
    pooled_ = sharedCovariance(moments, standard);
    const bool raw = settings.kind == CovarianceKind::FullRaw;
    shrinkToward(pooled_, raw ? 0 : settings.shrinkage, moments);

    std::vector<Eigen::VectorXd> variances;
    const auto add = [&](Turn turn) {
        transforms_.push_back(std::move(turn.transform));
        variances.push_back(std::move(turn.variances));
    };
    switch (settings.kind) {
        case CovarianceKind::SemiTied: {
            SemiTied tied = trainSemiTied(moments, settings.semiTied, progress);
            transforms_.push_back(std::move(tied.transform));
            variances = std::move(tied.variances);
            break;
        }
        case CovarianceKind::Diagonal:
            transforms_.push_back(Eigen::MatrixXd::Identity(size, size));
            for (const ClassMoments& each : moments)
                variances.emplace_back(each.covariance.diagonal().cwiseMax(kTiny));
            break;
        case CovarianceKind::Full:
            for (const ClassMoments& each : moments)
                add(whitened(each.covariance));
            break;
        case CovarianceKind::FullRaw:
            for (const ClassMoments& each : moments)
                add(principal(each.covariance, settings.eigenvalueFloor));
            break;
    }
    for (const Eigen::MatrixXd& transform : transforms_)
        logDeterminants_.push_back(logDeterminant(transform));
    for (std::size_t m = 0; m < moments.size(); ++m) {
        Gaussian gaussian;
        gaussian.count = moments[m].count;
        gaussian.transform = transforms_.size() > 1 ? static_cast<int>(m) : 0;
        // The global mean is 0 in standardised numbers.
        const double own =
            gaussian.count > 0 ? gaussian.count / (gaussian.count + settings.meanShrinkage()) : 0;
        gaussian.mean =
            own * (transforms_[static_cast<std::size_t>(gaussian.transform)] * moments[m].mean);
        gaussian.variances = variances[m];
        setFactor(gaussian);
        gaussians_.push_back(std::move(gaussian));
    }
    progress.update(1);
}

void GeometryTerm::setFactor(Gaussian& gaussian) const {
    gaussian.logFactor = logDeterminants_[static_cast<std::size_t>(gaussian.transform)] -
                         scale_.array().log().sum() -
                         0.5 * (gaussian.variances.array().log().sum() +
                                static_cast<double>(dimensions()) * std::log(2 * std::numbers::pi));
}

Eigen::VectorXd GeometryTerm::turned(const Eigen::VectorXd& numbers, int label) const {
    return turnedPart(numbers, 0, label);
}

Eigen::VectorXd GeometryTerm::turnedPart(const Eigen::VectorXd& part, int first, int label) const {
    const auto& gaussian = gaussians_[static_cast<std::size_t>(label)];
    const Eigen::Index size = part.size();
    return transforms_[static_cast<std::size_t>(gaussian.transform)].middleCols(first, size) *
           (part - centre_.segment(first, size)).cwiseQuotient(scale_.segment(first, size));
}

double GeometryTerm::logDensityAt(const Eigen::VectorXd& turned, int label) const {
    const Gaussian& gaussian = gaussians_[static_cast<std::size_t>(label)];
    const double distance =
        ((turned - gaussian.mean).array().square() / gaussian.variances.array()).sum();
    return gaussian.logFactor - 0.5 * distance;
}

double GeometryTerm::logDensity(const Eigen::VectorXd& numbers, int label) const {
    return logDensityAt(turned(numbers, label), label);
}

std::vector<double> GeometryTerm::logDensities(const Eigen::VectorXd& numbers) const {
    std::vector<double> all;
    Eigen::VectorXd y;
    for (int label = 0; label < static_cast<int>(gaussians_.size()); ++label) {
        // Turned once where the axes are shared.
        if (label == 0 || transforms_.size() > 1) y = turned(numbers, label);
        all.push_back(logDensityAt(y, label));
    }
    return all;
}

double GeometryTerm::logDensityWithout(const Eigen::VectorXd& numbers, int label) const {
    const Gaussian& gaussian = gaussians_[static_cast<std::size_t>(label)];
    const Eigen::VectorXd y = turned(numbers, label);
    if (settings_.kind == CovarianceKind::FullRaw) return logDensityAt(y, label);
    const Eigen::MatrixXd& transform = transforms_[static_cast<std::size_t>(gaussian.transform)];
    const Eigen::VectorXd pooled = (transform * pooled_).cwiseProduct(transform).rowwise().sum();
    const double n = gaussian.count;
    const double tau = settings_.shrinkage;
    Gaussian rest = gaussian;
    if (n <= 1) {
        rest.mean.setZero();  // the global mean, standardised
        rest.variances = pooled;
    } else {
        // Along each axis; the axes stay those that were found with the sample.
        const double kappa = settings_.meanShrinkage();
        const Eigen::VectorXd sum = (n + kappa) * gaussian.mean;
        const Eigen::ArrayXd squares =
            (n + tau) * gaussian.variances.array() - n / (n - 1) * (y - sum / n).array().square();
        rest.mean = (sum - y) / (n - 1 + kappa);
        rest.variances = (squares / (n - 1 + tau)).max(kLeastVariance * pooled.array()).matrix();
    }
    setFactor(rest);
    const double distance = ((y - rest.mean).array().square() / rest.variances.array()).sum();
    return rest.logFactor - 0.5 * distance;
}

}  // namespace kumite
