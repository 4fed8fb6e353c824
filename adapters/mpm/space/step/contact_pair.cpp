// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/contact_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Dense>

#include "adapters/mpm/space/kernel/place.hpp"
#include "adapters/mpm/step/require.hpp"

namespace grit::mpm::space {
namespace {

constexpr double far = std::numeric_limits<double>::infinity();

Vector3 force_of(const NodeSlope& of) { return {of[0], of[1], of[2]}; }

Vector3 at(const std::vector<double>& of, std::size_t i) {
    return {of[3 * i], of[3 * i + 1], of[3 * i + 2]};
}

using Row = Eigen::Matrix<double, 6, 1>;
using Square = Eigen::Matrix<double, 6, 6>;

Row row_of(const Twist& u) {
    Row out;
    out << u.along[0], u.along[1], u.along[2], u.about[0], u.about[1], u.about[2];
    return out;
}
Twist twist_of(const Row& u) { return {{u[0], u[1], u[2]}, {u[3], u[4], u[5]}}; }

// The six equations of a rigid body that its contact moves, R = M (u - trial) + sum P, where the impulses P that nodes take
// belong to u itself.
class FreeMeeting {
  public:
    FreeMeeting(const RigidMotion& of, bool in_fixed_point)
        : rigid(of), fixed_point(in_fixed_point), trial(row_of(of.velocity())) {
        const Matrix6 all = rigid.mass_matrix();
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                mass(static_cast<int>(i), static_cast<int>(j)) = all[i][j];
    }
    // How an impulse changes with the velocity: as it does, or without the turning of what slips and what a normal impulse
    // adds to its friction, which leaves a symmetric matrix.
    enum class Slope { tangent, secant };

    // Of a velocity of the body; then each node that touches; then what all processes have added.
    void begin(const Row& u) {
        velocity = u;
        sums = {};
    }
    // A node at x of mass m that the body moves towards by w along its normal n, pressed by the share f of w . n.
    void add(const Vector3& x, const Vector3& n, const Vector3& w, const Vector3& impulse, double m,
             double f, double friction, Slope slope) {
        const Vector3 across = w - dot(w, n) * n;
        const Vector3 rubs = impulse - dot(impulse, n) * n;
        const double slip = norm(across), most = m * slip;
        const double share = most > 0.0 ? std::min(norm(rubs) / most, 1.0) : 1.0;
        const bool slides = share < 1.0;
        const Row along = row(x, n);
        Row way = Row::Zero();
        if (slides && slope == Slope::tangent) way = row(x, (1.0 / slip) * across);
        // Where water bears all that presses, nothing rubs, and a little more does not either.
        add(m * f * (along + (share > 0.0 ? friction : 0.0) * way), along);
        for (int k = 0; k < 3; ++k) {
            Vector3 t = -n[k] * n;  // I - n n, row by row
            t[k] += 1.0;
            Vector3 e{0.0, 0.0, 0.0};
            e[k] = 1.0;
            add(m * share * row(x, e), row(x, t));
        }
        if (slides && slope == Slope::tangent) add(-m * share * way, way);
        const Row of = row(x, impulse);
        for (std::size_t i = 0; i < 6; ++i) sums[36 + i].add(of[static_cast<int>(i)], fixed_point);
    }
    void finish(Exchange& exchange) {
        exchange.sum(sums, fixed_point);
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < 6; ++j)
                slopes(static_cast<int>(i), static_cast<int>(j)) = sums[6 * i + j].value();
            residual[static_cast<int>(i)] = sums[36 + i].value();
        }
        residual += mass * (velocity - trial);
    }
    // Twice the energy of what the impulses leave beside the velocity, and that of what they did.
    double off() const { return residual.dot(mass.partialPivLu().solve(residual)); }
    double moved() const { return (velocity - trial).dot(mass * (velocity - trial)); }
    Row step() const { return -(mass + slopes).partialPivLu().solve(residual); }
    const Row& start() const { return trial; }

