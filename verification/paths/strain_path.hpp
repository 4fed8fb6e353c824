// SPDX-License-Identifier: BSD-3-Clause
// Whole paths of one material point, driven by strain call by call, and how far their stress is off the
// exact one: what the default tolerance is chosen by (docs/adr/0009).
#pragma once

#include <array>
#include <string>
#include <vector>

#include <grit/grit.h>

namespace paths {

using Six = std::array<double, 6>;

struct StrainPath {
    std::string kind;  // a laboratory test, or the file of a reference curve
    std::string sand_name;
    grit_sand sand;
    int intergranular_off;
    double opening_pressure;
    Six stress;  // at the start
    std::array<double, GRIT_SAND_STATE_SIZE> state;
    std::vector<Six> increments;
};

// Stresses after each call, and what they took. Throws where a call fails.
struct Course {
    std::vector<Six> stress;
    long evaluations = 0;
};
Course run(const StrainPath& path, double tolerance);

// What a path is compared to: the same calls at this tolerance.
constexpr double exact_tolerance = 1e-10;

// The stress vanishes on the way: what follows depends on the call in which that is.
bool opens(const Course& course);

// The largest error of the stress on the way over the largest stress on the way.
double error(const StrainPath& path, const Course& course, const Course& exact);

// Where points open, 2e-8 h_s.
double opening_pressure(const grit_sand& sand);

// Laboratory tests of every sand of the catalogue that has h, and of those with h switched off: oedometer and
// isotropic compression with unloading and reloading, undrained, drained, simple shear, cycles of three sizes, and many
// within R. In about so many calls: of the many cycles, 50, or as many as that takes with a call for each half.
std::vector<StrainPath> laboratory_paths(int calls);

// Of the same kinds, from any void ratio between e_d and e_c, 2 to 1000 kPa and memory, 0.2 to 2 times as far but for
// the many cycles, which stay within R, in 30 to 1000 calls.
std::vector<StrainPath> random_paths(int count, unsigned seed);

// The strains of every curve in a folder of reference curves: in its own rows (calls = 0), or in so many straight
// pieces of as many rows each, also of a part of one.
std::vector<StrainPath> reference_paths(const std::string& folder, int calls);

}  // namespace paths
