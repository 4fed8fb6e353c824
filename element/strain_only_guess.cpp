// SPDX-License-Identifier: BSD-3-Clause
#include "element/newton.hpp"

#include <Eigen/QR>

namespace element {

Vector6 strain_only_guess(const Task& task) {
    Eigen::Matrix<double, 7, 6> rows = Eigen::Matrix<double, 7, 6>::Zero();
    Eigen::Matrix<double, 7, 1> missing = Eigen::Matrix<double, 7, 1>::Zero();
    const Vector6 change = task.goal - task.rows.strain * task.strain;
    for (int r = 0; r < 6; ++r) {
        if (!task.rows.stress.row(r).isZero(0.0)) continue;
        rows.row(r) = task.rows.strain.row(r);
        missing[r] = change[r];
    }
    if (task.undrained) rows.row(6) = unit_tensor().transpose();
    return rows.completeOrthogonalDecomposition().solve(missing);
}

}  // namespace element