  private:
    // What the velocities that are free give along n at x.
    Row row(const Vector3& x, const Vector3& n) const {
        const Vector3 about = baseline::cross(x - rigid.centre(), n);
        Row out;
        out << n[0], n[1], n[2], about[0], about[1], about[2];
        for (int i = 0; i < 6; ++i)
            if (!rigid.free()[static_cast<std::size_t>(i)]) out[i] = 0.0;
        return out;
    }
    void add(const Row& impulse, const Row& of) {
        Total* matrix = sums.data();
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) (matrix++)->add(impulse[i] * of[j], fixed_point);
    }

    const RigidMotion& rigid;
    bool fixed_point;
    Square mass, slopes;
    Row trial, velocity, residual;
    std::array<Total, 42> sums;  // a matrix, and the impulses behind it
};

}  // namespace

ContactPair::ContactPair(const ContactLaw& law, const Model& model)
    : pair_law(law), exchange(model.exchange), place_of(model.nodes(), -1), touched(model.nodes()),
      near(model.cells()), fixed_point(model.settings.fixed_point) {
    pair_law.options.components = 3;
    step_totals.struct_size = sizeof step_totals;
    step_measured.largest_gap = NAN;
}

bool ContactPair::find_active(const Model& model) {
    for (const std::ptrdiff_t node : active) place_of[static_cast<std::size_t>(node)] = -1;
    find_shared_nodes(model.parts[pair_law.a], model.parts[pair_law.b], active);
    counted = active.size();
    if (const std::uint8_t* mine = exchange.counted())
        counted = static_cast<std::size_t>(
            std::stable_partition(active.begin(), active.end(),
                                  [mine](std::ptrdiff_t node) { return mine[node] != 0; }) -
            active.begin());
    for (std::size_t i = 0; i < active.size(); ++i)
        place_of[static_cast<std::size_t>(active[i])] = static_cast<int>(i);
    double any = active.empty() ? 0.0 : 1.0;
    exchange.max(&any, 1);
    return any > 0.0;
}

void ContactPair::copy_nodes(const Model& model) {
    const std::size_t n = active.size();
    const GridView grid = model.grid();
    const Part &a = model.parts[pair_law.a], &b = model.parts[pair_law.b];
    for (std::vector<double>* three : {&position, &spacing, &normal}) three->assign(3 * n, 0.0);
    for (std::vector<double>* two : {&surface, &near_surface, &centre}) two->assign(2 * n, far);
    for (std::vector<double>* one :
         {&mass_a, &mass_b, &reach, &distance, &gap, &gate_gap, &overlap, &area})
        one->assign(n, 0.0);
    for (std::vector<double>* of : {&motion_a, &motion_b}) of->resize(motion::size * n);
    for (std::vector<double>* of : {&slope_a, &slope_b}) of->resize(slope::size * n);
    pores_a.resize(a.body.water ? n : 0);
    pores_b.resize(b.body.water ? n : 0);
    for (std::vector<double>& each : direction) each.assign(3 * n, 0.0);
    direction_surface.assign(2 * directions * n, far);
    fixed_bits.assign(n, 0);
    closed.assign(n, 0);
    reports.assign(n, {});
    places.resize(n);
    std::iota(places.begin(), places.end(), 0);
    for (std::size_t i = 0; i < n; ++i) {
        const auto node = static_cast<std::size_t>(active[i]);
        mass_a[i] = a.records[node][record::m];
        mass_b[i] = b.records[node][record::m];
        std::copy_n(a.motions[node].value, motion::size, &motion_a[motion::size * i]);
        std::copy_n(b.motions[node].value, motion::size, &motion_b[motion::size * i]);
        std::copy_n(a.slopes[node].value, slope::size, &slope_a[slope::size * i]);
        std::copy_n(b.slopes[node].value, slope::size, &slope_b[slope::size * i]);
        if (a.body.water) pores_a[i] = force_of(a.pore_forces[node]);
        if (b.body.water) pores_b[i] = force_of(b.pore_forces[node]);
        std::ptrdiff_t rest = active[i];
        for (int d = 0; d < 3; ++d) {
            const AxisView& axis = grid.axis[d];
            const auto k = static_cast<int>(rest % grid.nodes(d));
            rest /= grid.nodes(d);
            position[3 * i + static_cast<std::size_t>(d)] = axis.node[k];
            spacing[3 * i + static_cast<std::size_t>(d)] = axis.limit[std::min(k, axis.cells - 1)];
            if (model.fixed_nodes[node] & fixed::along(d)) fixed_bits[i] |= 1 << d;
        }
    }
}

