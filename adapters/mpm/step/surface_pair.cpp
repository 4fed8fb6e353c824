// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/surface_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adapters/mpm/grid/grid_point.hpp"
#include "adapters/mpm/kernel/place.hpp"
#include "adapters/mpm/step/require.hpp"

namespace grit::mpm {
namespace {

constexpr double neighbours =
    0.25;                        // share of a width: domains no farther apart leave no free edge
constexpr double spacing = 2.0;  // of what carries the pressure, in cells (ADR 13)
constexpr int nodes_each = 4;

void resize(std::vector<std::uint64_t>& workspace, std::size_t bytes) {
    if (workspace.size() * sizeof(std::uint64_t) < bytes)
        workspace.resize(bytes / sizeof(std::uint64_t) + 1);
}

}  // namespace

SurfaceLaw surface_law(double friction_coefficient) {
    SurfaceLaw law;
    grit_surface_options_init(&law.options, sizeof law.options);
    law.options.friction_coefficient = friction_coefficient;
    return law;
}

SurfacePair::SurfacePair(const SurfaceLaw& law, const Settings& settings, const GridView& grid,
                         double shortest_cell, const std::vector<std::uint8_t>& fixed)
    : pair_law(law), axisymmetric(settings.axisymmetric), near(grid) {
    pair_law.options.axisymmetric = axisymmetric;
    pair_law.options.spacing = spacing * shortest_cell;
    pair_law.options.reach = shortest_cell;
    for (const std::uint8_t bits : fixed)
        fixed_bits.push_back((bits & fixed::r ? 1 : 0) | (bits & fixed::z ? 2 : 0));
    forget();
}

void SurfacePair::forget() {
    step_totals = {};
    step_totals.struct_size = sizeof step_totals;
    step_totals.smallest_gap = std::numeric_limits<double>::infinity();
    step_faces = {};
}

// False where no node is reached by both.
bool SurfacePair::find_near(const GridView& grid, const SurfaceBody& a, const SurfaceBody& b) {
    near.clear();
    bool any = false;
    for (std::size_t i = 0; i < fixed_bits.size(); ++i) {
        if (!NearCells::is_shared(a.records[i], b.records[i])) continue;
        any = true;
        near.add(grid, static_cast<std::ptrdiff_t>(i));
    }
    return any;
}

void SurfacePair::find_edges(const GridView& grid, const SurfaceBody& body, Skin& skin) {
    skin.near.clear();
    for (std::ptrdiff_t p = 0; p < body.count; ++p)
        if (near.has(grid, body.particles, p)) skin.near.push_back(p);
    // However particles are sorted.
    std::sort(skin.near.begin(), skin.near.end(),
              [&](std::ptrdiff_t p, std::ptrdiff_t q) { return body.ids[p] < body.ids[q]; });
    skin.domain.clear();
    for (const std::ptrdiff_t p : skin.near) {
        const auto place = axisymmetric ? baseline::place_of<true>(grid, body.particles, p)
                                        : baseline::place_of<false>(grid, body.particles, p);
        skin.domain.insert(skin.domain.end(), {place.r, place.z, place.domain.r1r, place.domain.r1z,
                                               place.domain.r2r, place.domain.r2z});
    }
    const std::size_t n = skin.near.size();
    skin.position.resize(8 * n);
    skin.facet.resize(8 * n);
    grit_surface_domains domains{};
    domains.struct_size = sizeof domains;
    domains.n = static_cast<std::ptrdiff_t>(n);
    domains.position = grit_view_of(skin.domain.data(), 6, 1);
    domains.side = grit_matrix_view_of(skin.domain.data() + 2, 6, 2, 1);
    domains.tolerance = neighbours;
    const std::size_t bytes = grit_surface_find_free_workspace_size(domains.n);
    resize(workspace, bytes);
    grit_error error;
    require(grit_surface_find_free(&domains, workspace.data(), bytes, skin.position.data(),
                                   skin.facet.data(), nullptr, &skin.vertices, &skin.facets,
                                   &error),
            error, "surface contact");
}

// Weights of the vertices at the nodes that the body has mass at. Facets whose vertices have none are left out.
void SurfacePair::find_nodes(const GridView& grid, const SurfaceBody& body, Skin& skin) {
    const auto size = nodes_each * static_cast<std::size_t>(skin.vertices);
    skin.node.assign(size, 0);
    skin.weight.assign(size, 0.0);
    if (body.rigid) {
        skin.velocity.clear();
        for (std::ptrdiff_t v = 0; v < skin.vertices; ++v)
            skin.velocity.insert(skin.velocity.end(), {body.velocity[0], body.velocity[1]});
        return;
    }
    std::vector<char> is_lost(static_cast<std::size_t>(skin.vertices));
    const auto within = [](const AxisView& axis, double x) {
        return std::clamp(x, axis.node[0], axis.node[axis.cells]);
    };
    for (std::size_t v = 0; v < is_lost.size(); ++v) {
        const GridPoint at = grid_point(grid, within(grid.r, skin.position[2 * v]),
                                        within(grid.z, skin.position[2 * v + 1]));
        double sum = 0.0;
        for (std::size_t i = 0; i < nodes_each; ++i) {
            const bool has_mass = body.records[at.node[i]][record::m] > body.least_mass;
            skin.node[nodes_each * v + i] = at.node[i];
            skin.weight[nodes_each * v + i] = has_mass ? std::clamp(at.N[i], 0.0, 1.0) : 0.0;
            sum += skin.weight[nodes_each * v + i];
        }
        is_lost[v] = !(sum > 1e-3);
        for (std::size_t i = 0; i < nodes_each; ++i)
            skin.weight[nodes_each * v + i] =
                is_lost[v] ? 0.0 : skin.weight[nodes_each * v + i] / sum;
    }
    keep_facets(is_lost, skin);
}

void SurfacePair::keep_facets(const std::vector<char>& is_lost, Skin& skin) {
    if (std::none_of(is_lost.begin(), is_lost.end(), [](char lost) { return lost; })) return;
    std::ptrdiff_t kept = 0;
    for (std::ptrdiff_t f = 0; f < skin.facets; ++f) {
        const std::ptrdiff_t* ends = &skin.facet[2 * static_cast<std::size_t>(f)];
        const auto lost = [&](int k) { return is_lost[static_cast<std::size_t>(ends[k])]; };
        if (lost(0) || lost(1)) continue;
        std::copy_n(ends, 2, skin.facet.begin() + 2 * kept++);
    }
    skin.facets = kept;
}

grit_surface SurfacePair::surface(const SurfaceBody& body, Skin& skin) const {
    grit_surface s{};
    s.struct_size = sizeof s;
    s.rigid = body.rigid;
    s.nodes_each = nodes_each;
    s.vertices = skin.vertices;
    s.facets = skin.facets;
    s.position = grit_view_of(skin.position.data(), 2, 1);
    s.facet = skin.facet.data();
    s.node = skin.node.data();
    s.weight = skin.weight.data();
    s.nodes = static_cast<std::ptrdiff_t>(fixed_bits.size());
    auto* motions = reinterpret_cast<double*>(body.motions);
    s.mass =
        grit_view_of(reinterpret_cast<const double*>(body.records) + record::m, record::size, 1);
    s.fixed = fixed_bits.data();
    s.velocity = grit_mutable_view_of(motions + motion::v_r, motion::size, 1);
    s.previous_velocity = grit_view_of(motions + motion::other_r, motion::size, 1);
    s.vertex_velocity = grit_view_of(skin.velocity.data(), 2, 1);
    return s;
}

void SurfacePair::solve(const grit_surface& a, const grit_surface& b) {
    reports.resize(static_cast<std::size_t>(a.facets));
    std::size_t needed = grit_surface_workspace_size(&a, &b);
    grit_error error;
    grit_status status = GRIT_OK;
    do {
        resize(workspace, needed);
        status = grit_surface_correct(&pair_law.options, &a, &b, workspace.data(),
                                      workspace.size() * sizeof(std::uint64_t), &needed,
                                      reports.data(), &step_totals, &error);
    } while (needed > 0);
    require(status, error, "surface contact");
}

void SurfacePair::correct(const GridView& grid, const SurfaceBody& a, const SurfaceBody& b,
                          double dt) {
    forget();
    if (!find_near(grid, a, b)) return;
    const SurfaceBody* bodies[2] = {&a, &b};
    for (const int k : {0, 1}) {
        find_edges(grid, *bodies[k], skins[k]);
        find_nodes(grid, *bodies[k], skins[k]);
    }
    if (skins[0].facets == 0 || skins[1].facets == 0) return;
    pair_law.options.time_step = dt;
    solve(surface(a, skins[0]), surface(b, skins[1]));
    sum_faces();
}

void SurfacePair::sum_faces() {
    const Skin& skin = skins[0];
    for (std::size_t f = 0; f < reports.size(); ++f) {
        const double* from = &skin.position[2 * static_cast<std::size_t>(skin.facet[2 * f])];
        const double* to = &skin.position[2 * static_cast<std::size_t>(skin.facet[2 * f + 1])];
        const bool faces_z = std::fabs(to[0] - from[0]) > std::fabs(to[1] - from[1]);
        Vector2& face = faces_z ? step_faces.along_z : step_faces.along_r;
        for (int c = 0; c < 2; ++c) face[c] -= reports[f].force[c];
    }
}

}  // namespace grit::mpm
