// SPDX-License-Identifier: BSD-3-Clause
// A point as the library takes it, from the host's arrays and back. This file and its source know
// Mandel's sqrt 2.
#pragma once

#include "adapters/mgis/generic_behaviour.hpp"
#include "adapters/mgis/material.hpp"

namespace grit::mgis {

struct Point {
    double strain_increment[6];
    double stress[6];  // effective
    double state[GRIT_SAND_STATE_SIZE];
    double total[6];       // stress after an update
    double pore_pressure;  // excess, compression positive [stress]
    double substep;
};

// Places of the scalars among the internal state variables, after the n components of h.
enum StateVariables {
    void_ratio_variable = 0,
    separation_variable = 1,
    pore_pressure_variable = 2,
    substep_variable = 3
};

// n components, 6 or 4: those a hypothesis does not have are zero. Stress T = Stress + p 1.
Point read_point(const mfront_gb_BehaviourData& call, int n, const Material& material);

// What has not changed since start keeps its bits.
void write_point(const mfront_gb_BehaviourData& call, int n, const Point& start, const Point& end);

// C [36] d stress / d strain (Voigt, row-major) as K [n x n].
void write_operator(const double C[36], int n, double* K);

}  // namespace grit::mgis
