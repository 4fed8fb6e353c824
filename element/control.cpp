// SPDX-License-Identifier: BSD-3-Clause
#include "element/control.hpp"

#include <cmath>

namespace element {
namespace {

using Corner = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Matrix6 with_shear(const Corner& normal) {
    Matrix6 out = Matrix6::Identity();
    out.topLeftCorner<3, 3>() = normal;
    return out;
}

// Orthogonal: the same for stress and strain.
Corner isomorph() {
    Corner m;
    const double third = 1.0 / std::sqrt(3.0), sixth = 1.0 / std::sqrt(6.0);
    const double half = 1.0 / std::sqrt(2.0);
    m << -third, -third, -third,     //
        -2.0 * sixth, sixth, sixth,  //
        0.0, -half, half;
    return m;
}

Corner rendulic() {
    Corner m;
    const double half = 1.0 / std::sqrt(2.0);
    m << -1.0, 0.0, 0.0,    //
        0.0, -half, -half,  //
        0.0, -half, half;
    return m;
}

}  // namespace

Matrix6 stress_variables(Variables variables) {
    switch (variables) {
        case Variables::roscoe: {
            Corner m;
            m << -1.0 / 3.0, -1.0 / 3.0, -1.0 / 3.0,  //
                -1.0, 0.5, 0.5,                       //
                0.0, -1.0, 1.0;
            return with_shear(m);
        }
        case Variables::roscoe_isomorph: return with_shear(isomorph());
        case Variables::rendulic: return with_shear(rendulic());
        case Variables::cartesian: break;
    }
    return Matrix6::Identity();
}

Matrix6 strain_variables(Variables variables) {
    if (variables != Variables::roscoe) return stress_variables(variables);
    Corner m;               // inverse transpose of that of stress, so that work is the same
    m << -1.0, -1.0, -1.0,  //
        -2.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0,  //
        0.0, -0.5, 0.5;
    return with_shear(m);
}

Restrictions mixed_control(const Controls& controls, Variables variables) {
    const Matrix6 stress = stress_variables(variables), strain = strain_variables(variables);
    Restrictions out;
    for (int r = 0; r < 6; ++r) {
        if (controls[static_cast<std::size_t>(r)] == Control::stress)
            out.stress.row(r) = stress.row(r);
        else out.strain.row(r) = strain.row(r);
    }
    return out;
}

}  // namespace element
