#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"

namespace kumite {

/// Count, mean and covariance (divisor: the count) of one class of samples.
struct ClassMoments {
    double count = 0;
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
};

/// One per class; `samples` row by row. A class without samples has a count of 0 and zeros.
std::vector<ClassMoments> classMoments(const Eigen::MatrixXd& samples, std::span<const int> classes,
                                       int classCount);

/// Σ N_m W_m / N: what the classes vary within themselves.
Eigen::MatrixXd pooledCovariance(std::span<const ClassMoments> classes);

/// W_m becomes (N_m W_m + τ·W̄) / (N_m + τ) (method A8): classes with few samples borrow the shape
/// of all. τ = 0 leaves classes with samples as they are; those without become W̄.
void shrinkToward(const Eigen::MatrixXd& pooled, double tau, std::span<ClassMoments> classes);

/// Semi-tied covariances (Gales 1999; paper A, A.2): Σ_m = H diag(σ²_m) Hᵀ with H shared.
struct SemiTied {
    Eigen::MatrixXd transform;               ///< A = H⁻¹
    std::vector<Eigen::VectorXd> variances;  ///< σ²_m, one per class
    /// Mean log-likelihood per sample: at the start (A = I), then after every sweep. Never falls.
    std::vector<double> logLikelihood;
};

struct SemiTiedSettings {
    int maxSweeps = 60;
    double tolerance = 1e-4;  ///< nats per sample that a sweep must gain to go on

    bool operator==(const SemiTiedSettings&) const = default;
};

/// Maximum likelihood by sweeps over the rows of A; every covariance is made 1e-10 wider, so that
/// singular ones (no shrinkage, fewer samples than dimensions) have a highest point, too. Classes
/// with a count of 0 take no part but get their variances. Cancellable.
SemiTied trainSemiTied(std::span<const ClassMoments> classes, const SemiTiedSettings& settings = {},
                       const Progress& progress = {});

}  // namespace kumite
