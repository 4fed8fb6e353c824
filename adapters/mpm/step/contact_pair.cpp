// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/contact_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <grit/contact_penalty.h>

#include "adapters/mpm/kernel/place.hpp"
#include "adapters/mpm/step/require.hpp"

namespace grit::mpm {

ContactLaw contact_law(int law, double friction_coefficient, double penalty_power) {
    ContactLaw out;
    grit_contact_options_init(&out.options, sizeof out.options);
    out.options.components = 2;
    out.options.law = law;
    out.options.friction_coefficient = friction_coefficient;
    out.options.penalty_power = penalty_power;
    out.options.allow_zero_normal = 1;
    return out;
}

double contact_stiffness(double multiple, double modulus, double cell) {
    double out = 0.0;
    if (grit_penalty_stiffness(multiple, modulus, cell, &out) != GRIT_OK)
        throw std::invalid_argument("contact: no stiffness of this modulus [Pa] and cell [m]");
    return out;
}

ContactPair::ContactPair(const ContactLaw& law, const Settings& settings, const GridView& grid,
                         const std::vector<std::uint8_t>& fixed)
    : pair_law(law), axisymmetric(settings.axisymmetric), fixed_point(settings.fixed_point),
      near(grid), sums{}, step_totals{} {
    const std::size_t n = fixed.size();
    for (const std::uint8_t bits : fixed)
        fixed_bits.push_back((bits & fixed::r ? GRIT_CONTACT_FIXED_1 : 0) |
                             (bits & fixed::z ? GRIT_CONTACT_FIXED_2 : 0));
    for (int j = 0; j <= grid.z.cells; ++j)
        for (int i = 0; i <= grid.r.cells; ++i) {
            position.insert(position.end(), {grid.r.node[i], grid.z.node[j]});
            const auto cell = [](const AxisView& axis, int k) {
                return axis.limit[std::min(k, axis.cells - 1)];
            };
            spacing.insert(spacing.end(), {cell(grid.r, i), cell(grid.z, j)});
        }
    normal.resize(2 * n);
    surface.resize(2 * n);
    near_surface.resize(2 * n);
    centre.resize(2 * n);
    reach.resize(n);
    distance.resize(n);
    gap.resize(n);
    gate_gap.resize(n);
    area.resize(n);
    pore_impulse.resize(n);
    overlap_gap.resize(2 * n);
    touched.resize(n);
    is_active.resize(n);
    active.reserve(n);
    reports.resize(n);
    step_faces.largest_gap = NAN;
    undefined.reserve(n);
    closed.reserve(n);
    is_closed.resize(n);
    for (std::vector<double>& each : direction) each.resize(2 * n);
    direction_surface.resize(2 * directions * n);
    step_totals.struct_size = sizeof step_totals;
}

// False where no process has a node in contact.
bool ContactPair::find_active(const GridView& grid, const ContactBody& a, const ContactBody& b,
                              Exchange& exchange) {
    active.clear();
    const std::uint8_t* mine = exchange.counted();
    for (std::size_t i = 0; i < is_active.size(); ++i) {
        is_active[i] = NearCells::is_shared(a.records[i], b.records[i]);
        if (is_active[i] && (!mine || mine[i])) active.push_back(static_cast<std::ptrdiff_t>(i));
    }
    counted = active.size();
    for (std::size_t i = 0; mine && i < is_active.size(); ++i)
        if (is_active[i] && !mine[i]) active.push_back(static_cast<std::ptrdiff_t>(i));
    near.clear();
    for (const std::ptrdiff_t node : active) near.add(grid, node);
    double any = active.empty() ? 0.0 : 1.0;
    exchange.max(&any, 1);
    return any > 0.0;
}

void ContactPair::find_normals(const ContactBody& a, const ContactBody& b) {
    find_normals(a, b, pair_law.normal, active, normal);
    // A node inside the one body whose surface was asked for may be at the surface of the other. Not a node of a symmetry plane
    // that the body does not reach: of its gradient across the plane, which is left out, there is less than of one that does.
    undefined.clear();
    const bool of_b = pair_law.normal == GRIT_CONTACT_NORMAL_OF_B;
    const bool average = pair_law.normal == GRIT_CONTACT_NORMAL_AVERAGE;
    const auto is_aside = [&](std::size_t node) {
        const NodeRecord& g = (of_b ? b : a).records[node];
        const double across = fixed_bits[node] == GRIT_CONTACT_FIXED_1   ? g[record::g_r]
                              : fixed_bits[node] == GRIT_CONTACT_FIXED_2 ? g[record::g_z]
                                                                         : 0.0;
        const double along = spacing[2 * node + (fixed_bits[node] == GRIT_CONTACT_FIXED_1 ? 1 : 0)];
        return std::fabs(across) > 1e-8 * g[record::g_scale] && std::fabs(across) < 0.4 * along;
    };
    for (const std::ptrdiff_t node : active) {
        const auto i = static_cast<std::size_t>(node);
        if (normal[2 * i] != 0.0 || normal[2 * i + 1] != 0.0) continue;
        if (average || !is_aside(i)) undefined.push_back(node);
    }
    find_normals(a, b, of_b ? GRIT_CONTACT_NORMAL_OF_A : GRIT_CONTACT_NORMAL_OF_B, undefined,
                 normal);
}

void ContactPair::find_normals(const ContactBody& a, const ContactBody& b, int source,
                               const std::vector<std::ptrdiff_t>& nodes, std::vector<double>& of) {
    const auto view = [](const ContactBody& body, int column) {
        return grit_view_of(&reinterpret_cast<const double*>(body.records)[column], record::size,
                            1);
    };
    grit_contact_gradients q{};
    q.struct_size = sizeof q;
    q.components = 2;
    q.source = source;
    q.index = nodes.data();
    q.gradient_a = view(a, record::g_r);
    q.gradient_b = view(b, record::g_r);
    if (source != GRIT_CONTACT_NORMAL_AVERAGE)
        q.scale = view(source == GRIT_CONTACT_NORMAL_OF_A ? a : b, record::g_scale);
    q.fixed = fixed_bits.data();
    q.normal = grit_mutable_view_of(of.data(), 2, 1);
    grit_error error;
    require(grit_contact_normals_from_gradients(static_cast<std::ptrdiff_t>(nodes.size()), &q,
                                                nullptr, &error),
            error, "contact");
}

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

// A domain as contact sees it: corners, and of the nodes that it may have weight at those that are wanted.
struct ContactPair::Reaching {
    template <class Place>
    Reaching(const GridView& grid, const Place& place, const std::vector<char>& wanted)
        : x{place.r, place.z}, side{place.domain.r1r, place.domain.r1z, place.domain.r2r,
                                    place.domain.r2z} {
        const std::ptrdiff_t n_r = grid.nodes_r();
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
                    if (wanted[static_cast<std::size_t>(node)]) nodes[count++] = node;
                }
        }
    }
    double x[2], side[4], corner[4][2];
    std::ptrdiff_t nodes[16];
    int count = 0;
};

