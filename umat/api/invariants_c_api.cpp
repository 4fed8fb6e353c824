// SPDX-License-Identifier: BSD-3-Clause
// Output quantities and initial states.
#define GRIT_TARGET c_api
#include <cmath>
#include <cstddef>

#include <grit/sand_operators.h>

#include "support/versioned.hpp"
#include "umat/batch/point.hpp"
#include "umat/model/deviatoric_plane.hpp"

using namespace grit;
using namespace grit::c_api;

namespace {

bool prepared(const grit_sand* sand) { return sand && material_of(*sand).stamp == material_stamp; }

double void_ratio_scale(const Material& m, double p) {
    return p > 0.0 ? std::exp(-std::pow(m.three_over_hs * p, m.n)) : 1.0;  // (H6)
}

}  // namespace

extern "C" {

grit_status grit_sand_invariants_of(const grit_sand* sand, const double stress[6],
                                    const double* state, grit_sand_invariants* invariants) {
    if (!prepared(sand) || !stress || !state || !invariants || !are_finite(stress, 6) ||
        !are_finite(state, GRIT_SAND_STATE_SIZE))
        return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    const Tensor<double> T = stress_from_voigt(stress);
    grit_sand_invariants ours{};
    ours.p = trace(T) * (-1.0 / 3.0);
    const DeviatoricPlane plane = deviatoric_plane(deviator(T));
    ours.q = std::sqrt(1.5) * plane.length;
    ours.lode_angle = plane.lode_angle();
    const double shifted = ours.p + m.p_t;  // (H10)
    if (shifted > 0.0) {
        ours.tan_psi = plane.length / (std::sqrt(3.0) * shifted);
        // The largest and the smallest sum up to minus the middle one.
        const double sine = plane.largest_less_smallest() / (2.0 * shifted + plane.middle());
        ours.mobilised_friction_angle =
            sine < 1.0 && sine >= 0.0 ? std::asin(sine) : std::asin(1.0);
    }
    if (m.has_intergranular_strain != 0.0) ours.rho = norm(strain_from_voigt(state)) * m.inverse_R;
    if (invariants->struct_size > offsetof(grit_sand_invariants, relative_density)) {
        const double E = void_ratio_scale(m, std::fmax(shifted, 0.0));
        ours.relative_density =
            (m.e_c0 * E - state[GRIT_SAND_VOID_RATIO]) / ((m.e_c0 - m.e_d0) * E);
    }
    return write_versioned(ours, invariants) ? GRIT_OK : GRIT_BAD_CALL;
}

grit_status grit_sand_void_ratio_at_pressure(const grit_sand* sand, double e_0, double p,
                                             double* void_ratio) {
    if (!prepared(sand) || !void_ratio || !(e_0 > 0.0) || !(p >= 0.0) || !std::isfinite(e_0 + p))
        return GRIT_BAD_CALL;
    *void_ratio = e_0 * void_ratio_scale(material_of(*sand), p);
    return GRIT_OK;
}

grit_status grit_sand_stress_at_rest(const grit_sand* sand, double unit_weight, double depth,
                                     double surcharge, double K0, int axis, double stress[6]) {
    if (!prepared(sand) || !stress || axis < 0 || axis > 2) return GRIT_BAD_CALL;
    const double vertical = unit_weight * depth + surcharge;
    if (!(depth >= 0.0) || !(surcharge >= 0.0) || !(unit_weight >= 0.0) ||
        !std::isfinite(vertical) || !std::isfinite(K0))
        return GRIT_BAD_CALL;
    const double ratio = K0 < 0.0 ? 1.0 - std::sin(material_of(*sand).phi_c) : K0;
    for (int c = 0; c < 6; ++c) stress[c] = c == axis ? -vertical : c < 3 ? -ratio * vertical : 0.0;
    return GRIT_OK;
}

grit_status grit_sand_mobilise(const grit_sand* sand, const double direction[6], double rho,
                               double* state) {
    if (!prepared(sand) || !direction || !state || !(rho >= 0.0 && rho <= 1.0))
        return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    const Tensor<double> d = strain_from_voigt(direction);
    const double length = norm(d);
    if (!(length > 0.0) || !std::isfinite(length) || m.has_intergranular_strain == 0.0)
        return GRIT_BAD_CALL;
    strain_to_voigt(scaled(d, rho * m.R / length), state);
    return GRIT_OK;
}
}
