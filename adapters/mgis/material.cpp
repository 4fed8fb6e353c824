// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mgis/material.hpp"

#include <grit/classic_layout.h>

#include <cmath>

#include "adapters/host/failure.hpp"

namespace grit::mgis {

grit_status read_material(const double* properties, const Parameters& set, Material& out,
                          grit_error& error) {
    const double phi_c = properties[0];
    const grit_sand_parameter_info& known = *grit_sand_parameter_describe(0);
    const double angle = phi_c * GRIT_DEGREE;
    if (!(angle >= known.lowest && angle <= known.highest))
        return failure(error, GRIT_BAD_PARAMETER,
                       "CriticalFrictionAngle must be in [%g, %g] degrees, got %g%s",
                       known.lowest / GRIT_DEGREE, known.highest / GRIT_DEGREE, phi_c,
                       phi_c > 0.0 && phi_c < 1.1 ? ": radians?" : "");
    const double K_w = properties[GRIT_CLASSIC_WATER_STIFFNESS];
    int bad = 0;
    if (grit_classic_water(K_w, set.largest_water_tension, set.water_itself, &out.water, &bad))
        return failure(error, GRIT_BAD_PARAMETER,
                       "WaterStiffness must be >= 0 and finite, in the unit of stress, got %g",
                       K_w);
    out.e_0 = properties[GRIT_CLASSIC_VOID_RATIO_AT_ZERO_PRESSURE];
    grit_sand_parameters parameters;
    grit_classic_parameters(properties, &parameters);
    const double m_R = parameters.reversal_stiffness;
    out.elastic_factor = std::isnan(m_R) ? 1.0 : m_R;
    return grit_sand_prepare(&parameters, &out.sand, &error);
}

grit_status complete_void_ratio(const Material& material, double p, double& void_ratio,
                                grit_error& error) {
    if (!(void_ratio < GRIT_CLASSIC_NO_VOID_RATIO)) return GRIT_OK;
    const grit_status status =
        grit_classic_void_ratio(&material.sand, material.e_0, p, &void_ratio);
    if (status != GRIT_BAD_STATE) return status;
    return failure(error, status,
                   "no void ratio: VoidRatio is below 0.001 and InitialVoidRatio is %g",
                   material.e_0);
}

}  // namespace grit::mgis
