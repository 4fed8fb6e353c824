// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/surface_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adapters/mpm/space/kernel/place.hpp"
#include "adapters/mpm/space/step/grid_point.hpp"

namespace grit::mpm::space {
namespace {

constexpr std::size_t of_a_cell = 8;
constexpr std::size_t nodes_each = 4 * of_a_cell;  // of the middle of a face

}  // namespace

SurfaceLaw surface_law(double friction_coefficient) {
    SurfaceLaw law;
    grit_surface_options_init(&law.options, sizeof law.options);
    law.options.components = 3;
    law.options.friction_coefficient = friction_coefficient;
    return law;
}

SurfacePair::SurfacePair(const SurfaceLaw& law, Model& model) : pair_law(law), zone(model) {
    if (law.mesh_a.facets() > 0) mesh_a = RiddenMesh(law.mesh_a, model.shortest);
    double is_free[6] = {};
    for (std::size_t node = 0; node < model.nodes(); ++node)
        for (int side = 0; side < 6; ++side)
            if (zone.is_at_side(static_cast<std::ptrdiff_t>(node), side / 2, side % 2 == 1) &&
                !(model.fixed_nodes[node] & fixed::along(side / 2)))
                is_free[side] = 1.0;
    model.exchange.max(is_free, 6);
    for (int side = 0; side < 6; ++side) is_held[side] = is_free[side] == 0.0;
    forget();
}

// In a plane of symmetry a surface has no other one opposite.
void SurfacePair::leave_out_planes_of_symmetry(TriangleMesh& mesh) const {
    const GridView& grid = zone.whole_grid();
    mesh.leave_out([&](std::ptrdiff_t f) {
        bool lies_in_one = false;
        for (int side = 0; side < 6 && !lies_in_one; ++side) {
            if (!is_held[side]) continue;
            const AxisView& axis = grid.axis[side / 2];
            const int cell = side % 2 == 0 ? 0 : axis.cells - 1;
            const double at = axis.node[side % 2 == 0 ? 0 : axis.cells];
            lies_in_one = true;
            for (int k = 0; k < 3; ++k)
                lies_in_one =
                    lies_in_one &&
                    std::fabs(mesh.corner(f, k)[side / 2] - at) * axis.inverse[cell] < 1e-3;
        }
        return lies_in_one;
    });
}

void SurfacePair::forget() {
    step_totals = {};
    step_measured = {};
    step_measured.largest_gap = NAN;
    reports.clear();
    is_called = false;
}

void SurfacePair::find_mesh(int which) {
    TriangleMesh& mesh = skins[which].mesh;
    if (which == 0 && !mesh_a.empty()) mesh_a.place(zone.vertices_of_mesh(), mesh);
    else faces.find(zone.whole_grid(), zone.domains(which), mesh);
}

// Weights of the vertices at the nodes that the body has mass at. Facets whose vertices have none are left out.
void SurfacePair::find_nodes(int which, const Part& part) {
    Skin& skin = skins[which];
    const auto vertices = static_cast<std::size_t>(skin.mesh.vertices());
    skin.velocity.clear();
    if (part.body.rigid()) {
        for (std::size_t v = 0; v < vertices; ++v) {
            const Vector3 u =
                part.body.motion->velocity_at(skin.mesh.vertex(static_cast<std::ptrdiff_t>(v)));
            skin.velocity.insert(skin.velocity.end(), u.c, u.c + 3);
        }
        return;
    }
    const GridView& grid = zone.whole_grid();
    skin.node.assign(nodes_each * vertices, 0);
    skin.weight.assign(nodes_each * vertices, 0.0);
    skin.is_lost.resize(vertices);
    const std::size_t corners = vertices - skin.mesh.middle.size() / 4;
    for (std::size_t v = 0; v < corners; ++v) {
        Vector3 x = skin.mesh.vertex(static_cast<std::ptrdiff_t>(v));
        for (int d = 0; d < 3; ++d) {
            const AxisView& axis = grid.axis[d];
            x[d] = std::clamp(x[d], axis.node[0], axis.node[axis.cells]);
        }
        const GridPoint at = grid_point(grid, x);
        std::ptrdiff_t* node = &skin.node[nodes_each * v];
        double *weight = &skin.weight[nodes_each * v], sum = 0.0;
        for (std::size_t i = 0; i < of_a_cell; ++i) {
            const std::ptrdiff_t place = zone.place_of(which, at.node[i]);
            node[i] = std::max<std::ptrdiff_t>(place, 0);
            weight[i] = place < 0 ? 0.0 : std::clamp(at.N[i], 0.0, 1.0);
            sum += weight[i];
        }
        skin.is_lost[v] = !(sum > 1e-3);
        for (std::size_t i = 0; i < of_a_cell; ++i)
            weight[i] = skin.is_lost[v] ? 0.0 : weight[i] / sum;
    }
    for (std::size_t v = corners; v < vertices; ++v) {
        skin.is_lost[v] = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto corner = static_cast<std::size_t>(skin.mesh.middle[4 * (v - corners) + k]);
            skin.is_lost[v] |= skin.is_lost[corner];
            for (std::size_t i = 0; i < of_a_cell; ++i) {
                const std::size_t to = nodes_each * v + of_a_cell * k + i;
                skin.node[to] = skin.node[nodes_each * corner + i];
                skin.weight[to] = 0.25 * skin.weight[nodes_each * corner + i];
            }
        }
    }
    skin.mesh.leave_out([&skin](std::ptrdiff_t f) {
        const std::ptrdiff_t* corner = &skin.mesh.facet[3 * static_cast<std::size_t>(f)];
        return std::any_of(corner, corner + 3, [&skin](std::ptrdiff_t v) {
            return skin.is_lost[static_cast<std::size_t>(v)] != 0;
        });
    });
}