// Adds the particles that have weight at an active node, and their corners beside one.
template <bool axi>
void ContactPair::measure(const GridView& grid, const ContactBody& body, int which) {
    const grit_contact_surfaces beside_nodes = surfaces(near_surface);
    grit_contact_surfaces all = surfaces(surface);
    all.centre = grit_mutable_view_of(centre.data(), 2, 1);
    for (std::ptrdiff_t p = 0; p < body.count; ++p) {
        if (!near.has(grid, body.particles, p)) continue;
        const Reaching q(grid, baseline::place_of<axi>(grid, body.particles, p), is_active);
        std::ptrdiff_t beside[16];
        for (const auto& at : q.corner) {
            const auto is_at = [&](std::ptrdiff_t node) { return is_beside(at, node); };
            const auto* end = std::copy_if(q.nodes, q.nodes + q.count, beside, is_at);
            add(beside_nodes, which, at, nullptr, beside, static_cast<int>(end - beside));
        }
        add(all, which, q.x, q.side, q.nodes, q.count);
    }
}

grit_contact_surfaces ContactPair::along_direction(int k) {
    grit_contact_surfaces s = surfaces(surface);
    s.normal = grit_view_of(direction[k].data(), 2, 1);
    s.surface = grit_mutable_view_of(direction_surface.data() + 2 * k, 2 * directions, 1);
    return s;
}

