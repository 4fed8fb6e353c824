// SPDX-License-Identifier: BSD-3-Clause
// Principal values, to roundoff also where two of them coincide. Not for kernels.
#pragma once

#include <Eigen/Eigenvalues>

#include "umat/notation.hpp"

GRIT_KERNEL_BEGIN

// Ascending.
inline Eigen::Vector3d principal_values(const Tensor<double>& A) {
    Eigen::Matrix3d M;
    M << A[0], A[3] * root_half, A[4] * root_half,  //
        A[3] * root_half, A[1], A[5] * root_half,   //
        A[4] * root_half, A[5] * root_half, A[2];
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(M, Eigen::EigenvaluesOnly).eigenvalues();
}

GRIT_KERNEL_END
