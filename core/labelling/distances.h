#pragma once

#include <span>
#include <vector>

#include "core/labelling/features.h"

namespace kumite {

/// Brings every dimension to mean 0 and standard deviation 1 over a training set (method A4); a
/// dimension without variance stays 0.
class Standardiser {
public:
    /// From the rows of `training`; at least one.
    explicit Standardiser(const FeatureMatrix& training);

    FeatureMatrix apply(const FeatureMatrix& rows) const;

private:
    Eigen::RowVectorXf mean_;
    Eigen::RowVectorXf scale_;
};

/// Squared Euclidean distance of every row of `a` (down) to every row of `b` (across).
FeatureMatrix squaredDistances(const FeatureMatrix& a, const FeatureMatrix& b);

/// The rows of a matrix at these indices.
FeatureMatrix rowsAt(const FeatureMatrix& matrix, std::span<const int> indices);

}  // namespace kumite
