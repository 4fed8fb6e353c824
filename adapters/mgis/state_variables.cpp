// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mgis/state_variables.hpp"

namespace grit::mgis {
namespace {

constexpr double sqrt_2 = 1.4142135623730951;

double shear_factor(int component) { return component < 3 ? 1.0 : sqrt_2; }

double total(const Point& point, int component) {
    return point.total[component] * shear_factor(component);
}

}  // namespace

Point read_point(const mfront_gb_BehaviourData& call, int n, const Material& material) {
    Point p{};
    const double* variables = call.s0.internal_state_variables;
    const double* scalars = variables + n;
    p.pore_pressure = scalars[pore_pressure_variable];
    const double borne = grit_sand_water_borne(&material.water, p.pore_pressure);
    for (int c = 0; c < n; ++c) {
        const double factor = shear_factor(c);
        // Mandel's shear strain is the engineering one over sqrt 2, the stress sqrt 2 times Voigt's.
        p.strain_increment[c] = (call.s1.gradients[c] - call.s0.gradients[c]) * factor;
        p.stress[c] = c < 3 ? call.s0.thermodynamic_forces[c] + borne
                            : call.s0.thermodynamic_forces[c] / factor;
        p.state[c] = variables[c] * factor;
    }
    p.state[GRIT_SAND_VOID_RATIO] = scalars[void_ratio_variable];
    p.state[GRIT_SAND_SEPARATION] = scalars[separation_variable];
    p.substep = scalars[substep_variable];
    return p;
}

void write_point(const mfront_gb_BehaviourData& call, int n, const Point& start, const Point& end) {
    double* variables = call.s1.internal_state_variables;
    const bool same_water = end.pore_pressure == start.pore_pressure;
    for (int c = 0; c < n; ++c) {
        const bool same_stress = end.stress[c] == start.stress[c] && (c >= 3 || same_water);
        call.s1.thermodynamic_forces[c] =
            same_stress ? call.s0.thermodynamic_forces[c] : total(end, c);
        variables[c] = end.state[c] == start.state[c] ? call.s0.internal_state_variables[c]
                                                      : end.state[c] / shear_factor(c);
    }
    double* scalars = variables + n;
    scalars[void_ratio_variable] = end.state[GRIT_SAND_VOID_RATIO];
    scalars[separation_variable] = end.state[GRIT_SAND_SEPARATION];
    scalars[pore_pressure_variable] = end.pore_pressure;
    scalars[substep_variable] = end.substep;
}

void write_operator(const double C[36], int n, double* K) {
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) K[r * n + c] = C[6 * r + c] * shear_factor(r) * shear_factor(c);
}

}  // namespace grit::mgis