// Of the cells that the domains along the surface are in.
void SurfacePair::find_pressures(int which) {
    Skin& skin = skins[which];
    skin.pressure.clear();
    const std::vector<double>& of_domains = zone.pressures(which);
    if (of_domains.empty()) return;
    for (const std::ptrdiff_t domain : skin.mesh.domain)
        skin.pressure.push_back(of_domains[static_cast<std::size_t>(domain)]);
}

// By the cells along each facet of a, so that cells elsewhere do not matter.
void SurfacePair::find_spacing() {
    const GridView& grid = zone.whole_grid();
    const TriangleMesh& mesh = skins[0].mesh;
    double least = std::numeric_limits<double>::infinity();
    spacing.clear();
    for (std::ptrdiff_t f = 0; f < mesh.facets(); ++f) {
        const Vector3 x = mesh.corner(f, 0), u = mesh.corner(f, 1) - x, v = mesh.corner(f, 2) - x;
        const Vector3 area = baseline::cross(u, v), middle = x + (u + v) / 3.0;
        double along = 0.0, h[3];
        for (int d = 0; d < 3; ++d) {
            const AxisView& axis = grid.axis[d];
            h[d] = 1.0 / axis.inverse[axis.cell_of(middle[d])];
            least = std::min(least, h[d]);
        }
        const double square = dot(area, area);
        for (int d = 0; d < 3; ++d)
            along += 0.5 * h[d] * h[d] * (square > 0.0 ? 1.0 - area[d] * area[d] / square : 1.0);
        spacing.push_back(pair_law.spacing * std::sqrt(along));
    }
    pair_law.options.spacing = pair_law.spacing * least;
    pair_law.options.reach = least;
}

