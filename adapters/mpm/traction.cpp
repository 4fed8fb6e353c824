// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/traction.hpp"

#include <cmath>

#include "adapters/mpm/grid_point.hpp"

namespace grit::mpm {
EdgeForces edge_forces(const ParticleView& q, std::ptrdiff_t p, Edge edge, Vector stress,
                       bool axisymmetric) {
    namespace c = column;
    constexpr double xi[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    constexpr double eta[4][2] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
    const auto e = static_cast<int>(edge);
    EdgeForces out{};
    for (int k = 0; k < 2; ++k) {
        const double a = xi[e][k] * q[c::l_r][p], b = eta[e][k] * q[c::l_z][p];
        out.r[k] = q[c::r][p] + q[c::F_rr][p] * a + q[c::F_rz][p] * b;
        out.z[k] = q[c::z][p] + q[c::F_zr][p] * a + q[c::F_zz][p] * b;
    }
    const double l = std::hypot(out.r[1] - out.r[0], out.z[1] - out.z[0]);
    const double middle = 0.5 * (out.r[0] + out.r[1]), sixth = (out.r[1] - out.r[0]) / 6.0;
    for (int k = 0; k < 2; ++k) {
        const double width = axisymmetric ? middle + (k == 0 ? -sixth : sixth) : 1.0;
        out.f_r[k] = 0.5 * l * width * stress.r;
        out.f_z[k] = 0.5 * l * width * stress.z;
    }
    return out;
}

void add_edge_forces(const GridView& grid, const EdgeForces& forces, NodeRecord* nodes) {
    for (int k = 0; k < 2; ++k) {
        const GridPoint corner = grid_point(grid, forces.r[k], forces.z[k]);
        for (int i = 0; i < 4; ++i) {
            nodes[corner.node[i]][record::f_r] += corner.N[i] * forces.f_r[k];
            nodes[corner.node[i]][record::f_z] += corner.N[i] * forces.f_z[k];
        }
    }
}

double edge_work(const GridView& grid, const EdgeForces& forces, const NodeMotion* motions,
                 double dt) {
    double work = 0.0;
    for (int k = 0; k < 2; ++k) {
        const GridPoint corner = grid_point(grid, forces.r[k], forces.z[k]);
        for (int i = 0; i < 4; ++i) {
            const NodeMotion& v = motions[corner.node[i]];
            work += 0.5 * dt * corner.N[i] *
                    (forces.f_r[k] * (v[motion::v_r] + v[motion::other_r]) +
                     forces.f_z[k] * (v[motion::v_z] + v[motion::other_z]));
        }
    }
    return work;
}

}  // namespace grit::mpm
