// SPDX-License-Identifier: BSD-3-Clause
// States within the domain of the model: p > 0, tan psi < sqrt 2, e_d < e < e_i.
#pragma once

#include "support/operators.hpp"
#include "support/random.hpp"

namespace tests {

// Stress of mean pressure p with T_hat* = x n, n a unit deviator.
inline Vec stress_with(double p, double x, const Vec& n) {
    return -3.0 * p * (identity() / 3.0 + x * n);
}

inline double lode_factor(const Sand& sand, double x, const Vec& n) {
    return factors(sand, stress_with(100.0, x, n), 0.8).F;
}

// The smallest x > 0 where f changes sign, f(0) < 0, by bisection to the last bit.
template <class Function> double root_in(double low, double high, Function f) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

constexpr double cone = 0.8;  // |T_hat*| well below sqrt(2/3), where F is positive

// |T_hat*| of the critical state in the direction n: |T_hat*| = F/a.
inline double critical_obliquity(const Sand& sand, const Vec& n) {
    const double a = factors(sand, -100.0 * identity(), 0.8).a;
    return root_in(0.0, cone, [&](double x) { return x * a - lode_factor(sand, x, n); });
}

// e between e_d (0) and e_c (1) at pressure p.
inline double void_ratio_at(const Sand& sand, double p, double looseness) {
    const VoidRatios e = void_ratios(sand, p);
    return e.e_d + looseness * (e.e_c - e.e_d);
}

// rho in [0, 1]; 0 and 1 come up often.
inline Vec random_memory(const Sand& sand, Random& random) {
    const double rho = std::fmin(1.0, std::fmax(0.0, random.uniform(-0.2, 1.3)));
    return rho * sand.p.elastic_strain_radius * random.direction();
}

inline State random_state(const Sand& sand, Random& random, double p_low = 20.0,
                          double p_high = 500.0) {
    State x;
    const double p = random.log_uniform(p_low, p_high);
    const Vec n = deviator(random.direction()).normalized();
    x.T = stress_with(p, random.uniform(0.0, 0.9) * critical_obliquity(sand, n), n);
    x.h = random_memory(sand, random);
    x.e = void_ratio_at(sand, p, random.uniform(0.2, 1.1));
    return x;
}

}  // namespace tests
