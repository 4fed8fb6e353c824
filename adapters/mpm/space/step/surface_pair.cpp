// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/surface_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adapters/mpm/space/kernel/place.hpp"
#include "adapters/mpm/space/step/grid_point.hpp"
#include "adapters/mpm/step/require.hpp"

namespace grit::mpm::space {
namespace {

constexpr std::size_t of_a_cell = 8;
constexpr std::size_t nodes_each = 4 * of_a_cell;  // of the middle of a face
namespace number {
enum : std::size_t { m, v, before = 4, size = 8 };
}

}  // namespace

SurfaceLaw surface_law(double friction_coefficient) {
    SurfaceLaw law;
    grit_surface_options_init(&law.options, sizeof law.options);
    law.options.components = 3;
    law.options.friction_coefficient = friction_coefficient;
    return law;
}

SurfacePair::SurfacePair(const SurfaceLaw& law, Model& model)
    : pair_law(law), near(model.cells()), faces(model.cells()) {
    Particles& of_a = model.parts[law.a].body.particles;
    if (law.mesh_a.facets() > 0)
        mesh_a = RiddenMesh(law.mesh_a, model.shortest, of_a.view(), of_a.size(), of_a.ids());
    for (int side = 0; side < 6; ++side) is_held[side] = holds(model, side / 2, side % 2 == 1);
    forget();
}

// Whether a side of the grid holds all of its nodes across.
bool SurfacePair::holds(const Model& model, int direction, bool last) {
    const GridView grid = model.grid();
    const std::ptrdiff_t wanted = last ? grid.axis[direction].cells : 0;
    for (std::size_t node = 0; node < model.nodes(); ++node) {
        const std::ptrdiff_t i =
            static_cast<std::ptrdiff_t>(node) / grid.step(direction) % grid.nodes(direction);
        if (i == wanted && !(model.fixed_nodes[node] & fixed::along(direction))) return false;
    }
    return true;
}

// In a plane of symmetry a surface has no other one opposite.
void SurfacePair::leave_out_planes_of_symmetry(TriangleMesh& mesh, const GridView& grid) const {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < mesh.facet.size(); f += 3) {
        bool lies_in_one = false;
        for (int side = 0; side < 6 && !lies_in_one; ++side) {
            if (!is_held[side]) continue;
            const AxisView& axis = grid.axis[side / 2];
            const int cell = side % 2 == 0 ? 0 : axis.cells - 1;
            const double at = axis.node[side % 2 == 0 ? 0 : axis.cells];
            lies_in_one = true;
            for (std::size_t k = 0; k < 3; ++k)
                lies_in_one =
                    lies_in_one &&
                    std::fabs(mesh.vertex(mesh.facet[f + k])[side / 2] - at) * axis.inverse[cell] <
                        1e-3;
        }
        if (lies_in_one) continue;
        std::copy_n(mesh.facet.begin() + static_cast<std::ptrdiff_t>(f), 3,
                    mesh.facet.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += 3;
    }
    mesh.facet.resize(kept);
}

void SurfacePair::forget() {
    step_totals = {};
    step_measured = {};
    step_measured.largest_gap = NAN;
    reports.clear();
}

// In the order of ids, however particles are sorted.
void SurfacePair::find_mesh(int which, Part& part, const GridView& grid) {
    Particles& particles = part.body.particles;
    const ParticleView q = particles.view();
    TriangleMesh& mesh = skins[which].mesh;
    const auto is_near = [&](std::ptrdiff_t p) { return near.has(grid.cell_of(q.position(p))); };
    if (which == 0 && !mesh_a.empty())
        return mesh_a.place(
            q,
            [&](int id) {
                const std::ptrdiff_t p = part.find(id);
                return p >= 0 && is_near(p) ? p : -1;
            },
            mesh);
    near_particles.clear();
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
        if (is_near(p)) near_particles.push_back(p);
    const int* ids = particles.ids();
    std::sort(near_particles.begin(), near_particles.end(),
              [ids](std::ptrdiff_t i, std::ptrdiff_t j) { return ids[i] < ids[j]; });
    domains.clear();
    for (const std::ptrdiff_t p : near_particles) {
        const baseline::Place place = baseline::place_of(grid, q, p);
        const Vector3* r = place.domain.r;
        domains.push_back({place.at, {r[0], r[1], r[2]}});
    }
    faces.find(grid, domains, mesh);
}

// Weights of the vertices at the nodes that the body has mass at. Facets whose vertices have none are left out.
void SurfacePair::find_nodes(Skin& skin, const Part& part, const Model& model) {
    const auto vertices = static_cast<std::size_t>(skin.mesh.vertices());
    skin.velocity.clear();
    skin.places.clear();
    if (part.body.rigid()) {
        for (std::size_t v = 0; v < vertices; ++v) {
            const Vector3 u =
                part.body.motion->velocity_at(skin.mesh.vertex(static_cast<std::ptrdiff_t>(v)));
            skin.velocity.insert(skin.velocity.end(), u.c, u.c + 3);
        }
        return;
    }
    const GridView grid = model.grid();
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
        double sum = 0.0;
        for (std::size_t i = 0; i < of_a_cell; ++i) {
            const auto node = static_cast<std::size_t>(at.node[i]);
            const bool has_mass = part.records[node][record::m] > part.least_mass;
            const double weight = has_mass ? std::clamp(at.N[i], 0.0, 1.0) : 0.0;
            skin.node[nodes_each * v + i] = at.node[i];
            skin.weight[nodes_each * v + i] = weight;
            sum += weight;
        }
        skin.is_lost[v] = !(sum > 1e-3);
        for (std::size_t i = 0; i < of_a_cell; ++i) {
            double& weight = skin.weight[nodes_each * v + i];
            weight = skin.is_lost[v] ? 0.0 : weight / sum;
            if (weight > 0.0) skin.places.push_back(skin.node[nodes_each * v + i]);
        }
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
    keep_facets(skin);
    std::sort(skin.places.begin(), skin.places.end());
    skin.places.erase(std::unique(skin.places.begin(), skin.places.end()), skin.places.end());
    skin.numbers.assign(number::size * skin.places.size(), 0.0);
    skin.fixed.assign(skin.places.size(), 0);
    for (std::size_t i = 0; i < skin.places.size(); ++i) {
        const auto node = static_cast<std::size_t>(skin.places[i]);
        double* to = &skin.numbers[number::size * i];
        to[number::m] = part.records[node][record::m];
        std::copy_n(part.motions[node].value, 3, to + number::v);
        std::copy_n(part.motions[node].value + motion::other_x, 3, to + number::before);
        for (int d = 0; d < 3; ++d)
            if (model.fixed_nodes[node] & fixed::along(d)) skin.fixed[i] |= 1 << d;
    }
    for (std::size_t k = 0; k < skin.node.size(); ++k) {
        std::ptrdiff_t& node = skin.node[k];
        node = skin.weight[k] > 0.0
                   ? std::lower_bound(skin.places.begin(), skin.places.end(), node) -
                         skin.places.begin()
                   : 0;
    }
}

void SurfacePair::keep_facets(Skin& skin) {
    std::vector<std::ptrdiff_t>& facet = skin.mesh.facet;
    std::size_t kept = 0;
    for (std::size_t f = 0; f < facet.size(); f += 3) {
        const auto lost = [&](std::size_t k) {
            return skin.is_lost[static_cast<std::size_t>(facet[f + k])] != 0;
        };
        if (lost(0) || lost(1) || lost(2)) continue;
        std::copy_n(facet.begin() + static_cast<std::ptrdiff_t>(f), 3,
                    facet.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += 3;
    }
    facet.resize(kept);
}

// By the cells along each facet of a, so that cells elsewhere do not matter.
void SurfacePair::find_spacing(const GridView& grid) {
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
    s.nodes = static_cast<std::ptrdiff_t>(skin.places.size());
    double* numbers = skin.numbers.data();
    s.mass = grit_view_of(numbers + number::m, number::size, 1);
    s.fixed = skin.fixed.data();
    s.velocity = grit_mutable_view_of(numbers + number::v, number::size, 1);
    s.previous_velocity = grit_view_of(numbers + number::before, number::size, 1);
    return s;
}

void SurfacePair::solve(const grit_surface& a, const grit_surface& b) {
    reports.resize(static_cast<std::size_t>(a.facets));
    std::size_t needed = grit_surface_workspace_size(&a, &b);
    grit_surface_totals totals{};
    totals.struct_size = sizeof totals;
    grit_error error;
    grit_status status = GRIT_OK;
    do {
        if (workspace.size() * sizeof(std::uint64_t) < needed)
            workspace.resize(needed / sizeof(std::uint64_t) + 1);
        status = grit_surface_correct(&pair_law.options, &a, &b, workspace.data(),
                                      workspace.size() * sizeof(std::uint64_t), &needed,
                                      reports.data(), &totals, &error);
    } while (needed > 0);
    require(status, error, "surface contact");
    swept.count(pair_law.options, totals);
    add_up(totals);
}

// Forces of a facet at its middle.
void SurfacePair::add_up(const grit_surface_totals& totals) {
    step_totals.dissipation = totals.dissipation_normal + totals.dissipation_tangential;
    for (int k = 0; k < 3; ++k) step_totals.impulse.along[k] = totals.impulse_on_b[k];
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

void SurfacePair::write_back(Model& model) const {
    for (const int which : {0, 1}) {
        Part& part = model.parts[which == 0 ? pair_law.a : pair_law.b];
        const Skin& skin = skins[which];
        for (std::size_t i = 0; i < skin.places.size(); ++i)
            std::copy_n(&skin.numbers[number::size * i + number::v], 3,
                        part.motions[static_cast<std::size_t>(skin.places[i])].value);
    }
}

void SurfacePair::correct(Model& model) {
    forget();
    Part* of[2] = {&model.parts[pair_law.a], &model.parts[pair_law.b]};
    find_shared_nodes(*of[0], *of[1], shared);
    if (shared.empty()) return;
    const GridView grid = model.grid();
    near.find(grid, shared);
    for (const int k : {0, 1}) {
        find_mesh(k, *of[k], grid);
        leave_out_planes_of_symmetry(skins[k].mesh, grid);
        find_nodes(skins[k], *of[k], model);
        if (skins[k].mesh.facets() == 0) return;
    }
    find_spacing(grid);
    pair_law.options.time_step = model.dt;
    solve(surface(0, of[0]->body.rigid()), surface(1, of[1]->body.rigid()));
    write_back(model);
}

Twist SurfacePair::impulse_on(std::size_t body, const Vector3& about) const {
    const double sign = body == pair_law.b ? 1.0 : -1.0;
    const Vector3 impulse = sign * step_totals.impulse.along;
    return {impulse, sign * step_totals.impulse.about - baseline::cross(about, impulse)};
}

}  // namespace grit::mpm::space