void ContactPair::find_normals(int source, const std::vector<std::ptrdiff_t>& nodes,
                               std::vector<double>& of) {
    const auto view = [](const std::vector<double>& slopes, int first) {
        return grit_view_of(slopes.data() + first, slope::size, 1);
    };
    grit_contact_gradients q{};
    q.struct_size = sizeof q;
    q.components = 3;
    q.source = source;
    q.index = nodes.data();
    q.gradient_a = view(slope_a, slope::g_x);
    q.gradient_b = view(slope_b, slope::g_x);
    if (source != GRIT_CONTACT_NORMAL_AVERAGE)
        q.scale = view(source == GRIT_CONTACT_NORMAL_OF_A ? slope_a : slope_b, slope::scale);
    q.fixed = fixed_bits.data();
    q.normal = grit_mutable_view_of(of.data(), 3, 1);
    grit_error error;
    require(grit_contact_normals_from_gradients(static_cast<std::ptrdiff_t>(nodes.size()), &q,
                                                nullptr, &error),
            error, "contact");
}

// A node of a symmetry plane that the body does not reach: of its gradient across the plane, which is left out, there
// is less than of one that does.
bool ContactPair::is_aside(std::size_t i) const {
    const std::vector<double>& of = pair_law.normal == GRIT_CONTACT_NORMAL_OF_B ? slope_b : slope_a;
    const double* g = &of[slope::size * i];
    for (int d = 0; d < 3; ++d) {
        if (!(fixed_bits[i] & 1 << d)) continue;
        double whole = 1.0;
        for (int e = 0; e < 3; ++e)
            if (e != d)
                whole *= spacing[3 * i + static_cast<std::size_t>(e)] *
                         (fixed_bits[i] & 1 << e ? 0.5 : 1.0);
        if (std::fabs(g[d]) > 1e-8 * g[slope::scale] && std::fabs(g[d]) < 0.4 * whole) return true;
    }
    return false;
}

void ContactPair::find_normals() {
    find_normals(pair_law.normal, places, normal);
    // A node inside the one body whose surface was asked for may be at the surface of the other.
    undefined.clear();
    for (const std::ptrdiff_t place : places) {
        const auto i = static_cast<std::size_t>(place);
        const Vector3 n = at(normal, i);
        if (n[0] != 0.0 || n[1] != 0.0 || n[2] != 0.0) continue;
        if (pair_law.normal == GRIT_CONTACT_NORMAL_AVERAGE || !is_aside(i))
            undefined.push_back(place);
    }
    find_normals(pair_law.normal == GRIT_CONTACT_NORMAL_OF_B ? GRIT_CONTACT_NORMAL_OF_A
                                                             : GRIT_CONTACT_NORMAL_OF_B,
                 undefined, normal);
}

grit_contact_surfaces ContactPair::surfaces(std::vector<double>& of) {
    grit_contact_surfaces s{};
    s.struct_size = sizeof s;
    s.components = 3;
    s.nodes = static_cast<std::ptrdiff_t>(active.size());
    s.position = grit_view_of(position.data(), 3, 1);
    s.normal = grit_view_of(normal.data(), 3, 1);
    s.surface = grit_mutable_view_of(of.data(), 2, 1);
    return s;
}

grit_contact_surfaces ContactPair::along_direction(int k) {
    grit_contact_surfaces s = surfaces(surface);
    s.normal = grit_view_of(direction[k].data(), 3, 1);
    s.surface = grit_mutable_view_of(direction_surface.data() + 2 * k, 2 * directions, 1);
    return s;
}

