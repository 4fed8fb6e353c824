// SPDX-License-Identifier: BSD-3-Clause
// Sands with parameters from their whole ranges.
#pragma once

#include "support/random.hpp"
#include "support/sands.hpp"

namespace tests {

inline constexpr const char* catalogue_names[] = {"lausitz", "hochstetten", "hostun",
                                                  "karlsruhe-fine", "hamburg-01"};

inline grit_sand_parameters random_catalogue_sand(Random& random) {
    return parameters_of(catalogue_names[static_cast<int>(random.uniform(0.0, 5.0))]);
}

// Intergranular strain over its whole ranges.
inline grit_sand_parameters random_intergranular_sand(Random& random) {
    grit_sand_parameters p = random_catalogue_sand(random);
    p.reversal_stiffness = random.log_uniform(1.0, 20.0);
    p.transverse_stiffness = random.log_uniform(1.0, p.reversal_stiffness);
    p.elastic_strain_radius = random.log_uniform(1e-6, 1e-2);
    p.evolution_exponent = random.log_uniform(0.01, 2.0);
    p.stiffness_interpolation_exponent = random.log_uniform(0.5, 20.0);
    return p;
}

// Everything else, too [kPa].
inline Sand random_sand(Random& random) {
    for (;;) {
        grit_sand_parameters p = random_intergranular_sand(random);
        p.critical_friction_angle = random.uniform(10.0, 60.0) * 0.017453292519943295;
        p.granulate_hardness = random.log_uniform(1e4, 1e8);
        p.stiffness_exponent = random.uniform(0.01, 0.99);
        p.densest_void_ratio = random.log_uniform(0.01, 5.0);
        p.critical_void_ratio = random.log_uniform(p.densest_void_ratio, 5.0);
        p.loosest_void_ratio = random.log_uniform(p.critical_void_ratio, 5.0);
        p.pyknotropy_exponent = random.log_uniform(0.001, 2.0);
        p.stiffness_void_exponent = random.uniform(0.0, 5.0);
        p.pressure_shift = random.uniform() < 0.5 ? 0.0 : random.log_uniform(0.01, 10.0);
        Sand sand{"random", p, {}};
        if (grit_sand_prepare(&p, &sand.prepared, nullptr) == GRIT_OK) return sand;
    }
}

}  // namespace tests
