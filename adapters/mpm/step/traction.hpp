// SPDX-License-Identifier: BSD-3-Clause
// Loads on the edges of particles.
#pragma once

#include <functional>
#include <vector>

#include "adapters/mpm/grid/grid_point.hpp"
#include "adapters/mpm/kernel/call.hpp"
#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

// An edge by its place in the undeformed particle.
enum class Edge { bottom, right, top, left };

struct Traction {
    std::size_t body;
    int particle;  // id
    Edge edge;
    std::function<Vector2(double)> stress;  // force per deformed area [Pa] over time [s]
    bool on_mixture = false;                // grains and water by their shares, or the grains alone
};

// The forces of a traction at the two ends of its edge, and where they act: as the particle's weights see
// it, so that they meet mass. With shape functions that know no corners, at its centre.
struct EdgeForces {
    double r[2], z[2];      // [m]
    double f_r[2], f_z[2];  // [N], per radian or per metre
};

// A linear edge, weighted with r in axisymmetry: each end has l/2 (r_mid -+ (r_d - r_c)/6) of it.
EdgeForces edge_forces(const GridView& grid, const ParticleView& particles, std::ptrdiff_t p,
                       Edge edge, Vector2 stress, const Settings& settings);

// With a quantum, a power of two, contributions are rounded to multiples of it: their sums are exact, and no
// order changes a bit.
void add_edge_forces(const GridView& grid, const EdgeForces& forces, double quantum,
                     Vector2* nodes);
// Work of a step [J]; twice(node, k) is the sum of the velocities before and after, along r (0) or z (1).
template <class Twice>
double edge_work(const GridView& grid, const EdgeForces& forces, double dt, const Twice& twice) {
    double work = 0.0;
    for (int k = 0; k < 2; ++k) {
        const GridPoint corner = grid_point(grid, forces.r[k], forces.z[k]);
        for (int i = 0; i < 4; ++i) {
            const auto node = static_cast<std::size_t>(corner.node[i]);
            work += 0.5 * dt * corner.N[i] *
                    (forces.f_r[k] * twice(node, 0) + forces.f_z[k] * twice(node, 1));
        }
    }
    return work;
}

}  // namespace grit::mpm