// Whether x is no more than half a cell off the node, across the normal.
bool ContactPair::is_beside(const Vector3& x, std::size_t i) const {
    const Vector3 n = at(normal, i), from = x - at(position, i);
    const Vector3 across = from - dot(from, n) * n;
    double squares = 0.0;
    for (int d = 0; d < 3; ++d) {
        const double cells = across[d] / spacing[3 * i + static_cast<std::size_t>(d)];
        squares += cells * cells;
    }
    return squares <= 0.25 + 1e-6;
}

// Once a step, for all that asks: the particles that have weight at nodes in contact.
void ContactPair::find_reaching(Model& model) {
    const GridView grid = model.grid();
    const auto add_nodes = [&](Reaching& to, const Vector3& corner) {
        int first[3], last[3];
        for (int d = 0; d < 3; ++d) {
            first[d] = grid.axis[d].cell_of(corner[d]);
            // A corner on a grid line has no weight beyond it.
            last[d] = corner[d] == grid.axis[d].node[first[d]] ? first[d] : first[d] + 1;
        }
        for (int k = first[2]; k <= last[2]; ++k)
            for (int j = first[1]; j <= last[1]; ++j)
                for (int i = first[0]; i <= last[0]; ++i) {
                    const std::ptrdiff_t node = k * grid.step(2) + j * grid.step(1) + i;
                    const std::ptrdiff_t here = place_of[static_cast<std::size_t>(node)];
                    if (here >= 0 &&
                        std::find(to.nodes, to.nodes + to.count, here) == to.nodes + to.count)
                        to.nodes[to.count++] = here;
                }
    };
    for (const std::size_t which : {0, 1}) {
        reaching[which].clear();
        Particles& particles = model.parts[which == 0 ? pair_law.a : pair_law.b].body.particles;
        const ParticleView q = particles.view();
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
            if (!near.has(grid.cell_of(q.position(p)))) continue;
            const auto place = baseline::place_of(grid, q, p);
            Reaching to;
            to.x = place.at;
            to.count = 0;
            for (int k = 0; k < 3; ++k) std::copy_n(place.domain.r[k].c, 3, &to.side[3 * k]);
            for (int c = 0; c < 8; ++c) {
                to.corner[c] = place.at;
                for (int k = 0; k < 3; ++k)
                    to.corner[c] = to.corner[c] + (c >> k & 1 ? 1.0 : -1.0) * place.domain.r[k];
                add_nodes(to, to.corner[c]);
            }
            if (to.count > 0) reaching[which].push_back(to);
        }
    }
}

// Minima of nodes in contact, so many each, over what all processes have near them.
void ContactPair::share(std::vector<double>& minima, int each) {
    exchange.min_nodes(minima.data(), active, each);
}

// The surface beside a node, where a corner is, and not the nearest of all within a cell of it: on a
// curved surface that one is a cell off, and neighbouring nodes would wait for the same corner.
void ContactPair::find_surfaces() {
    grit_contact_surfaces all = surfaces(surface);
    all.centre = grit_mutable_view_of(centre.data(), 2, 1);
    const grit_contact_surfaces beside_nodes = surfaces(near_surface);
    for (const int which : {0, 1}) {
        domains.clear();
        corners.clear();
        for (const Reaching& q : reaching[which]) {
            std::ptrdiff_t beside[64];
            for (const Vector3& corner : q.corner) {
                const auto is_at = [&](std::ptrdiff_t i) {
                    return is_beside(corner, static_cast<std::size_t>(i));
                };
                const auto* end = std::copy_if(q.nodes, q.nodes + q.count, beside, is_at);
                corners.add(corner, beside, static_cast<int>(end - beside));
            }
            domains.add(q.x, q.side, q.nodes, q.count);
        }
        domains.send(all, which);
        corners.send(beside_nodes, which);
    }
    for (std::vector<double>* minima : {&surface, &near_surface, &centre}) share(*minima, 2);
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (std::isfinite(near_surface[i])) surface[i] = near_surface[i];
}

