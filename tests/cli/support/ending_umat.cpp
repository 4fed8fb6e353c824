// SPDX-License-Identifier: BSD-3-Clause
// A UMAT that ends the program in the way that PROPS(1) asks for, at its third call.
#include <csignal>
#include <cstdlib>

extern "C" void umat_(double* stress, double*, double* ddsdde, double*, double*, double*, double*,
                      double*, double*, double*, double*, double* dstran, double*, double*, double*,
                      double*, double*, double*, char*, int*, int*, int*, int*, double* props) {
    static int calls = 0;
    for (int i = 0; i < 36; ++i) ddsdde[i] = i % 7 == 0 ? 1e4 : 0.0;
    for (int i = 0; i < 6; ++i) stress[i] += 1e4 * dstran[i];
    if (++calls < 3) return;
    if (props[0] == 0.0) std::exit(0);
    if (props[0] == 1.0) std::raise(SIGSEGV);
    std::abort();
}
