#pragma once

#include <QString>

#include <vector>

#include <Eigen/Core>

#include "studio/workspaces/graph/matrix_grid.h"

namespace kumite::studio {

/// What the matrix shows: a number for each row and column, and how often each was seen.
struct MatrixTable {
    struct Line {
        QString name;
        int count = 0;  ///< transitions behind it
    };
    std::vector<Line> rows;
    std::vector<Line> columns;
    Eigen::MatrixXd values;  ///< probabilities, or differences of two
    Eigen::MatrixXi counts;
    bool isDifference = false;
};

enum class MatrixSort { Count, Name, Similarity };

/// The order in which rows and columns are shown: table indices by position.
struct MatrixOrder {
    std::vector<int> rows;
    std::vector<int> columns;
    /// Positions of rows before which a group of similar ones begins; empty unless sorted so.
    std::vector<int> groups;

    /// Position → table and back; what is not there stays -1.
    MatrixPlace inTable(const MatrixPlace& shown) const;
    MatrixPlace shown(const MatrixPlace& inTable) const;
};

/// Deterministic; of equals the one that stands first in the table. Sorted by similarity the
/// columns are too, by how alike their columns of numbers are.
MatrixOrder orderOf(const MatrixTable& table, MatrixSort sort);

}  // namespace kumite::studio