// Bodies are apart if they are along any direction; see the plane's. Nodes that the normal calls closed are asked along
// the grid, the normal of the other body and the one between both, by all that has weight there.
void ContactPair::part_corners() {
    asked.clear();
    for (const std::ptrdiff_t place : places) {
        const auto i = static_cast<std::size_t>(place);
        if (!(gap[i] <= pair_law.options.gap_tolerance)) continue;
        asked.push_back(place);
        closed[i] = 1;
        for (std::size_t d = 0; d < 3; ++d) {  // as the normal points
            const double n = normal[3 * i + d];
            direction[d][3 * i + d] = n > 0.0 ? 1.0 : n < 0.0 ? -1.0 : 0.0;
        }
    }
    int k = 3;
    for (const int source :
         {GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B, GRIT_CONTACT_NORMAL_AVERAGE})
        if (source != pair_law.normal) find_normals(source, asked, direction[k++]);
    for (const int which : {0, 1}) {
        if (asked.empty()) break;
        domains.clear();
        for (const Reaching& q : reaching[which]) {
            std::ptrdiff_t wanted[64];
            const auto is_closed = [&](std::ptrdiff_t i) {
                return closed[static_cast<std::size_t>(i)] != 0;
            };
            const auto* end = std::copy_if(q.nodes, q.nodes + q.count, wanted, is_closed);
            domains.add(q.x, q.side, wanted, static_cast<int>(end - wanted));
        }
        for (int d = 0; d < directions; ++d) domains.send(along_direction(d), which);
    }
    share(direction_surface, 2 * directions);
    constexpr double touching = 1e-9;  // cells: roundoff parts no bodies that touch
    for (const std::ptrdiff_t place : asked) {
        const auto i = static_cast<std::size_t>(place);
        const double least =
            touching * std::min({spacing[3 * i], spacing[3 * i + 1], spacing[3 * i + 2]});
        for (std::size_t d = 0; d < directions; ++d) {
            const double* of = &direction_surface[2 * (directions * i + d)];
            const double apart = of[0] + of[1];
            if (!std::isfinite(apart)) continue;  // no such direction
            gap[i] = std::max(gap[i], apart > least ? apart : std::min(apart, 0.0));
        }
    }
}

// How far x is from the stiffer body near a node, negative inside: what is outside along any direction is.
double ContactPair::outside(const Vector3& x, std::size_t i) const {
    const Vector3 from = x - at(position, i);
    double out = surface[2 * i] + dot(from, at(normal, i));
    for (std::size_t d = 0; d < directions; ++d) {
        const double from_a = direction_surface[2 * (directions * i + d)];
        if (std::isfinite(from_a)) out = std::max(out, from_a + dot(from, at(direction[d], i)));
    }
    return out;
}

// See the plane's.
bool ContactPair::has_both_on_one_side(std::size_t i) const {
    const bool average = pair_law.normal == GRIT_CONTACT_NORMAL_AVERAGE;
    return dot(at(average ? direction[4] : normal, i), at(direction[3], i)) < -0.5;
}

// The overlap that a spring works against; see the plane's.
void ContactPair::find_overlaps() {
    std::fill(overlap.begin(), overlap.end(), far);
    for (const Reaching& q : reaching[1]) {
        for (const Vector3& corner : q.corner)
            for (int k = 0; k < q.count; ++k) {
                const auto i = static_cast<std::size_t>(q.nodes[k]);
                if (closed[i] && is_beside(corner, i))
                    overlap[i] = std::min(overlap[i], outside(corner, i));
            }
    }
    share(overlap, 1);
    for (std::size_t i = 0; i < gap.size(); ++i)
        if (closed[i] && gap[i] <= 0.0)
            gap[i] = has_both_on_one_side(i) ? 0.0 : std::min(0.0, std::max(gap[i], overlap[i]));
}

