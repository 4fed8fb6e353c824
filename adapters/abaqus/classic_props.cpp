// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/classic_props.hpp"

#include <cmath>

#include <grit/sand_operators.h>

#include "adapters/abaqus/complaint.hpp"

namespace grit::abaqus {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double offset_of_true_void_ratio = 10.0;
constexpr double intergranular_strain_switch = 0.5;  // m_R at or below: off

}  // namespace

grit_status read_props(const double* props, ClassicProps& out, grit_error& error) {
    const double phi_c = props[0];
    if (!(phi_c >= 10.0 && phi_c <= 60.0))
        return failure(error, GRIT_BAD_PARAMETER,
                       "PROPS(1) (phi_c) must be in [10, 60] degrees, got %g%s", phi_c,
                       phi_c > 0.0 && phi_c < 1.1 ? ": radians?" : "");
    grit_sand_parameters& p = out.parameters;
    grit_sand_parameters_init(&p, sizeof p);
    p.critical_friction_angle = phi_c * degree;
    p.pressure_shift = props[1];
    p.granulate_hardness = props[2];
    p.stiffness_exponent = props[3];
    p.densest_void_ratio = props[4];
    p.critical_void_ratio = props[5];
    p.loosest_void_ratio = props[6];
    p.pyknotropy_exponent = props[7];
    p.stiffness_void_exponent = props[8];
    if (!(props[9] <= intergranular_strain_switch)) {  // NaN is for the library to refuse
        p.reversal_stiffness = props[9];
        p.transverse_stiffness = props[10];
        p.elastic_strain_radius = props[11];
        p.evolution_exponent = props[12];
        p.stiffness_interpolation_exponent = props[13];
    }
    out.K_w = props[14];
    out.e_0 = props[15];
    if (!(out.K_w >= 0.0 && std::isfinite(out.K_w)))
        return failure(error, GRIT_BAD_PARAMETER, "PROPS(15) (K_w) must be >= 0 and finite, got %g",
                       out.K_w);
    return GRIT_OK;
}

grit_status initial_void_ratio(const grit_sand& sand, double e_0, double p, double& void_ratio,
                               grit_error& error) {
    if (!(e_0 > 0.0 && std::isfinite(e_0)))
        return failure(error, GRIT_BAD_STATE,
                       "no void ratio: STATEV(7) is below 0.001 and PROPS(16) (e_0) is %g", e_0);
    if (e_0 > offset_of_true_void_ratio) {
        void_ratio = e_0 - offset_of_true_void_ratio;
        return GRIT_OK;
    }
    // The limit of 1e-3 in any unit of stress is part of the layout, not of the sand.
    if (p > 1e-3 && std::isfinite(p))
        return grit_sand_void_ratio_at_pressure(&sand, e_0, p, &void_ratio);
    void_ratio = e_0;
    return GRIT_OK;
}

}  // namespace grit::abaqus
