// SPDX-License-Identifier: BSD-3-Clause
#include "element/start.hpp"

#include <cmath>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {
namespace {

double shifted(const grit_sand& sand, double mean_pressure) {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    grit_sand_parameters_of(&sand, &p);
    return mean_pressure + p.pressure_shift;
}

}  // namespace

IntergranularStrain usual_intergranular_strain(const grit_sand_parameters& parameters) {
    return std::isnan(parameters.elastic_strain_radius) ? IntergranularStrain::off
                                                        : IntergranularStrain::mobilised;
}

VoidRatios void_ratios(const grit_sand& sand, double mean_pressure) {
    double limits[3];  // e_i, e_c, e_d
    grit_sand_void_ratios(&sand, shifted(sand, mean_pressure), limits);
    return {limits[2], limits[1], limits[0]};
}

double void_ratio_at_pressure(const grit_sand& sand, double e_0, double mean_pressure) {
    double e = e_0;
    grit_sand_void_ratio_at_pressure(&sand, e_0, shifted(sand, mean_pressure), &e);
    return e;
}

MaterialPoint start_point(const GritLaw& law, const Start& start) {
    MaterialPoint out = law.start(start.stress, start.void_ratio, start.pore_pressure);
    const double p = -start.stress.head<3>().sum() / 3.0;
    if (!(p > 0.0))
        throw BadCase(text("the initial stress must press: tension is positive, and p = %g", p));
    const VoidRatios limits = void_ratios(law.sand(), p);
    if (!(start.void_ratio >= limits.densest && start.void_ratio <= limits.loosest))
        throw BadCase(
            text("the void ratio must be in [e_d, e_i] = [%.4f, %.4f] at p = %g, got %.6g",
                 limits.densest, limits.loosest, p, start.void_ratio));
    if (start.intergranular_strain == IntergranularStrain::mobilised)
        law.mobilise(out, start.direction, start.rho);
    return out;
}

}  // namespace element
