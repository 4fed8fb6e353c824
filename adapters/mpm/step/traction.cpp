// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/traction.hpp"

#include <cmath>

#include "adapters/mpm/grid/grid_point.hpp"
#include "adapters/mpm/kernel/place.hpp"

namespace grit::mpm {

EdgeForces edge_forces(const GridView& grid, const ParticleView& q, std::ptrdiff_t p, Edge edge,
                       Vector2 stress, const Settings& settings) {
    namespace c = column;
    constexpr double xi[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    constexpr double eta[4][2] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
    const auto e = static_cast<int>(edge);
    const auto place = settings.axisymmetric ? baseline::place_of<true>(grid, q, p)
                                             : baseline::place_of<false>(grid, q, p);
    const bool corners = settings.shape == Shape::cpdi || settings.shape == Shape::cpdi_published;
    EdgeForces out{};
    double r[2], z[2];
    for (int k = 0; k < 2; ++k) {
        const double a = xi[e][k], b = eta[e][k], l_r = q[c::l_r][p], l_z = q[c::l_z][p];
        r[k] = place.r + q[c::F_rr][p] * l_r * a + q[c::F_rz][p] * l_z * b;
        z[k] = place.z + q[c::F_zr][p] * l_r * a + q[c::F_zz][p] * l_z * b;
        const auto& d = place.domain;
        out.r[k] = place.r + (corners ? d.r1r * a + d.r2r * b : 0.0);
        out.z[k] = place.z + (corners ? d.r1z * a + d.r2z * b : 0.0);
    }
    const double l = std::hypot(r[1] - r[0], z[1] - z[0]);
    const double middle = 0.5 * (r[0] + r[1]), sixth = (r[1] - r[0]) / 6.0;
    for (int k = 0; k < 2; ++k) {
        const double width = settings.axisymmetric ? middle + (k == 0 ? -sixth : sixth) : 1.0;
        out.f_r[k] = 0.5 * l * width * stress[0];
        out.f_z[k] = 0.5 * l * width * stress[1];
    }
    return out;
}

void add_edge_forces(const GridView& grid, const EdgeForces& forces, double quantum,
                     Vector2* nodes) {
    const auto rounded = [quantum](double x) {
        return quantum > 0.0 ? std::nearbyint(x / quantum) * quantum : x;
    };
    for (int k = 0; k < 2; ++k) {
        const GridPoint corner = grid_point(grid, forces.r[k], forces.z[k]);
        for (int i = 0; i < 4; ++i) {
            nodes[corner.node[i]][0] += rounded(corner.N[i] * forces.f_r[k]);
            nodes[corner.node[i]][1] += rounded(corner.N[i] * forces.f_z[k]);
        }
    }
}

}  // namespace grit::mpm
