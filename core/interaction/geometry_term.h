#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/interaction/gaussians.h"

namespace kumite {

/// The shape of the Gaussians of the geometry term. FullRaw: as in the paper, eigenvalues floored;
/// the others draw small classes toward what all vary (method A8).
enum class CovarianceKind { Full, FullRaw, Diagonal, SemiTied };
std::string_view covarianceName(CovarianceKind kind);  ///< "SEMITIED"

struct GeometrySettings {
    CovarianceKind kind = CovarianceKind::SemiTied;
    /// τ, samples of what all vary that count with a label's own; 0: the plain method.
    double shrinkage = 20;
    /// κ, the same of the global mean: the mean of a label seen once or twice is mostly chance.
    double meanShrinkage() const { return kind == CovarianceKind::FullRaw ? 0 : 0.1 * shrinkage; }
    double eigenvalueFloor = 1e-3;  ///< of FullRaw, standardised units
    SemiTiedSettings semiTied;

    bool operator==(const GeometrySettings&) const = default;
};

/// The geometry term P(n¹ᵢ, n²ⱼ, n¹ᵢ₊₁ | l') of one mover: a Gaussian per next label over rows of
/// numbers. Dimensions are standardised inside; densities are those of the numbers as given (per
/// metre, radian …). A label without a sample has the global mean and the shape of all. Values;
/// safe to read from any thread.
class GeometryTerm {
public:
    GeometryTerm() = default;
    /// `samples` row by row, at least one; `classes` their next labels. Cancellable.
    GeometryTerm(const GeometrySettings& settings, const Eigen::MatrixXd& samples,
                 std::span<const int> classes, int classCount, const Progress& progress = {});

    bool trained() const { return !gaussians_.empty(); }
    int dimensions() const { return static_cast<int>(centre_.size()); }

    /// log density of the numbers under a label's Gaussian.
    double logDensity(const Eigen::VectorXd& numbers, int label) const;
    /// By label.
    std::vector<double> logDensities(const Eigen::VectorXd& numbers) const;
    /// The same by a Gaussian from which this sample, one of the label's own, is taken away: its
    /// mean and its spread; standardisation, H and the shape of all stay as they are. FullRaw: as
    /// trained, because a floor hides what the sample did.
    double logDensityWithout(const Eigen::VectorXd& numbers, int label) const;

    /// Numbers in the coordinates in which a label's Gaussian has no correlations, as logDensityAt
    /// takes them: standardised, centred and turned. Linear but for a shift: the first part of the
    /// numbers and the rest may be turned apart and added (see turnedPart).
    Eigen::VectorXd turned(const Eigen::VectorXd& numbers, int label) const;
    /// What the numbers from `first` on add to `turned`.
    Eigen::VectorXd turnedPart(const Eigen::VectorXd& part, int first, int label) const;
    double logDensityAt(const Eigen::VectorXd& turned, int label) const;
    /// Mean and variances of a label's Gaussian along the turned axes.
    const Eigen::VectorXd& mean(int label) const {
        return gaussians_[static_cast<std::size_t>(label)].mean;
    }
    const Eigen::VectorXd& variances(int label) const {
        return gaussians_[static_cast<std::size_t>(label)].variances;
    }

private:
    struct Gaussian {
        double count = 0;
        int transform = 0;
        Eigen::VectorXd mean;       ///< turned
        Eigen::VectorXd variances;  ///< along the turned axes
        double logFactor = 0;       ///< of the density of numbers as given
    };
    void setFactor(Gaussian& gaussian) const;

    GeometrySettings settings_;
    Eigen::VectorXd centre_;  ///< mean and deviation of the samples, to standardise them
    Eigen::VectorXd scale_;
    std::vector<Eigen::MatrixXd> transforms_;  ///< one shared, or one per label
    std::vector<double> logDeterminants_;
    Eigen::MatrixXd pooled_;           ///< standardised; W̄
    std::vector<Gaussian> gaussians_;  ///< by label
};

}  // namespace kumite
