// SPDX-License-Identifier: BSD-3-Clause
// One pass: a slave's vertices against a master's segments.
#pragma once

#include "contact/penalty/surface.hpp"
#include "contact/penalty/traction.hpp"

namespace grit::penalty {

struct Body {
    const grit_penalty_surface* surface;
    Line line;
};

struct Pass {
    Law law;
    double time_step;  // 0 without friction
    bool axisymmetric, validate_only;
};

// Sums of one pass, on the slave.
struct PassSums {
    Vector2 force{0.0, 0.0};
    double moment_on_slave = 0.0, moment_on_master = 0.0;
    double area = 0.0, normal_force = 0.0;
    double energy_normal = 0.0, energy_tangential = 0.0, dissipation = 0.0;
    double depth = 0.0;
    std::ptrdiff_t contacts = 0, slips = 0;
};

// Adds forces and stiffness of both bodies, replaces history and reports of the slave.
PassSums run_pass(const Pass& pass, const Body& slave, const Body& master);

}  // namespace grit::penalty
