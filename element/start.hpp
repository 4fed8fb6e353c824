// SPDX-License-Identifier: BSD-3-Clause
// A sample of Grit's sand before its test. Who tells no more than stress and void ratio gets the same
// sample in case files and in Python. Files of incrementalDriver give every state variable.
#pragma once

#include "element/grit_law.hpp"

namespace element {

enum class IntergranularStrain {
    off,       // basic hypoplasticity
    zero,      // h = 0: no memory
    mobilised  // h = rho R along a direction
};

struct Start {
    Vector6 stress = Vector6::Zero();  // effective
    double void_ratio = 0.0;           // e [-]
    IntergranularStrain intergranular_strain = IntergranularStrain::mobilised;
    // As isotropic compression leaves it.
    Vector6 direction = -unit_tensor();  // of h
    double rho = 1.0;                    // |h|/R [-]
    double pore_pressure = 0.0;          // of sands that have water [stress]
};

// What a sand starts with if nobody says otherwise: mobilised, off if it has no parameters for more.
IntergranularStrain usual_intergranular_strain(const grit_sand_parameters& parameters);

// At a mean pressure of the stress that is stored: p_t is added (H10).
struct VoidRatios {
    double densest, critical, loosest;  // e_d, e_c, e_i [-]
};
VoidRatios void_ratios(const grit_sand& sand, double mean_pressure);
// e there, from e_0 at zero pressure (H6).
double void_ratio_at_pressure(const grit_sand& sand, double e_0, double mean_pressure);

// Throws BadCase unless the stress presses and the void ratio is within its range.
MaterialPoint start_point(const GritLaw& law, const Start& start);

// Derivatives of that point by parameters of the law, given those of the start: stress and void ratio, where they depend
// on any (e.g. slopes_at_pressure), else by the void ratio alone. h = rho R along the direction.
struct StartSlopes {
    Matrix6X stress;                // no columns: of none
    Eigen::RowVectorXd void_ratio;  // no columns: 1 by_void_ratio, 0 by others
};
Slopes start_slopes(const GritLaw& law, const Start& start, const Directions& by,
                    const StartSlopes& given = {});

// Of void_ratio_at_pressure, with by_void_ratio standing for e_0.
Eigen::RowVectorXd slopes_at_pressure(const grit_sand& sand, double e_0, double mean_pressure,
                                      const Directions& by);

}  // namespace element
