// SPDX-License-Identifier: BSD-3-Clause
#include "element/start.hpp"

#include <cmath>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {

IntergranularStrain usual_intergranular_strain(const grit_sand_parameters& parameters) {
    return std::isnan(parameters.elastic_strain_radius) ? IntergranularStrain::off
                                                        : IntergranularStrain::mobilised;
}

VoidRatioRange void_ratio_range(const grit_sand& sand, double mean_pressure) {
    double limits[3];  // e_i, e_c, e_d
    grit_sand_void_ratios(&sand, mean_pressure, limits);
    return {limits[2], limits[0]};
}

MaterialPoint start_point(const GritLaw& law, const Start& start) {
    MaterialPoint out = law.start(start.stress, start.void_ratio);
    const double p = -start.stress.head<3>().sum() / 3.0;
    if (!(p > 0.0))
        throw BadCase(text("the initial stress must press: tension is positive, and p = %g", p));
    const VoidRatioRange range = void_ratio_range(law.sand(), p);
    if (!(start.void_ratio >= range.lowest && start.void_ratio <= range.highest))
        throw BadCase(
            text("the void ratio must be in [e_d, e_i] = [%.4f, %.4f] at p = %g, got %.6g",
                 range.lowest, range.highest, p, start.void_ratio));
    if (start.intergranular_strain == IntergranularStrain::mobilised)
        law.mobilise(out, start.direction, start.rho);
    return out;
}

}  // namespace element