// How far along its normal a node has weight: the d of (C4), docs/adr/0007-reach-of-a-node.md.
void ContactPair::find_reaches() {
    for (std::size_t i = 0; i < reach.size(); ++i)
        for (std::size_t d = 0; d < 3; ++d)
            reach[i] += std::abs(normal[3 * i + d]) * spacing[3 * i + d];
}

// A node that pressed in the step before is left to the velocities alone, unless the gap is half its reach.
void ContactPair::find_gates() {
    for (std::size_t i = 0; i < gap.size(); ++i) {
        const bool is_close = gap[i] < 0.5 * reach[i];
        gate_gap[i] = touched[static_cast<std::size_t>(active[i])] && is_close
                          ? std::fmin(gap[i], 0.0)
                          : gap[i];
    }
}

void ContactPair::remember() {
    std::fill(touched.begin(), touched.end(), 0);
    for (std::size_t i = 0; i < active.size(); ++i)
        touched[static_cast<std::size_t>(active[i])] = reports[i].penalty_factor > 0.0;
}

void ContactPair::correct(Model& model) {
    found = {};
    step_size = model.dt;
    step_totals = {};
    step_totals.struct_size = sizeof step_totals;
    step_measured = {};
    step_measured.largest_gap = NAN;
    const bool any = find_active(model);
    if (any) {
        copy_nodes(model);
        find_normals();
        find_pore_impulses();
        const bool geo = pair_law.options.law == GRIT_CONTACT_GEO;
        if (geo || pair_law.gated) {
            near.find(model.grid(), active);
            find_reaching(model);
            find_surfaces();
            grit_error error;
            grit_contact_surfaces s = surfaces(surface);
            s.centre = grit_mutable_view_of(centre.data(), 2, 1);
            grit_contact_distances wanted{};
            wanted.struct_size = sizeof wanted;
            wanted.measure = pair_law.measure;
            wanted.distance = grit_mutable_view_of(distance.data(), 1, 1);
            wanted.gap = grit_mutable_view_of(gap.data(), 1, 1);
            require(grit_contact_surfaces_finish(&s, s.nodes, &wanted, &error), error, "contact");
            if (pair_law.gated) part_corners();
            if (pair_law.options.contact_stiffness > 0.0) find_overlaps();
            find_reaches();
            find_gates();
        }
        apply(model);
        write_back(model);
    }
    remember();
}

grit_contact_options ContactPair::options_of(const Model& model) const {
    grit_contact_options options = pair_law.options;
    options.time_step = model.dt;
    options.rigid = model.parts[pair_law.a].body.rigid()   ? GRIT_CONTACT_A_RIGID
                    : model.parts[pair_law.b].body.rigid() ? GRIT_CONTACT_B_RIGID
                                                           : GRIT_CONTACT_NONE_RIGID;
    return options;
}

// What the stiffer body's surface has of a node's weight, across the normal, is the area of a stiffness: its gradient
// is the integral of the weight over the surface.
grit_contact_nodes ContactPair::nodes_of() {
    grit_contact_nodes q{};
    q.struct_size = sizeof q;
    q.mass_a = grit_view_of(mass_a.data(), 1, 1);
    q.mass_b = grit_view_of(mass_b.data(), 1, 1);
    q.normal = grit_view_of(normal.data(), 3, 1);
    if (pair_law.options.law == GRIT_CONTACT_GEO) {
        q.distance = grit_view_of(distance.data(), 1, 1);
        q.cell_size = grit_view_of(reach.data(), 1, 1);
    }
    if (pair_law.gated) q.gap = grit_view_of(gate_gap.data(), 1, 1);
    if (pair_law.options.contact_stiffness > 0.0) {
        for (std::size_t i = 0; i < area.size(); ++i)
            area[i] = std::fabs(dot(Vector3{slope_a[slope::size * i], slope_a[slope::size * i + 1],
                                            slope_a[slope::size * i + 2]},
                                    at(normal, i)));
        q.contact_area = grit_view_of(area.data(), 1, 1);
    }
    q.velocity_a = grit_mutable_view_of(motion_a.data() + motion::v_x, motion::size, 1);
    q.velocity_b = grit_mutable_view_of(motion_b.data() + motion::v_x, motion::size, 1);
    q.previous_velocity_a = grit_view_of(motion_a.data() + motion::other_x, motion::size, 1);
    q.previous_velocity_b = grit_view_of(motion_b.data() + motion::other_x, motion::size, 1);
    q.position = grit_view_of(position.data(), 3, 1);
    if (!pore_impulse.empty()) q.pore_impulse = grit_view_of(pore_impulse.data(), 1, 1);
    return q;
}

