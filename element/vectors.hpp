// SPDX-License-Identifier: BSD-3-Clause
// Signs and order everywhere in this library: tension and extension positive, Voigt order
// 11 22 33 12 13 23, engineering shear strain. Stress in any one unit; pore pressure is
// compression positive. Strain is logarithmic, or small.
#pragma once

#include <Eigen/LU>

namespace element {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;  // row i: derivative of component i
using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// 1 1 1 0 0 0: volumetric strain is its dot product with strain, hydrostatic stress a multiple of it.
inline Vector6 unit_tensor() {
    Vector6 one = Vector6::Zero();
    one.head<3>().setOnes();
    return one;
}

inline Matrix3 stress_tensor(const Vector6& s) {
    Matrix3 t;
    t << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
    return t;
}

inline Vector6 stress_components(const Matrix3& t) {
    Vector6 s;
    s << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(0, 2), t(1, 2);
    return s;
}

inline Matrix3 strain_tensor(const Vector6& e) {
    Vector6 s = e;
    s.tail<3>() *= 0.5;
    return stress_tensor(s);
}

inline Vector6 strain_components(const Matrix3& t) {
    Vector6 e = stress_components(t);
    e.tail<3>() *= 2.0;
    return e;
}

}  // namespace element
