// SPDX-License-Identifier: BSD-3-Clause
// The rate equations written down once more in long double, plainly, and integrated by Runge-Kutta-Fehlberg 7(8): what an
// update should give where the state stays within the domain of the model.
#pragma once

#include <optional>

#include <grit/sand.h>

namespace robustness {

// Stress and h after the strain, all [6] Voigt; basic: (H1) alone. Nothing where the path touches the border of the domain (p, the cone, e_d and
// e_i), starts without memory, or takes more than a bounded number of steps.
struct ExactEnd {
    double stress[6];
    double h[6];
};
std::optional<ExactEnd> exact_update(const grit_sand_parameters& sand, const double stress[6],
                                     const double state[GRIT_SAND_STATE_SIZE],
                                     const double strain[6], bool basic);

}  // namespace robustness
