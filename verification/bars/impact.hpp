// SPDX-License-Identifier: BSD-3-Clause
// Two equal bars that collide: E = rho = 1000, L = 1, cells of 0.05, each at 0.01. In theory they touch
// when the gap is closed, press on each other with rho c v for 2 L / c, and part with all their energy.
#pragma once

#include <vector>

#include "bars/line.hpp"

namespace bars {

struct Impact {
    double start_gap;    // between the faces at the first contact force [cells]
    double force;        // mean over the middle half of the contact / (rho c v) [-]
    double duration;     // first to last contact force / (2 L / c) [-]
    double impulse;      // of the contact / that of the elastic rebound [-]
    double energy;       // after / before [-]
    double most_energy;  // at any time / before [-]
    struct Sample {
        double time, force, gap;  // [L/c from the theoretical touch], [rho c v], [cells]
    };
    std::vector<Sample> history;
};

// offset: of both bars against the grid [cells].
Impact impact(const Contact& contact, double offset);

// Of a contact, as a multiple of E / cell [Pa/m].
double impact_stiffness(double multiple);

}  // namespace bars
