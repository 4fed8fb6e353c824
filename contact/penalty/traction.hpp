// SPDX-License-Identifier: BSD-3-Clause
// The law of one contact point, (S2) and (S3): a spring along the normal, a spring with a slider along
// the master's line.
#pragma once

#include <cmath>

namespace grit::penalty {

struct Law {
    double eps_n, eps_t;  // [stress / length]
    double mu;            // [-]
};

struct Traction {
    double t_n, t_t;  // [stress] on the master: against its normal, along its travel
    bool slips;
    double energy_n, energy_t;  // stored, per area
    double dissipation;         // of this increment, per area
};

// g < 0, the stored t_t, the increment of slip of the slave along the master's travel.
inline Traction traction(const Law& law, double g, double t_t_old, double dg_t) {
    Traction now{};
    now.t_n = -law.eps_n * g;                         // (S2)
    const double trial = t_t_old + law.eps_t * dg_t;  // (S3)
    const double limit = law.mu * now.t_n;
    now.slips = !(std::fabs(trial) <= limit) || limit == 0.0;
    now.t_t = now.slips ? std::copysign(limit, trial) : trial;
    now.energy_n = 0.5 * now.t_n * now.t_n / law.eps_n;
    now.energy_t = 0.5 * now.t_t * now.t_t / law.eps_t;
    now.dissipation = now.t_t * (trial - now.t_t) / law.eps_t;
    return now;
}

}  // namespace grit::penalty
