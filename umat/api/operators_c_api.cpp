// SPDX-License-Identifier: BSD-3-Clause
// The elementary operators at the C border: notation in, one kernel function, notation out.
#define GRIT_TARGET c_api
#include <cmath>
#include <cstring>

#include <grit/sand_operators.h>

#include "support/versioned.hpp"
#include "umat/batch/low_stress.hpp"
#include "umat/model/dense_operators.hpp"
#include "umat/model/wave_modulus.hpp"

using namespace grit;
using namespace grit::c_api;

namespace {

bool prepared(const grit_sand* sand) { return sand && material_of(*sand).stamp == material_stamp; }

// The stress the model is evaluated at.
Tensor<double> stress_in_domain(const Material& m, const double stress[6]) {
    return stress_in_domain(m, stress_from_voigt(stress));
}

bool usable(const grit_sand* sand, const double* stress, double void_ratio) {
    return prepared(sand) && stress && are_finite(stress, 6) && void_ratio > 0.0 &&
           void_ratio <= largest_void_ratio;
}

bool usable_state(const grit_sand* sand, const double* stress, const double* state) {
    return state && are_finite(state, GRIT_SAND_STATE_SIZE) &&
           usable(sand, stress, state[GRIT_SAND_VOID_RATIO]);
}

// h as an update takes it; false where none does.
bool read_h(const Material& m, const double* state, Tensor<double>& h) {
    h = strain_from_voigt(state);
    if (!(norm(h) <= tolerated_h_excess * m.R)) return false;
    back_to_R(m, h);
    return true;
}

void matrix_to_voigt(const Matrix& M, double* out) {
    for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c) out[6 * r + c] = M.c[r][c] * stiffness_to_voigt(r, c);
}

}  // namespace

