// SPDX-License-Identifier: BSD-3-Clause
// PROPS of parameters.inp in the classic layout, for Grit's own sand: phi_c [deg], p_t, h_s, n, e_d0,
// e_c0, e_i0, alpha, beta, m_R, m_T, R, beta_r, chi, K_w, e_0 (docs/umat.md).
#pragma once

#include <filesystem>
#include <memory>

#include "element/grit_law.hpp"
#include "incremental_driver/parameters.hpp"

namespace incremental_driver {

struct ClassicSand {
    std::shared_ptr<const element::GritLaw> law;  // of the effective stress; IGS off if m_R <= 0.5
    double K_w = 0.0;                             // [stress] of the mixture (W1); 0: drained
    double e_0 = 0.0;                             // initial void ratio, see void_ratio_at
};

// Throws BadInput naming the file, the line and the place in PROPS. More than 16 are not read.
ClassicSand read_classic_props(const Parameters& parameters, const std::filesystem::path& path);

// The void ratio of a point that has none yet, at the effective pressure p [stress]:
//   e_0 > 10: e_0 - 10;  e_0 <= 10: e_0 at zero pressure, compressed by (H6) where p > 1e-3.
// Throws element::BadCase if e_0 is not positive.
double void_ratio_at(const ClassicSand& sand, double p);

}  // namespace incremental_driver
