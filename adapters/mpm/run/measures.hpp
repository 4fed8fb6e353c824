// SPDX-License-Identifier: BSD-3-Clause
// What a run looks at between steps. Forces and energies are per radian or per metre. Where processes share
// the grid each of them must ask, and gets what holds for all.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "adapters/mpm/case/case.hpp"
#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

// z of the lowest corner, or of the centre of mass [m].
double level_of(Simulation& simulation, std::size_t body, DepthOf what);
// Of the centre of mass [m/s].
Vector2 mean_velocity(Simulation& simulation, std::size_t body);
// Stored in a body, or taken by its stress [J]; 0 if it is rigid.
double stored_energy(Simulation& simulation, std::size_t body);

// Upward force of the bottom of the grid on all bodies in the last step [N]: what keeps its nodes from
// moving down, weight and all.
double base_reaction(const Simulation& simulation);

// The largest resultant on a node of a body, |m dv / dt|, as a share of the body's largest nodal force; of
// all bodies the largest share: one that falls is not at rest because a heavy one is.
// Local damping, a part of the resultant, makes it smaller. Not with MUSL, which maps twice.
double unbalanced_share(const Simulation& simulation, double dt);

// By contacts on a body in the last step [N]: across surfaces that face along z (a tip), along r
// (a shaft).
struct ContactForces {
    Vector2 tip{0.0, 0.0}, shaft{0.0, 0.0};
    double largest_gap;  // at a node of both bodies [m]; NaN: not measured
};
ContactForces contact_forces(const Simulation& simulation, std::size_t body);

// Of all bodies with pore water [Pa]; NaN: there are none.
struct Extremes {
    double least, largest;
};
// In the plane or in space.
template <class Simulated> Extremes pore_pressures(Simulated& simulation) {
    bool any = false;
    double largest[] = {-INFINITY, -INFINITY};  // of what is below zero, and above
    for (std::size_t i = 0; i < simulation.bodies(); ++i) {
        auto& body = simulation.body(i);
        if (!body.water) continue;
        any = true;
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            const double pressure = body.water->pressure(body.particles.view(), p);
            largest[0] = std::max(largest[0], -pressure);
            largest[1] = std::max(largest[1], pressure);
        }
    }
    if (!any) return {NAN, NAN};
    simulation.shared().max(largest, 2);
    return {-largest[0], largest[1]};
}
// Of all water that flows, per radian or per metre [kg]; NaN: none does.
double water_mass(Simulation& simulation);

// Each of its terms times a factor.
Energy times(const Energy& energy, double factor);
// The largest term of the balance so far, no less than least [J].
double turned_over(const Energy& energy, double least);

// In what energy is not conserved, by more than a limit: the residual as a share of what was turned over, or
// a loss that is a gain, which the residual does not show, as one of what came from outside and the start.
// Empty: within it.
std::string imbalance(const Energy& energy, double least, double limit);

}  // namespace grit::mpm
