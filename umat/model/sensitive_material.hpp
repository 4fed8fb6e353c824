// SPDX-License-Identifier: BSD-3-Clause
// The constants of a material for numbers with derivatives by its parameters, under the names that they have without.
// Decisions ask the material itself: plain(m).
#pragma once

#include <type_traits>

#include "support/dual.hpp"
#include "umat/model/material.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct SensitiveExponent {
    Real value;
    std::int64_t quarters;  // of the value
};

template <class Real> struct SensitiveMaterial {
    const Material* at;
    Real n, e_d0, e_c0, e_i0, p_t, m_R, m_T, R, beta_r, chi;
    Real a, stiffness, three_over_hs, inverse_e_range, inverse_e_i0, inverse_R, p_floor;
    SensitiveExponent<Real> alpha_power, beta_power;
    SensitiveExponent<Real> chi_power, beta_r_power, inverse_beta_r_power;
};

// Whether numbers of a type have derivatives by parameters.
template <class Real> constexpr bool is_sensitive = false;
template <class Real>
using MaterialOf = std::conditional_t<is_sensitive<Real>, SensitiveMaterial<Real>, Material>;

GRIT_INLINE const Material& plain(const Material& m) { return m; }
template <class Real> GRIT_INLINE const Material& plain(const SensitiveMaterial<Real>& m) {
    return *m.at;
}

// Numbers that nothing but h at the end depends on: tangents, of the stress, do without derivatives of these.
template <class Real> using OfMemory = std::conditional_t<is_sensitive<Real>, Real, PlainOf<Real>>;
template <class Real> GRIT_INLINE OfMemory<Real> of_memory(const Real& x) {
    if constexpr (is_sensitive<Real>) return x;
    else return value(x);
}

// Of a point and all the directions that are carried at once.
constexpr int sensitivity_lanes = 16;
using Sensitive = DualOf<double, Pack<native_lanes>, sensitivity_lanes / native_lanes>;
template <> constexpr bool is_sensitive<Sensitive> = true;

GRIT_KERNEL_END
