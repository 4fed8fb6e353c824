// SPDX-License-Identifier: BSD-3-Clause
// A UMAT of the bad kind: right in its answer, but it flips the sign of DSTRAN, changes PROPS and
// needs two state variables whatever NSTATV is. Upper-case symbol. PROPS: E, nu.
#include <cstddef>

extern "C" void UMAT(double* stress, double* statev, double* ddsdde, double*, double*, double*,
                     double*, double*, double*, double*, double*, double* dstran, double*, double*,
                     double*, double*, double*, double*, char*, int*, int*, int*, int*,
                     double* props, int*, double*, double*, double*, double*, double*, double*,
                     int*, int*, int*, int*, int*, int*, std::size_t) {
    const double E = props[0], nu = props[1], G = E / (2.0 * (1.0 + nu));
    const double lambda = 2.0 * G * nu / (1.0 - 2.0 * nu);
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column) {
            double C = row < 3 && column < 3 ? lambda : 0.0;
            if (row == column) C += row < 3 ? 2.0 * G : G;
            ddsdde[row + 6 * column] = C;
            stress[row] += C * dstran[column];
        }
    for (int i = 0; i < 6; ++i) dstran[i] = -dstran[i];
    props[0] = -1.0;
    statev[0] += 1.0;
    statev[1] = 2.0;
}
