// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace grit::mpm {

// Local damping of one component of a node, of mass m: what all forces, contact too, have changed since
// old is opposed by a share of it against the motion. without_contact: impulse of the other forces.
// Returns the work taken; contact has accounted for its own at the undamped v.
inline double damp(double& v, double old, double m, double without_contact, double damping) {
    if (old == 0.0) return 0.0;
    const double change = v - old, lag = damping * std::copysign(std::fabs(change), old);
    v -= lag;
    return lag * (0.5 * m * (old + v) + 0.5 * (m * change - without_contact));
}

}  // namespace grit::mpm
