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

/// How far the actions of a feature matrix are from each other: standardised over all of them; an
/// action is as near as its mirror image if mirrors count.
class ActionDistances {
public:
    ActionDistances() = default;
    ActionDistances(const FeatureMatrix& features, bool mirrored);

    const FeatureMatrix& rows() const { return rows_; }        ///< standardised
    const FeatureMatrix& mirrors() const { return mirrors_; }  ///< empty if they do not count
    /// Squared distance of every row to this one.
    std::vector<double> squaredTo(int row) const;

    struct Neighbour {
        int row = 0;
        /// Root mean square over the standardised numbers: 0 the same, about 1.4 any two actions.
        double distance = 0;
        bool mirrored = false;  ///< it is the mirror image that is near

        bool operator==(const Neighbour&) const = default;
    };
    /// The rows nearest to `row` without itself, nearest first; of equals the first.
    std::vector<Neighbour> nearest(int row, int count) const;

private:
    Eigen::VectorXf squared(const FeatureMatrix& rows, int row) const;

    FeatureMatrix rows_;
    FeatureMatrix mirrors_;
};

}  // namespace kumite
