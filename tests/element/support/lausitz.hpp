// SPDX-License-Identifier: BSD-3-Clause
// Lausitz sand [kPa, rad] and samples of it.
#pragma once

#include <element/grit_law.hpp>
#include <element/laboratory.hpp>
#include <element/simulate.hpp>

#include "../../catalogue.hpp"

namespace tests {

inline grit_sand_parameters sand_named(const char* name) { return catalogue_parameters(name, 1.0); }

inline grit_sand_parameters lausitz() { return sand_named("lausitz"); }

inline element::GritLaw lausitz_law(double tolerance = 1e-5, bool intergranular_strain = true) {
    element::GritLawOptions options;
    options.tolerance = tolerance;
    options.intergranular_strain = intergranular_strain;
    return element::GritLaw(lausitz(), options);
}

// Isotropic stress p [kPa], h as isotropic compression leaves it.
inline element::Sample isotropic_sample(const element::GritLaw& law, double p, double e,
                                        double rho = 1.0) {
    element::Sample sample;
    sample.point = law.start(-p * element::unit_tensor(), e);
    if (rho > 0.0) law.mobilise(sample.point, -element::unit_tensor(), rho);
    return sample;
}

}  // namespace tests
