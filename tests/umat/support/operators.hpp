// SPDX-License-Identifier: BSD-3-Clause
// The operators of grit/sand_operators.h on the tests' tensors.
#pragma once

#include <gtest/gtest.h>

#include "support/sands.hpp"
#include "support/tensors.hpp"

namespace tests {

struct State {
    Vec T = Vec::Zero();  // [stress]
    Vec h = Vec::Zero();
    double e = 0.0;
};

struct Rate {
    Vec T, h;
    double e;
};

struct VoidRatios {
    double e_i, e_c, e_d;
};

inline std::array<double, 8> state_array(const State& x) {
    const Voigt h = voigt_strain(x.h);
    return {h[0], h[1], h[2], h[3], h[4], h[5], x.e, 0.0};
}

enum class Intergranular { on, off };

inline Rate rate(const Sand& sand, const State& x, const Vec& D,
                 Intergranular igs = Intergranular::on) {
    double T_rate[6], state_rate[8];
    const grit_status status =
        grit_sand_rate(sand, igs == Intergranular::off, voigt_stress(x.T).data(),
                       state_array(x).data(), voigt_strain(D).data(), T_rate, state_rate);
    EXPECT_EQ(status, GRIT_OK);
    return {stress_from(T_rate), strain_from(state_rate), state_rate[GRIT_SAND_VOID_RATIO]};
}

inline Rate basic_rate(const Sand& sand, const State& x, const Vec& D) {
    return rate(sand, x, D, Intergranular::off);
}

inline Mat stiffness_L(const Sand& sand, const Vec& T, double e) {
    double L[36];
    EXPECT_EQ(grit_sand_stiffness(sand, voigt_stress(T).data(), e, L, nullptr), GRIT_OK);
    return stiffness_from(L);
}

inline Vec stiffness_N(const Sand& sand, const Vec& T, double e) {
    double N[6];
    EXPECT_EQ(grit_sand_stiffness(sand, voigt_stress(T).data(), e, nullptr, N), GRIT_OK);
    return stress_from(N);
}

inline Mat stiffness_M(const Sand& sand, const State& x, const Vec& D) {
    double M[36];
    EXPECT_EQ(grit_sand_intergranular_stiffness(sand, voigt_stress(x.T).data(),
                                                state_array(x).data(), voigt_strain(D).data(), M),
              GRIT_OK);
    return stiffness_from(M);
}

inline grit_sand_scalar_factors factors(const Sand& sand, const Vec& T, double e) {
    grit_sand_scalar_factors f{};
    f.struct_size = sizeof f;
    EXPECT_EQ(grit_sand_factors(sand, voigt_stress(T).data(), e, &f), GRIT_OK);
    return f;
}

inline VoidRatios void_ratios(const Sand& sand, double p) {
    double e[3];
    EXPECT_EQ(grit_sand_void_ratios(sand, p, e), GRIT_OK);
    return {e[0], e[1], e[2]};
}

}  // namespace tests
