#pragma once

#include <Eigen/LU>

namespace kumite {

/// log |det A|, also where the determinant itself would overflow.
inline double logDeterminant(const Eigen::MatrixXd& matrix) {
    return matrix.partialPivLu().matrixLU().diagonal().array().abs().log().sum();
}

}  // namespace kumite
