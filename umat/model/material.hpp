// SPDX-License-Identifier: BSD-3-Clause
// What the opaque block of a prepared sand holds: parameters under the paper's symbols and the
// constants derived from them.
#pragma once

#include <cstdint>

#include <grit/sand.h>
#include <grit/version.h>

namespace grit {

// q of x^q, and 4 q where that is a small whole number, or -1.
struct Exponent {
    double value;
    std::int64_t quarters;
};

// Read where it lies, in an array of doubles: hence may_alias.
struct __attribute__((may_alias)) Material {
    std::uint64_t stamp;
    // parameters
    double phi_c, h_s, n, e_d0, e_c0, e_i0, alpha, beta, p_t;
    double m_R, m_T, R, beta_r, chi;
    double has_intergranular_strain;  // 1 or 0
    // derived
    double a;          // (H4)
    double stiffness;  // h_s/n (e_i0/e_c0)^beta / [3 + a^2 - sqrt 3 a (...)^alpha]   (H8)
    double three_over_hs;
    double inverse_e_range;  // 1/(e_c0 - e_d0)
    double inverse_e_i0;
    double inverse_R;
    Exponent alpha_power, beta_power;  // of (e - e_d)/(e_c - e_d) and e_c/e
    Exponent chi_power, beta_r_power, inverse_beta_r_power;
    double p_floor;  // below it the sand carries no stress: docs/adr/0002
};

// "GRIT", the major version, and the layout: before 1.0 that may change with any version.
constexpr std::uint64_t material_stamp =
    0x4752495400000000ULL + (std::uint64_t{GRIT_VERSION_MAJOR} << 24) +
    (std::uint64_t{GRIT_VERSION_MINOR} << 16) + sizeof(Material);

static_assert(sizeof(Material) <= sizeof(grit_sand));
static_assert(alignof(Material) <= alignof(grit_sand));

// docs/adr/0002-low-stress.md
constexpr double floor_per_hardness = 1e-8;  // p_floor / h_s
constexpr double opening_per_floor =
    2.0;                                 // a loaded point separates here, a closed one starts at 1
constexpr double cone_limit = 0.999;     // tan psi / sqrt 2 kept: F > 0 up to 1
constexpr double linear_density = 1e-4;  // below this (e-e_d)/(e_c-e_d), f_d is linear

inline const Material& material_of(const grit_sand& sand) {
    return *reinterpret_cast<const Material*>(sand.opaque);
}

}  // namespace grit