extern "C" {

grit_status grit_sand_void_ratios(const grit_sand* sand, double p, double void_ratios[3]) {
    if (!prepared(sand) || !void_ratios || !(p >= 0.0) || !std::isfinite(p)) return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    const double E = p > 0.0 ? std::exp(-std::pow(m.three_over_hs * p, m.n)) : 1.0;  // (H6)
    void_ratios[0] = m.e_i0 * E;
    void_ratios[1] = m.e_c0 * E;
    void_ratios[2] = m.e_d0 * E;
    return GRIT_OK;
}

grit_status grit_sand_factors(const grit_sand* sand, const double stress[6], double void_ratio,
                              grit_sand_scalar_factors* factors) {
    if (!usable(sand, stress, void_ratio) || !factors) return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    const Tensor<double> T = stress_in_domain(m, stress);
    const PointFactors k = point_factors(m, T, void_ratio);
    const double p = trace(T) * (-1.0 / 3.0);
    const Compression<double> limit = compression(m, p);
    const double e_0 = min(max(void_ratio * limit.expansion, m.e_d0), m.e_i0);
    grit_sand_scalar_factors ours{};
    ours.a = m.a;
    ours.F = k.shape.F;
    ours.f_d = k.f.f_d;
    ours.f_e = std::pow(m.e_c0 / e_0, m.beta);  // (H7)
    ours.f_b = k.f.f_s / ours.f_e;
    ours.f_s = k.f.f_s;
    return write_versioned(ours, factors) ? GRIT_OK : GRIT_BAD_CALL;
}

grit_status grit_sand_stiffness(const grit_sand* sand, const double stress[6], double void_ratio,
                                double* L, double* N) {
    if (!usable(sand, stress, void_ratio)) return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    const PointFactors k = point_factors(m, stress_in_domain(m, stress), void_ratio);
    if (L) matrix_to_voigt(dense_L(m, k, 1.0), L);
    if (N) stress_to_voigt(dense_N(m, k), N);
    return GRIT_OK;
}

grit_status grit_sand_intergranular_stiffness(const grit_sand* sand, const double stress[6],
                                              const double* state, const double D[6],
                                              double M[36]) {
    if (!usable_state(sand, stress, state) || !D || !are_finite(D, 6) || !M ||
        material_of(*sand).has_intergranular_strain == 0.0)
        return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    Tensor<double> h;
    if (!read_h(m, state, h)) return GRIT_BAD_CALL;
    const PointFactors k =
        point_factors(m, stress_in_domain(m, stress), state[GRIT_SAND_VOID_RATIO]);
    matrix_to_voigt(intergranular_M(m, k, h, strain_from_voigt(D)), M);
    return GRIT_OK;
}

grit_status grit_sand_rate(const grit_sand* sand, int intergranular_off, const double stress[6],
                           const double* state, const double D[6], double stress_rate[6],
                           double* state_rate) {
    if (!usable_state(sand, stress, state) || !D || !are_finite(D, 6) || !stress_rate)
        return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    const bool igs = m.has_intergranular_strain != 0.0 && !intergranular_off;
    Tensor<double> h_now = isotropic(0.0);
    if (igs && !read_h(m, state, h_now)) return GRIT_BAD_CALL;
    const Tensor<double> rate_of_strain = strain_from_voigt(D);
    double speed = 0.0;  // largest component first: D may be of any size
    for (const double component : rate_of_strain.c) speed = std::fmax(speed, std::fabs(component));
    Tensor<double> T_rate = isotropic(0.0);
    Tensor<double> h_rate = isotropic(0.0);
    if (speed > 0.0) {
        const Tensor<double> T = stress_in_domain(m, stress);
        const Tensor<double> direction = scaled(rate_of_strain, 1.0 / speed);
        speed *= norm(direction);
        const auto path = straight_path(m, direction, h_now, state[GRIT_SAND_VOID_RATIO]);
        Course<double> course = first_course(m, path);
        if (path.u_0 == 0.0) course.loading = false;
        const Mobilisation<double> h = mobilisation_at_start(m, course);
        const Waypoint<double> at =
            igs ? waypoint(m, course.loading, h, path.e_0) : basic_waypoint(m, path.e_0);
        const auto rate = igs ? course_rate<double, true>(m, path, at, marched(m, T))
                              : course_rate<double, false>(m, path, at, marched(m, T));
        T_rate = scaled(rate.T, speed / at.ds);
        if (igs) {
            // (G3): D less what is saturated along h
            const double kept = course.loading ? h.rho_beta * h.c : 0.0;
            const Tensor<double> h_hat = scaled_sum(h.c, path.D_hat, scaled(path.tau, h.across));
            h_rate = scaled(scaled_sum(-kept, h_hat, path.D_hat), speed);
        }
    }
    stress_to_voigt(T_rate, stress_rate);
    if (state_rate) {
        strain_to_voigt(h_rate, state_rate);
        state_rate[GRIT_SAND_VOID_RATIO] =
            (1.0 + state[GRIT_SAND_VOID_RATIO]) * trace(rate_of_strain);  // (H9)
        state_rate[GRIT_SAND_SEPARATION] = 0.0;
    }
    return GRIT_OK;
}

grit_status grit_sand_wave_modulus(const grit_sand* sand, int intergranular_off,
                                   const double stress[6], double void_ratio, double* modulus) {
    if (!usable(sand, stress, void_ratio) || !modulus) return GRIT_BAD_CALL;
    const Material& m = material_of(*sand);
    const bool igs = m.has_intergranular_strain != 0.0 && !intergranular_off;
    *modulus = wave_modulus(m, igs, stress_in_domain(m, stress), void_ratio);
    return GRIT_OK;
}

grit_status grit_sand_rotate(const double Q[9], double* stress, double* state) {
    if (!Q || !are_finite(Q, 9) || !is_rotation(Q, false)) return GRIT_BAD_CALL;
    if (stress) stress_to_voigt(rotated(Q, stress_from_voigt(stress)), stress);
    if (state) strain_to_voigt(rotated(Q, strain_from_voigt(state)), state);
    return GRIT_OK;
}
}