// What presses out of a body, along the normal: the mean of both, where both have water.
void ContactPair::find_pore_impulses() {
    const bool wet_a = !pores_a.empty(), wet_b = !pores_b.empty();
    pore_impulse.assign(wet_a || wet_b ? active.size() : 0, 0.0);
    const double share = step_size * (wet_a && wet_b ? 0.5 : 1.0);
    for (std::size_t i = 0; i < pore_impulse.size(); ++i) {
        const Vector3 n = at(normal, i);
        if (wet_a) pore_impulse[i] += share * dot(pores_a[i], n);
        if (wet_b) pore_impulse[i] -= share * dot(pores_b[i], n);
    }
}

// A rigid body that contact moves has the velocity which the impulses that belong to it leave, found by Newton's method
// with steps that bring it nearer, along the symmetric slopes where the others do not. What rubs so that none is found
// rubs not at all in this step: then there is one, and neither gives energy.
grit_contact_options ContactPair::meet_freely(const Model& model,
                                              const grit_contact_options& options) {
    const bool is_a = options.rigid == GRIT_CONTACT_A_RIGID;
    const RigidMotion& rigid = *model.parts[is_a ? pair_law.a : pair_law.b].body.motion;
    found = rigid.velocity();
    if (!rigid.any_free()) return options;
    grit_contact_options law = options;
    if (meet_freely(rigid, is_a, law)) return law;
    law.friction_coefficient = law.adhesion = 0.0;
    meet_freely(rigid, is_a, law);
    return law;
}

// Whether a velocity is found.
bool ContactPair::meet_freely(const RigidMotion& rigid, bool is_a,
                              const grit_contact_options& law) {
    std::vector<double>&own = is_a ? motion_a : motion_b, &other = is_a ? motion_b : motion_a;
    const std::vector<double>& mass = is_a ? mass_b : mass_a;
    other_start = other;
    FreeMeeting meeting(rigid, fixed_point);
    const double sign = is_a ? 1.0 : -1.0;
    const auto look = [&](const Row& u, FreeMeeting::Slope slope) {
        found = twist_of(u);
        for (std::size_t i = 0; i < active.size(); ++i) {
            const Vector3 v =
                found.along + baseline::cross(found.about, at(position, i) - rigid.centre());
            std::copy_n(v.c, 3, &own[motion::size * i]);
        }
        correct_nodes(law, nullptr);
        other = other_start;
        meeting.begin(u);
        for (std::size_t i = 0; i < counted; ++i) {
            const grit_contact_report& r = reports[i];
            if (r.state != GRIT_CONTACT_STICK && r.state != GRIT_CONTACT_SLIP) continue;
            Vector3 w;
            for (std::size_t k = 0; k < 3; ++k)
                w[static_cast<int>(k)] =
                    own[motion::size * i + k] - other_start[motion::size * i + k];
            meeting.add(at(position, i), sign * at(normal, i), w,
                        sign * Vector3{r.impulse[0], r.impulse[1], r.impulse[2]}, mass[i],
                        r.penalty_factor, law.friction_coefficient, slope);
        }
        meeting.finish(exchange);
    };
    constexpr int most_steps = 40, most_halvings = 8;
    constexpr double enough = 1e-20, near_enough = 1e-12;  // of the energy of what contact did
    Row u = meeting.start();
    look(u, FreeMeeting::Slope::tangent);
    for (int step = 0; step < most_steps; ++step) {
        const double off = meeting.off();
        if (!(off > enough * meeting.moved())) return true;
        bool nearer = false;
        for (const auto slope : {FreeMeeting::Slope::tangent, FreeMeeting::Slope::secant}) {
            if (slope == FreeMeeting::Slope::secant) look(u, slope);
            const Row way = meeting.step();
            double part = 1.0;
            for (int k = 0; k < most_halvings && !nearer; ++k, part *= 0.5) {
                look(u + part * way, FreeMeeting::Slope::tangent);
                nearer = meeting.off() < (1.0 - 0.1 * part) * off;
                if (nearer) u += part * way;
            }
            if (nearer) break;
        }
        if (!nearer) look(u, FreeMeeting::Slope::tangent);
        if (!nearer) break;
    }
    return meeting.off() <= near_enough * meeting.moved();
}

