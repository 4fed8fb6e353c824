// SPDX-License-Identifier: BSD-3-Clause
// The constants of a material with their derivatives by parameters: those of (H4), (H8) as prepare() has them.
#pragma once

#include "umat/model/scalar_factors.hpp"

GRIT_KERNEL_BEGIN

// parameter(lane): of which the direction is.
template <class Number, class ParameterOf>
inline SensitiveMaterial<Number> differentiated(const Material& m, const ParameterOf& parameter) {
    using Directions = typename Number::Derivatives;
    const auto by = Directions::along([&](int lane) -> double { return parameter(lane); });
    const auto variable = [&](double x, int own) {
        const auto of_own = [&](const auto& of) {
            using Part = std::decay_t<decltype(of)>;
            return select(fabs(of - Part(static_cast<double>(own))) < Part(0.5), Part(1.0),
                          Part(0.0));
        };
        return Number(x, Directions::each([&](int i) { return of_own(by.part[i]); }));
    };
    const auto as_prepared = [](double x, const Number& with) { return Number(x, with.d); };
    const auto exponent = [&](const Exponent& q, const Number& with) {
        return SensitiveExponent<Number>{as_prepared(q.value, with), q.quarters};
    };
    constexpr double root_3 = 0x1.bb67ae8584caap+0;
    const Number phi_c = variable(m.phi_c, GRIT_SAND_CRITICAL_FRICTION_ANGLE),
                 h_s = variable(m.h_s, GRIT_SAND_GRANULATE_HARDNESS),
                 alpha = variable(m.alpha, GRIT_SAND_PYKNOTROPY_EXPONENT),
                 beta = variable(m.beta, GRIT_SAND_STIFFNESS_VOID_EXPONENT);
    SensitiveMaterial<Number> r;
    r.at = &m;
    r.n = variable(m.n, GRIT_SAND_STIFFNESS_EXPONENT);
    r.e_d0 = variable(m.e_d0, GRIT_SAND_DENSEST_VOID_RATIO);
    r.e_c0 = variable(m.e_c0, GRIT_SAND_CRITICAL_VOID_RATIO);
    r.e_i0 = variable(m.e_i0, GRIT_SAND_LOOSEST_VOID_RATIO);
    r.p_t = variable(m.p_t, GRIT_SAND_PRESSURE_SHIFT);
    r.m_R = variable(m.m_R, GRIT_SAND_REVERSAL_STIFFNESS);
    r.m_T = variable(m.m_T, GRIT_SAND_TRANSVERSE_STIFFNESS);
    r.R = variable(m.R, GRIT_SAND_ELASTIC_STRAIN_RADIUS);
    r.beta_r = variable(m.beta_r, GRIT_SAND_EVOLUTION_EXPONENT);
    r.chi = variable(m.chi, GRIT_SAND_STIFFNESS_INTERPOLATION_EXPONENT);
    // (H4) solved for the sine, which is what its derivative needs.
    const double sine = 3.0 * root_3 / (2.0 * root_2 * m.a + root_3);
    r.a = {m.a,
           phi_c.d * (-3.0 * root_3 / (2.0 * root_2) * sqrt(1.0 - sine * sine) / square(sine))};
    r.inverse_e_range = as_prepared(m.inverse_e_range, 1.0 / (r.e_c0 - r.e_d0));
    r.inverse_e_i0 = as_prepared(m.inverse_e_i0, 1.0 / r.e_i0);
    r.inverse_R = as_prepared(m.inverse_R, 1.0 / r.R);
    r.three_over_hs = as_prepared(m.three_over_hs, 3.0 / h_s);
    r.p_floor = as_prepared(m.p_floor, floor_per_hardness * h_s);
    // (H8): ln stiffness = ln h_s - ln n + beta ln(e_i0/e_c0) - ln bracket
    const Number looseness = exp(alpha * log((r.e_i0 - r.e_d0) * r.inverse_e_range));
    const Number bracket = 3.0 + r.a * r.a - root_3 * (r.a * looseness);
    const auto relative = [](const Number& x) { return x.d * (1.0 / x.v); };
    const double log_ratio = log(m.e_i0 / m.e_c0);
    r.stiffness = {m.stiffness,
                   (relative(h_s) - relative(r.n) + beta.d * log_ratio +
                    (relative(r.e_i0) - relative(r.e_c0)) * m.beta - relative(bracket)) *
                       m.stiffness};
    r.alpha_power = exponent(m.alpha_power, alpha);
    r.beta_power = exponent(m.beta_power, beta);
    r.chi_power = exponent(m.chi_power, r.chi);
    r.beta_r_power = exponent(m.beta_r_power, r.beta_r);
    r.inverse_beta_r_power = exponent(m.inverse_beta_r_power, 1.0 / r.beta_r);
    return r;
}

GRIT_KERNEL_END
