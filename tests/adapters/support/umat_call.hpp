// SPDX-License-Identifier: BSD-3-Clause
// One call of umat_ as a host makes it: the library opened with dlopen, Fortran's argument list.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "support/guarded.hpp"

extern "C" {
typedef void (*UmatFunction)(double* stress, double* statev, double* ddsdde, double* sse,
                             double* spd, double* scd, double* rpl, double* ddsddt, double* drplde,
                             double* drpldt, const double* stran, const double* dstran,
                             const double* time, const double* dtime, const double* temp,
                             const double* dtemp, const double* predef, const double* dpred,
                             const char* cmname, const int* ndi, const int* nshr, const int* ntens,
                             const int* nstatv, const double* props, const int* nprops,
                             const double* coords, const double* drot, double* pnewdt,
                             const double* celent, const double* dfgrd0, const double* dfgrd1,
                             const int* noel, const int* npt, const int* layer, const int* kspt,
                             const int* kstep, const int* kinc, std::size_t cmname_length);
}

// umat_ of libGRITUMAT.so, found with dlsym.
UmatFunction umat();

constexpr double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

// A point of a host, its arguments and its memory. Copies are independent.
struct UmatCall {
    Guarded<6> stress;
    Guarded<16> statev;
    Guarded<36> ddsdde{-1.0};
    Guarded<6> dstran;
    Guarded<19> props;
    double drot[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};  // column-major
    double pnewdt = 1.0;
    double energy[3] = {11.0, 12.0, 13.0};  // SSE, SPD, SCD
    int ndi = 3, nshr = 3, ntens = 6, nstatv = 14, nprops = 16;
    int noel = 12, npt = 3;
    bool sparse = false;  // as Kratos: null wherever the law can do without
    std::string missing;  // the name of an argument that is null

    // Hochstetten sand (kPa) at p = 100 kPa, e = 0.70, h = 0: verification of the literature.
    static UmatCall hochstetten();
    // What an Abaqus-like host gets: that sand under stress, one call for each increment of strain.
    static UmatCall after(const std::array<double, 6>& stress,
                          const std::vector<std::array<double, 6>>& increments);

    // 11 22 33 12, or 11 22 33 alone: the rest of the arrays becomes out of bounds.
    void use_components(int n);
    void run();
    void run(UmatFunction function);
    // run() with a library that has said nothing yet: what it writes to stderr.
    std::string complaint();
    bool in_bounds() const;
    // PROPS(17): without it, NPROPS is 16 and what is behind is out of bounds.
    void set_tolerance(double tolerance);
    // PROPS(15), PROPS(18), PROPS(19), behind a tolerance of the default.
    void set_water(double K_w, double largest_tension, double itself);
    void set_dstran(double e11, double e22, double e33, double g12 = 0, double g13 = 0,
                    double g23 = 0);
    double tangent(int row, int column) const { return ddsdde[row + ntens * column]; }
    // Stress, state and tangent have the bits of other.
    bool same_results(const UmatCall& other) const;
    bool finite() const;
};