void ContactPair::apply(const Model& model) {
    const bool geo = pair_law.options.law == GRIT_CONTACT_GEO;
    grit_contact_options options = options_of(model);
    if (options.rigid != GRIT_CONTACT_NONE_RIGID) options = meet_freely(model, options);
    grit_contact_sums sums{};
    correct_nodes(options, &sums);
    exchange.sum(sums.word, GRIT_CONTACT_SUMS_WORDS);
    grit_error error;
    require(grit_contact_sums_read(&sums, &step_totals), error, "contact");
    std::array<Total, 6> sums_of;
    double largest = -far;
    for (std::size_t i = 0; i < counted; ++i) {
        const Vector3 n = at(normal, i);
        const std::size_t first = std::fabs(n[2]) > std::hypot(n[0], n[1]) ? 3 : 0;
        for (std::size_t k = 0; k < 3; ++k)
            sums_of[first + k].add(reports[i].force[k], fixed_point);
        if ((geo || pair_law.gated) && std::isfinite(gap[i])) largest = std::max(largest, gap[i]);
    }
    exchange.sum(sums_of, fixed_point);
    exchange.max(&largest, 1);
    if (std::isfinite(largest)) step_measured.largest_gap = largest;
    for (std::size_t k = 0; k < 3; ++k) {
        step_measured.sideways[static_cast<int>(k)] = sums_of[k].value();
        step_measured.along_z[static_cast<int>(k)] = sums_of[k + 3].value();
    }
}

// Of those that another process counts, too; sums: of the others, null: none are wanted.
void ContactPair::correct_nodes(const grit_contact_options& options, grit_contact_sums* sums) {
    grit_contact_nodes q = nodes_of();
    const auto first = static_cast<std::ptrdiff_t>(counted);
    const auto all = static_cast<std::ptrdiff_t>(active.size());
    q.index = places.data();
    grit_error error;
    require(grit_contact_correct(&options, first, &q, reports.data(), sums, &error), error,
            "contact");
    if (first == all) return;
    q.index += first;
    require(
        grit_contact_correct(&options, all - first, &q, reports.data() + first, nullptr, &error),
        error, "contact");
}

Twist ContactPair::impulse_on(std::size_t body, const Vector3& about) const {
    const bool is_a = body == pair_law.a;
    const double* J = is_a ? step_totals.impulse_on_a : step_totals.impulse_on_b;
    const double* M = is_a ? step_totals.moment_on_a : step_totals.moment_on_b;
    const Vector3 impulse{J[0], J[1], J[2]};
    return {impulse, step_size * Vector3{M[0], M[1], M[2]} - baseline::cross(about, impulse)};
}

void ContactPair::write_back(Model& model) const {
    for (std::size_t i = 0; i < active.size(); ++i) {
        const auto node = static_cast<std::size_t>(active[i]);
        std::copy_n(&motion_a[motion::size * i], 3, model.parts[pair_law.a].motions[node].value);
        std::copy_n(&motion_b[motion::size * i], 3, model.parts[pair_law.b].motions[node].value);
    }
}

}  // namespace grit::mpm::space
