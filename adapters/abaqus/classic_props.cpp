// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/classic_props.hpp"

#include <cmath>

#include "adapters/abaqus/complaint.hpp"

namespace grit::abaqus {

grit_status read_props(const double* props, ClassicProps& out, grit_error& error) {
    const double phi_c = props[0];
    if (!(phi_c >= 10.0 && phi_c <= 60.0))
        return failure(error, GRIT_BAD_PARAMETER,
                       "PROPS(1) (phi_c) must be in [10, 60] degrees, got %g%s", phi_c,
                       phi_c > 0.0 && phi_c < 1.1 ? ": radians?" : "");
    grit_classic_parameters(props, &out.parameters);
    out.K_w = props[GRIT_CLASSIC_WATER_STIFFNESS];
    out.e_0 = props[GRIT_CLASSIC_VOID_RATIO_AT_ZERO_PRESSURE];
    if (!(out.K_w >= 0.0 && std::isfinite(out.K_w)))
        return failure(error, GRIT_BAD_PARAMETER, "PROPS(15) (K_w) must be >= 0 and finite, got %g",
                       out.K_w);
    return GRIT_OK;
}

grit_status initial_void_ratio(const grit_sand& sand, double e_0, double p, double& void_ratio,
                               grit_error& error) {
    const grit_status status = grit_classic_void_ratio(&sand, e_0, p, &void_ratio);
    if (status != GRIT_BAD_STATE) return status;
    return failure(error, status,
                   "no void ratio: STATEV(7) is below 0.001 and PROPS(16) (e_0) is %g", e_0);
}

}  // namespace grit::abaqus
