// SPDX-License-Identifier: BSD-3-Clause
// Saturated elastic sand through which water flows, as the problems of Mandel and de Leeuw have it.
#pragma once

#include <adapters/mpm/case/case.hpp>

namespace mpm_test {

using namespace grit::mpm;

struct SaturatedElastic {
    static constexpr double E = 10e6, nu = 0.2, K_w = 2.2e9, n = 0.4;
    static constexpr double G = 0.5 * E / (1.0 + nu);
    static constexpr double M = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)), S = n / K_w;
    // Of the mean pressure in p' + b mean(p)' = c_v div grad p, where plates or edges share a constant load.
    static constexpr double b = G / ((M - G) * (1.0 + S * M));

    static double c_v(double conductivity) {
        return conductivity / (1000.0 * standard_gravity * (1.0 / M + S));
    }
    // A box from (0, 0).
    static BodyPlan box(double width, double height, double conductivity, bool implicit) {
        BodyPlan out{};
        out.name = "sand";
        out.outlines = {Outline{{{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}}};
        out.density = 1590.0;
        out.material = ElasticPlan{E, nu};
        out.water = WaterPlan{.drainage = Drainage::flow,
                              .bulk_modulus = K_w,
                              .grain_density = 2650.0,
                              .porosity = n,
                              .conductivity = conductivity,
                              .implicit = implicit};
        return out;
    }
    // Between two places where f has different signs.
    template <class Function> static double root(const Function& f, double low, double high) {
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (f(low) * f(middle) <= 0.0 ? high : low) = middle;
        }
        return low;
    }
};

}  // namespace mpm_test
