// SPDX-License-Identifier: BSD-3-Clause
// Where the surfaces of the two bodies are, as seen from their nodes.
#include <algorithm>
#include <cmath>

#include "adapters/mpm/kernel/place.hpp"
#include "adapters/mpm/step/contact_pair.hpp"
#include "adapters/mpm/step/require.hpp"

namespace grit::mpm {

grit_contact_surfaces ContactPair::surfaces(std::vector<double>& of) {
    grit_contact_surfaces s{};
    s.struct_size = sizeof s;
    s.components = 2;
    s.nodes = static_cast<std::ptrdiff_t>(is_active.size());
    s.position = grit_view_of(position.data(), 2, 1);
    s.normal = grit_view_of(normal.data(), 2, 1);
    s.surface = grit_mutable_view_of(of.data(), 2, 1);
    return s;
}

// Whether x is no more than half a cell off the node, across the normal.
bool ContactPair::is_beside(const double* x, std::ptrdiff_t node) const {
    const double *at = &position[2 * node], *n = &normal[2 * node], *cell = &spacing[2 * node];
    const double across = n[0] * (x[1] - at[1]) - n[1] * (x[0] - at[0]);
    const double per_r = n[1] / cell[0], per_z = n[0] / cell[1];
    return across * across * (per_r * per_r + per_z * per_z) <= 0.25 + 1e-6;
}

// Adds the particles that have weight at an active node, and their corners beside one.
template <bool axi>
void ContactPair::measure(const GridView& grid, const ContactBody& body, int which) {
    const grit_contact_surfaces near = surfaces(near_surface);
    grit_contact_surfaces all = surfaces(surface);
    all.centre = grit_mutable_view_of(centre.data(), 2, 1);
    const std::ptrdiff_t n_r = grid.nodes_r();
    for (std::ptrdiff_t p = 0; p < body.count; ++p) {
        const std::ptrdiff_t cell =
            grid.z.cell_of(body.particles[column::z][p]) * std::ptrdiff_t{grid.r.cells} +
            grid.r.cell_of(body.particles[column::r][p]);
        if (!is_near[static_cast<std::size_t>(cell)]) continue;
        const auto place = baseline::place_of<axi>(grid, body.particles, p);
        const double x[2] = {place.r, place.z};
        const double side[4] = {place.domain.r1r, place.domain.r1z, place.domain.r2r,
                                place.domain.r2z};
        double corner[4][2];
        std::ptrdiff_t nodes[16], beside[16];
        int count = 0;
        for (int k = 0; k < 4; ++k) {
            const double e1 = k == 1 || k == 2 ? 1.0 : -1.0, e2 = k < 2 ? -1.0 : 1.0;
            const double r = corner[k][0] = x[0] + e1 * side[0] + e2 * side[2];
            const double z = corner[k][1] = x[1] + e1 * side[1] + e2 * side[3];
            const int i = grid.r.cell_of(r), j = grid.z.cell_of(z);
            // A corner on a grid line has no weight beyond it.
            const int last_i = r == grid.r.node[i] ? i : i + 1;
            const int last_j = z == grid.z.node[j] ? j : j + 1;
            for (int n_z = j; n_z <= last_j; ++n_z)
                for (int n = i; n <= last_i; ++n) {
                    const std::ptrdiff_t node = n_z * n_r + n;
                    if (is_active[static_cast<std::size_t>(node)]) nodes[count++] = node;
                }
        }
        for (const auto& at : corner) {
            const auto is_at = [&](std::ptrdiff_t node) { return is_beside(at, node); };
            const auto* end = std::copy_if(nodes, nodes + count, beside, is_at);
            add(near, which, at, nullptr, beside, static_cast<int>(end - beside));
        }
        add(all, which, x, side, nodes, count);
    }
}

// A parallelogram, or a point where side is null.
void ContactPair::add(const grit_contact_surfaces& to, int which, const double* x,
                      const double* side, const std::ptrdiff_t* nodes, int count) {
    if (count == 0) return;
    grit_contact_domains d{};
    d.struct_size = sizeof d;
    d.body = which;
    d.nodes_each = count;
    d.node = nodes;
    d.position = grit_view_of(x, 2, 1);
    if (side) {
        d.sides = 2;
        d.side = grit_matrix_view_of(side, 4, 2, 1);
    }
    grit_error error;
    require(grit_contact_surfaces_add(&to, 1, &d, &error), error, "contact");
}

// The surface beside a node, where a corner is, and not the nearest of all within a cell of it: on a
// curved surface that one is a cell off, and neighbouring nodes would wait for the same corner.
void ContactPair::find_surfaces(const GridView& grid, const ContactBody& a, const ContactBody& b,
                                Exchange& exchange) {
    grit_error error;
    grit_contact_surfaces all = surfaces(surface);
    all.centre = grit_mutable_view_of(centre.data(), 2, 1);
    const grit_contact_surfaces near = surfaces(near_surface);
    require(grit_contact_surfaces_reset(&all, &error), error, "contact");
    require(grit_contact_surfaces_reset(&near, &error), error, "contact");
    for (const int which : {0, 1})
        axisymmetric ? measure<true>(grid, which == 0 ? a : b, which)
                     : measure<false>(grid, which == 0 ? a : b, which);
    for (std::vector<double>* minima : {&surface, &near_surface, &centre})
        exchange.min_nodes(minima->data(), all.nodes, 2);
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (std::isfinite(near_surface[i])) surface[i] = near_surface[i];
}

}  // namespace grit::mpm