grit_surface SurfacePair::surface(int which, bool rigid) {
    Skin& skin = skins[which];
    grit_surface s{};
    s.struct_size = sizeof s;
    s.rigid = rigid;
    s.nodes_each = static_cast<int>(nodes_each);
    s.vertices = skin.mesh.vertices();
    s.facets = skin.mesh.facets();
    s.position = grit_view_of(skin.mesh.position.data(), 3, 1);
    s.facet = skin.mesh.facet.data();
    if (which == 0) s.spacing = spacing.data();
    if (rigid) {
        s.vertex_velocity = grit_view_of(skin.velocity.data(), 3, 1);
        return s;
    }
    s.node = skin.node.data();
    s.weight = skin.weight.data();
    s.nodes = static_cast<std::ptrdiff_t>(zone.nodes(which));
    double* values = zone.values(which);
    s.body = static_cast<int>(which == 0 ? pair_law.a : pair_law.b) + 1;
    s.number = zone.numbers(which);
    s.mass = grit_view_of(values + near_node::m, near_node::size, 1);
    s.fixed = zone.fixed(which);
    s.velocity = grit_mutable_view_of(values + near_node::v, near_node::size, 1);
    s.previous_velocity = grit_view_of(values + near_node::before, near_node::size, 1);
    if (!skin.pressure.empty()) s.pore_pressure = skin.pressure.data();
    return s;
}

// Forces of a facet at its middle.
void SurfacePair::add_up() {
    step_totals.dissipation = call_totals.dissipation_normal + call_totals.dissipation_tangential;
    for (int k = 0; k < 3; ++k) step_totals.impulse.along[k] = call_totals.impulse_on_b[k];
    const double dt = pair_law.options.time_step;
    const TriangleMesh& mesh = skins[0].mesh;
    for (std::ptrdiff_t f = 0; f < mesh.facets(); ++f) {
        const grit_surface_report& report = reports[static_cast<std::size_t>(f)];
        const Vector3 x = mesh.corner(f, 0), y = mesh.corner(f, 1), z = mesh.corner(f, 2);
        const Vector3 force{-report.force[0], -report.force[1], -report.force[2]};  // on b
        const Vector3 area = baseline::cross(y - x, z - x);
        const double size = norm(area);
        if (!(size > 0.0)) continue;
        step_totals.impulse.about =
            step_totals.impulse.about + baseline::cross((x + y + z) / 3.0, dt * force);
        const Vector3 n = area / size;
        if (std::fabs(n[2]) > std::hypot(n[0], n[1])) {
            step_measured.along_z = step_measured.along_z + force;
            continue;
        }
        const double bearing = report.normal_force * n[2];
        step_measured.along_z[2] += bearing;
        step_measured.sideways = step_measured.sideways + force - Vector3{0.0, 0.0, bearing};
    }
}

void SurfacePair::add_call(Model& model, const Water& water, SurfaceCalls& calls) {
    forget();
    Part &a = model.parts[pair_law.a], &b = model.parts[pair_law.b];
    Particles& of_a = a.body.particles;
    mesh_a.find_riders(of_a.view(), of_a.size(), of_a.ids(), model.exchange);
    double is_near = zone.find(a, b) ? 1.0 : 0.0;  // of any process
    model.exchange.max(&is_near, 1);
    if (is_near == 0.0) return;
    zone.gather(model, {&a, &b}, mesh_a,
                {water.pressures(pair_law.a), water.pressures(pair_law.b)});
    for (const int k : {0, 1}) {
        find_mesh(k);
        leave_out_planes_of_symmetry(skins[k].mesh);
        find_nodes(k, k == 0 ? a : b);
        if (skins[k].mesh.facets() == 0) return;
        find_pressures(k);
    }
    find_spacing();
    pair_law.options.time_step = model.dt;
    given[0] = surface(0, a.body.rigid());
    given[1] = surface(1, b.body.rigid());
    reports.resize(static_cast<std::size_t>(given[0].facets));
    call_totals = {};
    call_totals.struct_size = sizeof call_totals;
    calls.add({&pair_law.options, &given[0], &given[1], reports.data(), &call_totals});
    is_called = true;
}

void SurfacePair::take_call(Model& model) {
    swept.count(pair_law.options, call_totals);
    add_up();
    zone.write(0, model.parts[pair_law.a]);
    zone.write(1, model.parts[pair_law.b]);
}

Twist SurfacePair::impulse_on(std::size_t body, const Vector3& about) const {
    const double sign = body == pair_law.b ? 1.0 : -1.0;
    const Vector3 impulse = sign * step_totals.impulse.along;
    return {impulse, sign * step_totals.impulse.about - baseline::cross(about, impulse)};
}

}  // namespace grit::mpm::space
