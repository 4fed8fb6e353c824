// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/surface_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/grid/grid_point.hpp"
#include "adapters/mpm/step/keyed_items.hpp"
#include "adapters/mpm/step/require.hpp"

namespace grit::mpm {
namespace {

constexpr double neighbours =
    0.25;                        // share of a width: domains no farther apart leave no free edge
constexpr double at_ends = 2.0;  // cells between what carries the pressure, at least (ADR 12)
constexpr int nodes_each = 4;
constexpr std::ptrdiff_t stride = sizeof(KeyedNumbers) / sizeof(double);  // of what a zone has

void resize(std::vector<std::uint64_t>& workspace, std::size_t bytes) {
    if (workspace.size() * sizeof(std::uint64_t) < bytes)
        workspace.resize(bytes / sizeof(std::uint64_t) + 1);
}

grit_surface_totals no_totals() {
    grit_surface_totals totals{};
    totals.struct_size = sizeof totals;
    totals.smallest_gap = std::numeric_limits<double>::infinity();
    return totals;
}

}  // namespace

SurfaceLaw surface_law(double friction_coefficient) {
    SurfaceLaw law;
    grit_surface_options_init(&law.options, sizeof law.options);
    law.options.friction_coefficient = friction_coefficient;
    return law;
}

SurfacePair::SurfacePair(const SurfaceLaw& law, double shortest_cell, ContactZone of_both,
                         bool axisymmetric)
    : pair_law(law), zone(std::move(of_both)), line_a(law.line_a, 0.5 * shortest_cell) {
    if (law.after_damping && law.options.contact_stiffness > 0.0)
        throw std::invalid_argument("surface contact: a stiffness would act twice in a step");
    pair_law.options.axisymmetric = axisymmetric;
    pair_law.options.end_spacings = std::max(at_ends / law.spacing, 1.0);
    step_rows.a = law.a;
    step_rows.b = law.b;
    forget();
}

void SurfacePair::forget() {
    step_totals = no_totals();
    step_faces = {};
    step_rows.rows.clear();
    step_rows.terms.clear();
}

void SurfacePair::find_riders(const SurfaceBody& a, Exchange& exchange) {
    line_a.find_riders(a.particles, a.count, a.ids, exchange);
}

bool SurfacePair::find(const SurfaceBody& a, const SurfaceBody& b) {
    forget();
    return zone.find(a, b);
}

void SurfacePair::find_edges(int body, Skin& skin) {
    skin.vertices = skin.facets = 0;
    const std::span<const KeyedNumbers> domains = zone.domains(body);
    if (body == 0 && !line_a.empty()) {
        line_a.place(domains, skin.position, skin.facet, skin.owner);
        skin.vertices = static_cast<std::ptrdiff_t>(skin.position.size() / 2);
        skin.facets = static_cast<std::ptrdiff_t>(skin.facet.size() / 2);
    } else if (!domains.empty()) {
        find_free_edges(domains, skin);
    }
}

void SurfacePair::find_free_edges(std::span<const KeyedNumbers> of_zone, Skin& skin) {
    const std::size_t n = of_zone.size();
    skin.position.resize(8 * n);
    skin.facet.resize(8 * n);
    skin.owner.resize(4 * n);
    grit_surface_domains domains{};
    domains.struct_size = sizeof domains;
    domains.n = static_cast<std::ptrdiff_t>(n);
    domains.position = grit_view_of(&of_zone[0].value[near_domain::r], stride, 1);
    domains.side = grit_matrix_view_of(&of_zone[0].value[near_domain::r1r], stride, 2, 1);
    domains.tolerance = neighbours;
    const std::size_t bytes = grit_surface_find_free_workspace_size(domains.n);
    resize(workspace, bytes);
    grit_error error;
    require(grit_surface_find_free(&domains, workspace.data(), bytes, skin.position.data(),
                                   skin.facet.data(), skin.owner.data(), &skin.vertices,
                                   &skin.facets, &error),
            error, "surface contact");
}

// By the cells along each facet of a, so that cells elsewhere do not matter.
void SurfacePair::find_spacing() {
    const Skin& skin = skins[0];
    const GridView& grid = zone.whole_grid();
    const auto cell = [](const AxisView& axis, double x) {
        return 1.0 / axis.inverse[axis.cell_of(x)];
    };
    double least = std::numeric_limits<double>::infinity();
    spacing.clear();
    for (std::ptrdiff_t f = 0; f < skin.facets; ++f) {
        const double* from = skin.end(f, 0);
        const double* to = skin.end(f, 1);
        const double r = to[0] - from[0], z = to[1] - from[1];
        const double h_r = cell(grid.r, 0.5 * (from[0] + to[0]));
        const double h_z = cell(grid.z, 0.5 * (from[1] + to[1]));
        const double length = std::hypot(r, z);
        spacing.push_back(pair_law.spacing *
                          (length > 0.0 ? std::hypot(r * h_r, z * h_z) / length : h_r));
        least = std::min({least, h_r, h_z});
    }
    pair_law.options.spacing = pair_law.spacing * least;
    pair_law.options.reach = least;
}

// Weights of the vertices at the nodes that the body has mass at. Facets whose vertices have none are left out.
void SurfacePair::find_nodes(int body, const SurfaceBody& of, Skin& skin) {
    const auto vertices = static_cast<std::size_t>(skin.vertices);
    if (of.rigid) {
        skin.velocity.clear();
        for (std::size_t v = 0; v < vertices; ++v)
            skin.velocity.insert(skin.velocity.end(), {of.velocity[0], of.velocity[1]});
        return;
    }
    skin.node.resize(nodes_each * vertices);
    skin.weight.resize(nodes_each * vertices);
    skin.is_lost.resize(vertices);
    const GridView& grid = zone.whole_grid();
    const auto within = [](const AxisView& axis, double x) {
        return std::clamp(x, axis.node[0], axis.node[axis.cells]);
    };
    for (std::size_t v = 0; v < vertices; ++v) {
        const GridPoint at = grid_point(grid, within(grid.r, skin.position[2 * v]),
                                        within(grid.z, skin.position[2 * v + 1]));
        std::ptrdiff_t* node = &skin.node[nodes_each * v];
        double *weight = &skin.weight[nodes_each * v], sum = 0.0;
        for (std::size_t i = 0; i < nodes_each; ++i) {
            const std::ptrdiff_t place = zone.place_of(body, at.node[i]);
            node[i] = std::max<std::ptrdiff_t>(place, 0);
            weight[i] = place < 0 ? 0.0 : std::clamp(at.N[i], 0.0, 1.0);
            sum += weight[i];
        }
        skin.is_lost[v] = !(sum > 1e-3);
        for (std::size_t i = 0; i < nodes_each; ++i)
            weight[i] = skin.is_lost[v] ? 0.0 : weight[i] / sum;
    }
    keep_facets(skin);
}

void SurfacePair::keep_facets(Skin& skin) {
    std::ptrdiff_t kept = 0;
    for (std::ptrdiff_t f = 0; f < skin.facets; ++f) {
        const std::ptrdiff_t* ends = &skin.facet[2 * static_cast<std::size_t>(f)];
        const auto lost = [&](int k) { return skin.is_lost[static_cast<std::size_t>(ends[k])]; };
        if (lost(0) || lost(1)) continue;
        skin.owner[static_cast<std::size_t>(kept)] = skin.owner[static_cast<std::size_t>(f)];
        std::copy_n(ends, 2, skin.facet.begin() + 2 * kept++);
    }
    skin.facets = kept;
}

// Of the cells that the domains along the surface are in.
void SurfacePair::find_pressures(int body, Skin& skin) {
    skin.pressure.clear();
    const std::span<const KeyedNumbers> of_domains = zone.pressures(body);
    for (std::ptrdiff_t f = 0; !of_domains.empty() && f < skin.facets; ++f) {
        const auto domain = static_cast<std::size_t>(skin.owner[static_cast<std::size_t>(f)]);
        skin.pressure.push_back(of_domains[domain].value[0]);
    }
}

grit_surface SurfacePair::surface(int body, const SurfaceBody& of) {
    Skin& skin = skins[body];
    grit_surface s{};
    s.struct_size = sizeof s;
    s.rigid = of.rigid;
    s.nodes_each = nodes_each;
    s.vertices = skin.vertices;
    s.facets = skin.facets;
    s.position = grit_view_of(skin.position.data(), 2, 1);
    s.facet = skin.facet.data();
    if (body == 0) s.spacing = spacing.data();
    s.vertex_velocity = grit_view_of(skin.velocity.data(), 2, 1);
    if (of.rigid) return s;
    s.node = skin.node.data();
    s.weight = skin.weight.data();
    const std::span<KeyedNumbers> nodes = zone.nodes(body);
    s.nodes = static_cast<std::ptrdiff_t>(nodes.size());
    s.mass = grit_view_of(&nodes[0].value[near_node::m], stride, 1);
    s.body = static_cast<int>(of.number) + 1;
    skin.number.clear();
    for (const KeyedNumbers& node : nodes) skin.number.push_back(number_of(node));
    s.number = skin.number.data();
    s.fixed = zone.fixed(body);
    s.velocity = grit_mutable_view_of(&nodes[0].value[near_node::v_r], stride, 1);
    s.previous_velocity = grit_view_of(&nodes[0].value[near_node::other_r], stride, 1);
    if (!skin.pressure.empty()) s.pore_pressure = skin.pressure.data();
    const std::span<const KeyedNumbers> pores = zone.pores(body);
    if (pores.empty()) return s;
    const std::span<KeyedNumbers> seepage = zone.seepage(body);
    s.pores = grit_view_of(&pores[0].value[near_pores::m], stride, 1);
    s.water_fixed = zone.water_fixed(body);
    s.seepage = grit_mutable_view_of(&seepage[0].value[near_seepage::now_r], stride, 1);
    s.previous_seepage = grit_view_of(&seepage[0].value[near_seepage::before_r], stride, 1);
    return s;
}

void SurfacePair::keep_rows() {
    std::size_t terms = 0;
    for (std::ptrdiff_t r = 0; r < call_totals.rows; ++r) {
        const grit_surface_row& row = call_totals.row[r];
        const auto count = static_cast<std::size_t>(row.terms);
        step_rows.rows.push_back({terms,
                                  terms + count,
                                  row.bound,
                                  {row.rigid[0], row.rigid[1]},
                                  {row.impulse[0], row.impulse[1]},
                                  {row.water_impulse[0], row.water_impulse[1]}});
        terms += count;
        for (std::ptrdiff_t t = row.first_term; t < row.first_term + row.terms; ++t) {
            const grit_surface_term& term = call_totals.term[t];
            const auto& d = term.direction;
            step_rows.terms.push_back({term.of_b ? pair_law.b : pair_law.a,
                                       static_cast<std::size_t>(zone.node_here(zone.nodes(
                                           term.of_b)[static_cast<std::size_t>(term.node)])),
                                       term.of_b,
                                       {Vector2{d[0][0], d[0][1]}, Vector2{d[1][0], d[1][1]}}});
        }
    }
}

void SurfacePair::take_rows(double dt) {
    for (const SurfaceRow& row : step_rows.rows) {
        const double more = row.impulse[0] - row.of_contact[0];
        // The mean normal out of a, by the terms of one side.
        Vector2 normal[2] = {{0.0, 0.0}, {0.0, 0.0}};
        bool any[2] = {false, false};
        for (std::size_t t = row.begin; t < row.end; ++t) {
            const SurfaceTerm& term = step_rows.terms[t];
            normal[term.side] = normal[term.side] + term.direction[0];
            any[term.side] = true;
        }
        const Vector2 n = any[0] ? normal[0] : -1.0 * normal[1];
        for (int c = 0; c < 2; ++c) {
            step_totals.impulse_on_a[c] -= more * n[c];
            step_totals.impulse_on_b[c] += more * n[c];
        }
        step_totals.normal_impulse += more;
        const Vector2 force = (more / dt) * n;  // on b
        step_faces.add(n, force, force[1]);
    }
}

void SurfacePair::add_call(const SurfaceBody& a, const SurfaceBody& b, double dt,
                           Exchange& exchange, SurfaceCalls& calls) {
    call_totals = no_totals();
    is_called = false;
    zone.gather(a, b, exchange);
    for (const int k : {0, 1}) {
        find_edges(k, skins[k]);
        find_nodes(k, k == 0 ? a : b, skins[k]);
        find_pressures(k, skins[k]);
        if (skins[k].facets == 0) return;
    }
    find_spacing();
    pair_law.options.time_step = dt;
    given[0] = surface(0, a);
    given[1] = surface(1, b);
    reports.resize(static_cast<std::size_t>(given[0].facets));
    calls.add({&pair_law.options, &given[0], &given[1], reports.data(), &call_totals});
    is_called = true;
}

void SurfacePair::take_call(const SurfaceBody& a, const SurfaceBody& b, bool keep) {
    swept.count(pair_law.options, call_totals);
    if (keep) keep_rows();
    call_totals.row = nullptr;
    call_totals.term = nullptr;
    call_totals.rows = 0;
    zone.write(0, a);
    zone.write(1, b);
    sum_faces();
    const grit_surface_totals before = step_totals;
    step_totals = call_totals;
    for (int c = 0; c < 3; ++c) {
        step_totals.impulse_on_a[c] += before.impulse_on_a[c];
        step_totals.impulse_on_b[c] += before.impulse_on_b[c];
    }
    step_totals.normal_impulse += before.normal_impulse;
    step_totals.dissipation_normal += before.dissipation_normal;
    step_totals.dissipation_tangential += before.dissipation_tangential;
}

// The normal force of a facet bears at the tip as far as it acts along z, wherever the facet is.
void SurfacePair::sum_faces() {
    const Skin& skin = skins[0];
    for (std::size_t f = 0; f < reports.size(); ++f) {
        const double* from = skin.end(static_cast<std::ptrdiff_t>(f), 0);
        const double* to = skin.end(static_cast<std::ptrdiff_t>(f), 1);
        const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
        if (!(length > 0.0)) continue;
        const Vector2 outward{(to[1] - from[1]) / length, (from[0] - to[0]) / length};
        const Vector2 force{-reports[f].force[0], -reports[f].force[1]};  // on b
        step_faces.add(outward, force, reports[f].normal_force * outward[1]);
    }
}

}  // namespace grit::mpm