template <bool axi>
void ContactPair::measure_directions(const GridView& grid, const ContactBody& body, int which) {
    for (std::ptrdiff_t p = 0; p < body.count; ++p) {
        if (!near.has(grid, body.particles, p)) continue;
        const Reaching q(grid, baseline::place_of<axi>(grid, body.particles, p), is_closed);
        for (int k = 0; k < directions; ++k)
            add(along_direction(k), which, q.x, q.side, q.nodes, q.count);
    }
}

// Bodies are apart if they are along any direction. Beside a corner the normal is a diagonal, along which a
// face of the other body reaches behind the corner: nodes that it calls closed are asked along the grid, the
// normal of the other body and the one between both, by all that has weight there.
void ContactPair::part_corners(const GridView& grid, const ContactBody& a, const ContactBody& b,
                               Exchange& exchange) {
    closed.clear();
    std::fill(is_closed.begin(), is_closed.end(), 0);
    for (const std::ptrdiff_t node : active) {
        const auto i = static_cast<std::size_t>(node);
        if (!(gap[i] <= pair_law.options.gap_tolerance)) continue;
        closed.push_back(node);
        is_closed[i] = 1;
        std::fill_n(&direction_surface[2 * directions * i], 2 * directions,
                    std::numeric_limits<double>::infinity());
        for (const std::size_t c : {0, 1}) {  // as the normal points
            const double n = normal[2 * i + c];
            direction[c][2 * i + c] = n > 0.0 ? 1.0 : n < 0.0 ? -1.0 : 0.0;
        }
    }
    int k = 2;
    for (const int source :
         {GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B, GRIT_CONTACT_NORMAL_AVERAGE})
        if (source != pair_law.normal) find_normals(a, b, source, closed, direction[k++]);
    if (!closed.empty())
        for (const int which : {0, 1})
            axisymmetric ? measure_directions<true>(grid, which == 0 ? a : b, which)
                         : measure_directions<false>(grid, which == 0 ? a : b, which);
    exchange.min_nodes(direction_surface.data(), static_cast<std::ptrdiff_t>(is_closed.size()),
                       2 * directions);
    constexpr double touching = 1e-9;  // cells: roundoff parts no bodies that touch
    for (const std::ptrdiff_t node : closed) {
        const auto i = static_cast<std::size_t>(node);
        const double least = touching * std::min(spacing[2 * i], spacing[2 * i + 1]);
        for (k = 0; k < directions; ++k) {
            const double* of =
                &direction_surface[2 * (directions * i + static_cast<std::size_t>(k))];
            const double apart = of[0] + of[1];
            if (!std::isfinite(apart)) continue;  // no such direction
            gap[i] = std::max(gap[i], apart > least ? apart : std::min(apart, 0.0));
        }
    }
}

// How far x is from the stiffer body near a node, negative inside: what is outside along any direction is.
double ContactPair::outside(const double* x, std::size_t node) const {
    const double* at = &position[2 * node];
    const auto along = [&](const double* n, double surface_of_a) {
        return surface_of_a + (x[0] - at[0]) * n[0] + (x[1] - at[1]) * n[1];
    };
    double out = along(&normal[2 * node], surface[2 * node]);
    for (std::size_t k = 0; k < directions; ++k) {
        const double from_a = direction_surface[2 * (directions * node + k)];
        if (std::isfinite(from_a)) out = std::max(out, along(&direction[k][2 * node], from_a));
    }
    return out;
}

template <bool axi>
void ContactPair::measure_overlaps(const GridView& grid, const ContactBody& soft) {
    for (std::ptrdiff_t p = 0; p < soft.count; ++p) {
        if (!near.has(grid, soft.particles, p)) continue;
        const Reaching q(grid, baseline::place_of<axi>(grid, soft.particles, p), is_closed);
        for (const auto& at : q.corner)
            for (int k = 0; k < q.count; ++k) {
                const auto i = static_cast<std::size_t>(q.nodes[k]);
                if (!is_beside(at, q.nodes[k])) continue;
                overlap_gap[2 * i] = std::min(overlap_gap[2 * i], outside(at, i));
            }
    }
}

