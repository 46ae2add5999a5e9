#pragma once

#include <vector>

#include <Eigen/Core>

namespace kumite {

/// Rows of a table in an order in which similar ones are neighbours.
struct RowOrder {
    std::vector<int> order;  ///< indices of rows
    /// How far the groups on both sides of a place are apart, 0 … 1: joins[i] stands between
    /// order[i - 1] and order[i]; joins[0] is 1. A large value ends a group of similar rows.
    std::vector<double> joins;
};

/// Average-linkage clustering of rows by Hellinger distance (rows are distributions; those that do
/// not sum to 1 are scaled, empty ones are alike). Subtrees are turned so that the ends that meet
/// are the more alike ones. Depends on nothing but the values: of equals the lower index comes
/// first. O(n²) in time and memory.
RowOrder orderBySimilarity(const Eigen::MatrixXd& rows);

}  // namespace kumite
