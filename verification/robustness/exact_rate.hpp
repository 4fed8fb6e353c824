// SPDX-License-Identifier: BSD-3-Clause
// The rate equations written down once more in long double, plainly, and integrated by Runge-Kutta-Fehlberg 7(8): what an
// update should give where the state stays within the domain of the model.
#pragma once

#include <optional>

#include <grit/sand.h>

namespace robustness {

// Stress and h after the strain, all [6] Voigt; basic: (H1) alone. Nothing where the path touches the border of the domain (p, the cone, e_d and
// e_i), or takes more than a bounded number of steps.
struct ExactEnd {
    double stress[6];
    double h[6];
    // |h| over R at the start or where the strain turns, if that is less; basic: 1. Near 0 it enters with powers of exponents
    // far below 1, and differences approach a derivative so slowly that two which agree may be far from it.
    double least_h;
};
std::optional<ExactEnd> exact_update(const grit_sand_parameters& sand, const double stress[6],
                                     const double state[GRIT_SAND_STATE_SIZE],
                                     const double strain[6], bool basic);

}  // namespace robustness