// Beyond a body that is thinner than a cell the normals of the two are opposed, by more than 120 degrees: neither is that
// of the surface between them, and what lies along it is no overlap.
bool ContactPair::has_both_on_one_side(std::size_t node) const {
    const bool average = pair_law.normal == GRIT_CONTACT_NORMAL_AVERAGE;
    const double *n = &(average ? direction[3] : normal)[2 * node], *m = &direction[2][2 * node];
    return n[0] * m[0] + n[1] * m[1] < -0.5;
}

// The overlap that a spring works against. In the hollow corner of what surrounds an edge the gap along the diagonal is
// no overlap: there it is what the corners of the softer body have entered of the stiffer one.
void ContactPair::find_overlaps(const GridView& grid, const ContactBody& soft, Exchange& exchange) {
    for (const std::ptrdiff_t node : closed)
        overlap_gap[2 * static_cast<std::size_t>(node)] = std::numeric_limits<double>::infinity();
    axisymmetric ? measure_overlaps<true>(grid, soft) : measure_overlaps<false>(grid, soft);
    exchange.min_nodes(overlap_gap.data(), static_cast<std::ptrdiff_t>(is_closed.size()), 2);
    for (const std::ptrdiff_t node : closed) {
        const auto i = static_cast<std::size_t>(node);
        if (gap[i] <= 0.0)
            gap[i] =
                has_both_on_one_side(i) ? 0.0 : std::min(0.0, std::max(gap[i], overlap_gap[2 * i]));
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
    const grit_contact_surfaces beside = surfaces(near_surface);
    require(grit_contact_surfaces_reset(&all, &error), error, "contact");
    require(grit_contact_surfaces_reset(&beside, &error), error, "contact");
    for (const int which : {0, 1})
        axisymmetric ? measure<true>(grid, which == 0 ? a : b, which)
                     : measure<false>(grid, which == 0 ? a : b, which);
    for (std::vector<double>* minima : {&surface, &near_surface, &centre})
        exchange.min_nodes(minima->data(), all.nodes, 2);
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (std::isfinite(near_surface[i])) surface[i] = near_surface[i];
}

// How far along its normal a node has weight: the d of (C4), docs/adr/0007-reach-of-a-node.md.
void ContactPair::find_reaches() {
    for (const std::ptrdiff_t node : active) {
        const auto i = static_cast<std::size_t>(node);
        const double *n = &normal[2 * i], *cell = &spacing[2 * i];
        reach[i] = std::abs(n[0]) * cell[0] + std::abs(n[1]) * cell[1];
    }
}

// What the stiffer body's surface has of a node's weight, across the normal: its gradient is the integral of the
// weight over the surface. Per radian the ring's; what a node on the axis has lies around a third of a cell.
void ContactPair::find_areas(const ContactBody& stiff) {
    for (const std::ptrdiff_t node : active) {
        const auto i = static_cast<std::size_t>(node);
        const NodeRecord& g = stiff.records[i];
        area[i] = std::abs(g[record::g_r] * normal[2 * i] + g[record::g_z] * normal[2 * i + 1]);
        if (axisymmetric) area[i] *= std::max(position[2 * i], spacing[2 * i] / 3.0);
    }
}

// What is beside a node changes from one corner to the next, and with it the gap by a jump. A node that
// pressed in the step before is therefore left to the velocities alone, unless the gap is half its reach.
void ContactPair::find_gates() {
    for (const std::ptrdiff_t node : active) {
        const auto i = static_cast<std::size_t>(node);
        const bool is_near = gap[i] < 0.5 * reach[i];
        gate_gap[i] = touched[i] && is_near ? std::fmin(gap[i], 0.0) : gap[i];
    }
}

void ContactPair::remember() {
    std::fill(touched.begin(), touched.end(), 0);
    for (std::size_t i = 0; i < active.size(); ++i)
        touched[static_cast<std::size_t>(active[i])] = reports[i].penalty_factor > 0.0;
}

bool ContactPair::find(const GridView& grid, const ContactBody& a, const ContactBody& b,
                       Exchange& exchange) {
    step_totals = {};
    step_totals.struct_size = sizeof step_totals;
    step_faces = {{}, NAN};
    if (!find_active(grid, a, b, exchange)) {
        remember();
        return false;
    }
    const auto n = static_cast<std::ptrdiff_t>(active.size());
    std::fill(normal.begin(), normal.end(), 0.0);
    find_normals(a, b);

    grit_error error;
    const bool geo = pair_law.options.law == GRIT_CONTACT_GEO;
    const bool stiff = pair_law.options.contact_stiffness > 0.0;
    if (geo || pair_law.gated) {
        find_surfaces(grid, a, b, exchange);
        grit_contact_surfaces s = surfaces(surface);
        s.centre = grit_mutable_view_of(centre.data(), 2, 1);
        grit_contact_distances wanted{};
        wanted.struct_size = sizeof wanted;
        wanted.measure = pair_law.measure;
        wanted.index = active.data();
        wanted.distance = grit_mutable_view_of(distance.data(), 1, 1);
        wanted.gap = grit_mutable_view_of(gap.data(), 1, 1);
        require(grit_contact_surfaces_finish(&s, n, &wanted, &error), error, "contact");
        if (pair_law.gated) part_corners(grid, a, b, exchange);
        if (stiff) find_overlaps(grid, b, exchange);
        find_reaches();
        find_gates();
    }
    if (stiff) find_areas(a);
    return true;
}

void ContactPair::correct(const ContactBody& a, const ContactBody& b, double dt,
                          Exchange& exchange) {
    const auto n = static_cast<std::ptrdiff_t>(active.size());
    const bool geo = pair_law.options.law == GRIT_CONTACT_GEO;
    const bool stiff = pair_law.options.contact_stiffness > 0.0;
    grit_error error;
    grit_contact_options options = pair_law.options;
    options.time_step = dt;
    options.rigid = a.rigid   ? GRIT_CONTACT_A_RIGID
                    : b.rigid ? GRIT_CONTACT_B_RIGID
                              : GRIT_CONTACT_NONE_RIGID;
    auto* motions_a = reinterpret_cast<double*>(a.motions);
    auto* motions_b = reinterpret_cast<double*>(b.motions);
    grit_contact_nodes q{};
    q.struct_size = sizeof q;
    q.index = active.data();
    q.mass_a = a.mass();
    q.mass_b = b.mass();
    q.normal = grit_view_of(normal.data(), 2, 1);
    if (geo) {
        q.distance = grit_view_of(distance.data(), 1, 1);
        q.cell_size = grit_view_of(reach.data(), 1, 1);
    }
    if (pair_law.gated) q.gap = grit_view_of(gate_gap.data(), 1, 1);
    if (stiff) q.contact_area = grit_view_of(area.data(), 1, 1);
    q.velocity_a = grit_mutable_view_of(motions_a + motion::v_r, motion::size, 1);
    q.velocity_b = grit_mutable_view_of(motions_b + motion::v_r, motion::size, 1);
    q.previous_velocity_a = grit_view_of(motions_a + motion::other_r, motion::size, 1);
    q.previous_velocity_b = grit_view_of(motions_b + motion::other_r, motion::size, 1);
    q.position = grit_view_of(position.data(), 2, 1);
    if (bears) q.pore_impulse = grit_view_of(pore_impulse.data(), 1, 1);
    sums = {};
    const auto first = static_cast<std::ptrdiff_t>(counted);
    require(grit_contact_correct(&options, first, &q, reports.data(), &sums, &error), error,
            "contact");
    q.index += counted;
    require(
        grit_contact_correct(&options, n - first, &q, reports.data() + counted, nullptr, &error),
        error, "contact");
    exchange.sum(sums.word, GRIT_CONTACT_SUMS_WORDS);
    require(grit_contact_sums_read(&sums, &step_totals), error, "contact");
    remember();
    sum_faces(geo || pair_law.gated, exchange);
}

void ContactPair::sum_faces(bool measured, Exchange& exchange) {
    FaceSums forces(fixed_point);
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < counted; ++i) {
        const auto node = static_cast<std::size_t>(active[i]);
        forces.add(&normal[2 * node], reports[i].force);
        if (measured && std::isfinite(gap[node])) largest = std::max(largest, gap[node]);
    }
    const Faces faces = forces.of_all(exchange);
    exchange.max(&largest, 1);
    step_faces = {faces, std::isfinite(largest) ? largest : NAN};
}

}  // namespace grit::mpm
