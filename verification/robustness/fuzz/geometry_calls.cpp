// SPDX-License-Identifier: BSD-3-Clause
// Contact where it needs shapes: lines, surfaces, domains of particles, normals, STL files. The first letter says which. What is
// returned is finite; what fails has changed nothing.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <adapters/mpm/case/closed_surface.hpp>
#include <grit/grit.h>

#include "robustness/fuzz/bytes.hpp"
#include "robustness/fuzz/refusal.hpp"

namespace {

using fuzz::Bytes;
using fuzz::demand;

// A call that asks for more is not made again.
constexpr std::size_t largest_workspace = std::size_t{1} << 22;

struct Field {
    std::vector<double> memory;
    std::ptrdiff_t size;

    Field(std::ptrdiff_t points, std::ptrdiff_t components)
        : memory(static_cast<std::size_t>(points * components)), size(components) {}
    Field(Bytes& in, std::ptrdiff_t points, std::ptrdiff_t components, double usual)
        : Field(points, components) {
        for (double& each : memory) each = in.number(usual);
    }
    double& at(std::ptrdiff_t i, std::ptrdiff_t c) {
        return memory[static_cast<std::size_t>(i * size + c)];
    }
    grit_view in() const { return grit_view_of(memory.data(), size, 1); }
    grit_mutable_view out() { return grit_mutable_view_of(memory.data(), size, 1); }
    bool is_finite() const {
        return std::all_of(memory.begin(), memory.end(), [](double x) { return std::isfinite(x); });
    }
    // NaN is itself.
    bool is(const Field& other) const {
        return std::memcmp(memory.data(), other.memory.data(), memory.size() * sizeof(double)) == 0;
    }
};

// As large as it is said to be, of any contents.
class Workspace {
  public:
    Workspace(Bytes& in, std::size_t right)
        : bytes(in.one_in(16) ? right / 2 : right), memory((bytes + 7) / 8, 0.1) {
        demand(right <= largest_workspace);
    }
    void* at() { return memory.data(); }
    std::size_t size() const { return bytes; }

  private:
    std::size_t bytes;
    std::vector<double> memory;
};

std::size_t size_of(Bytes& in, std::size_t right) {
    return in.one_in(32) ? static_cast<std::size_t>(in.byte()) : right;
}

// Mostly i.
std::ptrdiff_t id(Bytes& in, std::ptrdiff_t i) {
    return in.one_in(32) ? in.raw<std::ptrdiff_t>() : i;
}

grit_status told(grit_status status, const grit_error& error) {
    demand(status >= GRIT_OK && status <= GRIT_NOT_CONVERGED);
    if (status != GRIT_OK) {
        demand(std::memchr(error.message, 0, sizeof error.message) != nullptr);
        fuzz::refusal = error.message;
    }
    return status;
}

// Corners around (1.5, z), the body on the left of the way along them.
Field ring(Bytes& in, std::ptrdiff_t corners, double z) {
    Field out(corners, 2);
    for (std::ptrdiff_t i = 0; i < corners; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        out.at(i, 0) = in.number(1.5 + std::cos(angle));
        out.at(i, 1) = in.number(z + std::sin(angle));
    }
    return out;
}

// ---- lines -------------------------------------------------------------------------------------

struct Line {
    std::ptrdiff_t count;
    Field position, velocity, history, force, stiffness;
    std::vector<grit_penalty_report> reports;
    fuzz::Padded<grit_penalty_surface> surface;

    Line(Bytes& in, double z)
        : count(3 + in.below(14)), position(ring(in, count, z)), velocity(in, count, 2, 0.1),
          history(count, GRIT_PENALTY_HISTORY_SIZE), force(count, 2), stiffness(count, 1),
          reports(static_cast<std::size_t>(count)) {
        if (in.one_in(2))
            for (double& each : history.memory) each = in.number(1.0);
        grit_penalty_surface& out = surface.here;
        out.struct_size = size_of(in, sizeof out);
        out.closed = in.one_in(4) ? 0 : 1;
        out.count = in.one_in(32) ? in.below(4) - 1 : count;
        out.position = position.in();
        if (!in.one_in(16)) out.velocity = velocity.in();
        if (!in.one_in(16)) out.history = history.out();
        out.force = force.out();
        if (!in.one_in(4)) out.stiffness = stiffness.out();
        if (!in.one_in(4)) out.reports = reports.data();
    }
};

void penalty_forces(Bytes& in) {
    fuzz::Padded<grit_penalty_options> later;
    grit_penalty_options& options = later.here;
    grit_penalty_options_init(&options, sizeof options);
    options.struct_size = size_of(in, sizeof options);
    options.axisymmetric = in.below(2);
    options.validate_only = in.one_in(8);
    options.normal_stiffness = in.number(1e6);
    if (in.one_in(4)) options.tangential_stiffness = in.number(1e5);
    options.friction_coefficient = in.one_in(4) ? 0.0 : in.number(0.3);
    options.depth_max = in.number(0.3);
    options.time_step = in.number(1e-3);
    Line a(in, 1.0), b(in, 2.9);
    const Field old_a = a.history, old_b = b.history, nothing_a = a.force, nothing_b = b.force;
    Workspace room(in, grit_penalty_workspace_size(a.count, b.count));
    grit_penalty_totals totals{};
    totals.struct_size = sizeof totals;
    grit_error error{};
    const grit_status status = grit_penalty_forces(&options, &a.surface.here, &b.surface.here,
                                                   room.at(), room.size(), &totals, &error);
    if (told(status, error) == GRIT_OK) {
        demand(a.force.is_finite() && b.force.is_finite());
        demand(a.stiffness.is_finite() && b.stiffness.is_finite());
        demand(std::isfinite(totals.normal_force) && std::isfinite(totals.dissipation));
    }
    if (status != GRIT_OK || options.validate_only) {
        demand(a.force.is(nothing_a) && b.force.is(nothing_b));
        demand(a.history.is(old_a) && b.history.is(old_b));
    }
}

void penalty_remesh(Bytes& in) {
    const std::ptrdiff_t count = 3 + in.below(14), capacity = 1 + in.byte();
    Field position = ring(in, count, 1.0), history(in, count, GRIT_PENALTY_HISTORY_SIZE, 1.0),
          new_position(capacity, 2), new_history(capacity, GRIT_PENALTY_HISTORY_SIZE);
    std::vector<std::ptrdiff_t> parents(static_cast<std::size_t>(2 * capacity));
    std::vector<double> weight(static_cast<std::size_t>(capacity));
    fuzz::Padded<grit_penalty_remeshing> later;
    grit_penalty_remeshing& how = later.here;
    how.struct_size = size_of(in, sizeof how);
    how.closed = in.one_in(4) ? 0 : 1;
    how.longest = in.number(0.3);
    how.shortest = in.number(0.1);
    how.tolerance = in.number(0.05);
    how.count = in.one_in(32) ? in.below(4) - 1 : count;
    how.position = position.in();
    if (in.one_in(2)) how.history = history.in(), how.new_history = new_history.out();
    how.capacity = capacity;
    how.new_position = new_position.out();
    how.parents = parents.data();
    how.weight = weight.data();
    Workspace room(in, grit_penalty_remesh_workspace_size(count));
    std::ptrdiff_t new_count = 0;
    grit_error error{};
    const Field nothing = new_position;
    if (told(grit_penalty_remesh(&how, room.at(), room.size(), &new_count, &error), error) !=
        GRIT_OK) {
        demand(new_position.is(nothing));
        return;
    }
    demand(new_count >= 2 && new_count <= capacity && new_position.is_finite());
    for (std::size_t i = 0; i < static_cast<std::size_t>(new_count); ++i) {
        demand(weight[i] >= 0.0 && weight[i] <= 1.0);
        for (std::size_t k = 2 * i; k < 2 * i + 2; ++k)
            demand(parents[k] >= 0 && parents[k] < how.count);
    }
}

// ---- surfaces ----------------------------------------------------------------------------------

// Each vertex rides on a node of its own and a bit on the next one.
struct Skin {
    int components;
    std::ptrdiff_t count;
    Field position;
    std::vector<std::ptrdiff_t> facet, node;
    std::vector<double> weight, spacing, pore_pressure;
    std::vector<int> fixed;
    Field mass, velocity, previous, pores, seepage;
    fuzz::Padded<grit_surface> surface;

    Skin(Bytes& in, int c, double z, double speed)
        : components(c), count(c == 3 ? 6 : 3 + in.below(10)),
          position(c == 3 ? octahedron(in, z) : ring(in, count, z)), mass(in, count, 1, 2.0),
          velocity(in, count, c, speed), previous(in, count, c, 0.5), pores(in, count, 3, 0.4),
          seepage(in, count, c, 0.01) {
        add_facets(in);
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            node.insert(node.end(), {id(in, i), id(in, (i + 1) % count)});
            const double own = in.one_in(16) ? in.number(0.75) : 0.75;
            weight.insert(weight.end(), {own, 1.0 - own});
            fixed.push_back(in.one_in(8) ? in.byte() % 8 : 0);
        }
        const auto facets = static_cast<std::ptrdiff_t>(facet.size()) / components;
        for (std::ptrdiff_t i = 0; i < facets; ++i) {
            spacing.push_back(in.number(0.5));
            pore_pressure.push_back(in.number(10.0));
        }
        grit_surface& out = surface.here;
        out.struct_size = size_of(in, sizeof out);
        out.rigid = in.one_in(4);
        out.nodes_each = 2;
        out.vertices = count;
        out.facets = facets;
        out.position = position.in();
        out.facet = facet.data();
        out.node = node.data();
        out.weight = weight.data();
        out.nodes = count;
        out.mass = mass.in();
        if (in.one_in(2)) out.fixed = fixed.data();
        out.velocity = velocity.out();
        if (in.one_in(2)) out.previous_velocity = previous.in();
        out.vertex_velocity = previous.in();
        if (in.one_in(4)) out.spacing = spacing.data();
        if (in.one_in(4)) out.pores = pores.in(), out.seepage = seepage.out();
        if (in.one_in(4)) out.pore_pressure = pore_pressure.data();
    }
    static Field octahedron(Bytes& in, double z) {
        Field out(6, 3);
        for (std::ptrdiff_t i = 0; i < 6; ++i)
            for (std::ptrdiff_t d = 0; d < 3; ++d) {
                const double side = i / 2 == d ? (i % 2 == 0 ? 1.0 : -1.0) : 0.0;
                out.at(i, d) = in.number((d == 2 ? z : 1.5) + side);
            }
        return out;
    }
    void add_facets(Bytes& in) {
        if (components == 2)
            for (std::ptrdiff_t i = 0; i < count; ++i)
                facet.insert(facet.end(), {id(in, i), id(in, (i + 1) % count)});
        else
            for (std::ptrdiff_t i = 0; i < 8; ++i) {
                std::ptrdiff_t x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2);
                if ((x + y + z) % 2 != 0) std::swap(x, y);
                facet.insert(facet.end(), {id(in, x), id(in, y), id(in, z)});
            }
    }
};

void surface_correct(Bytes& in) {
    const int c = 2 + in.below(2);
    fuzz::Padded<grit_surface_options> later;
    grit_surface_options& options = later.here;
    grit_surface_options_init(&options, sizeof options);
    options.struct_size = size_of(in, sizeof options);
    options.components = c;
    options.axisymmetric = in.one_in(4);
    options.validate_only = in.one_in(8);
    options.sweep_limit = 1 + in.byte();
    if (in.one_in(4)) options.sweep_tolerance = in.number(1e-6);
    options.friction_coefficient = in.number(0.3);
    options.time_step = in.number(1e-2);
    options.spacing = in.number(0.5);
    options.reach = in.number(0.3);
    if (in.one_in(4)) options.end_spacings = in.number(2.0);
    if (in.one_in(4)) options.contact_stiffness = in.number(1e4);
    if (in.one_in(4)) options.relaxation_time = in.number(1e-3);
    Skin a(in, c, 1.0, 1.0), b(in, c, 2.9, -1.0);
    const Field old_a = a.velocity, old_b = b.velocity;
    Workspace room(in, grit_surface_workspace_size(&a.surface.here, &b.surface.here));
    std::vector<grit_surface_report> reports(a.facet.size() / static_cast<std::size_t>(c));
    grit_surface_totals totals{};
    totals.struct_size = sizeof totals;
    grit_error error{};
    std::size_t needed = 0;
    const auto correct = [&](void* at, std::size_t bytes) {
        return grit_surface_correct(&options, &a.surface.here, &b.surface.here, at, bytes, &needed,
                                    reports.data(), &totals, &error);
    };
    grit_status status = correct(room.at(), room.size());
    if (status != GRIT_OK && needed > 0 && needed <= largest_workspace) {
        std::vector<double> more(needed / 8 + 1, 0.1);
        status = correct(more.data(), needed);
    }
    if (told(status, error) == GRIT_OK) {
        if (!a.surface.here.rigid) demand(a.velocity.is_finite() || !old_a.is_finite());
        if (!b.surface.here.rigid) demand(b.velocity.is_finite() || !old_b.is_finite());
        demand(std::isfinite(totals.normal_impulse) && std::isfinite(totals.area));
    }
    if (status != GRIT_OK || options.validate_only) {
        demand(a.velocity.is(old_a) && b.velocity.is(old_b));
    }
}

void surface_find_free(Bytes& in) {
    const std::ptrdiff_t n = 1 + in.below(16);
    Field position(n, 2), side(n, 4);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        position.at(i, 0) = in.number(static_cast<double>(i % 4));
        position.at(i, 1) = in.number(std::floor(0.25 * static_cast<double>(i)));
        for (std::ptrdiff_t k = 0; k < 4; ++k) side.at(i, k) = in.number(k % 3 == 0 ? 0.5 : 0.0);
    }
    std::vector<std::ptrdiff_t> index;
    for (std::ptrdiff_t i = 0; i < n; ++i) index.push_back(id(in, n - 1 - i));
    fuzz::Padded<grit_surface_domains> later;
    grit_surface_domains& domains = later.here;
    domains.struct_size = size_of(in, sizeof domains);
    domains.n = n;
    // An entry is not looked at but to find its particle: those that are not there are not given.
    const bool are_there =
        std::all_of(index.begin(), index.end(), [n](std::ptrdiff_t i) { return i >= 0 && i < n; });
    if (in.one_in(2) && are_there) domains.index = index.data();
    domains.position = position.in();
    domains.side = grit_matrix_view_of(side.memory.data(), 4, 2, 1);
    domains.tolerance = in.number(0.05);
    Workspace room(in, grit_surface_find_free_workspace_size(n));
    Field found(4 * n, 2);
    std::vector<std::ptrdiff_t> facet(static_cast<std::size_t>(8 * n)),
        owner(static_cast<std::size_t>(4 * n));
    std::ptrdiff_t vertices = 0, facets = 0;
    grit_error error{};
    if (told(grit_surface_find_free(&domains, room.at(), room.size(), found.memory.data(),
                                    facet.data(), owner.data(), &vertices, &facets, &error),
             error) != GRIT_OK)
        return;
    demand(vertices >= 0 && vertices <= 4 * n && facets >= 0 && facets <= 4 * n);
    demand(found.is_finite());
    for (std::size_t i = 0; i < static_cast<std::size_t>(facets); ++i) {
        demand(owner[i] >= 0 && owner[i] < n);
        for (std::size_t k = 2 * i; k < 2 * i + 2; ++k)
            demand(facet[k] >= 0 && facet[k] < vertices);
    }
}

// ---- nodes and the particles around them ---------------------------------------------------------

void distances(Bytes& in) {
    const int c = 2 + in.below(2);
    const std::ptrdiff_t nodes = 1 + in.below(9), particles = 1 + in.below(9);
    constexpr std::ptrdiff_t each = 4;
    Field place(in, nodes, c, 1.0), normal(nodes, c), surface(nodes, 2), centre(nodes, 2);
    for (std::ptrdiff_t i = 0; i < nodes; ++i)
        if (in.one_in(8)) normal.at(i, in.below(c)) = in.number(0.5);
        else normal.at(i, i % c) = 1.0;
    fuzz::Padded<grit_contact_surfaces> later;
    grit_contact_surfaces& surfaces = later.here;
    surfaces.struct_size = size_of(in, sizeof surfaces);
    surfaces.components = c;
    surfaces.nodes = nodes;
    surfaces.position = place.in();
    surfaces.normal = normal.in();
    surfaces.surface = surface.out();
    if (!in.one_in(4)) surfaces.centre = centre.out();
    grit_error error{};
    if (!in.one_in(16)) told(grit_contact_surfaces_reset(&surfaces, &error), error);
    for (int body = 0; body < 2; ++body) {
        Field position(in, particles, c, body == 0 ? 0.8 : 1.3), side(in, particles, 3 * c, 0.1);
        std::vector<std::ptrdiff_t> node;
        for (std::ptrdiff_t i = 0; i < particles * each; ++i) node.push_back(id(in, i % nodes));
        fuzz::Padded<grit_contact_domains> here;
        grit_contact_domains& domains = here.here;
        domains.struct_size = size_of(in, sizeof domains);
        domains.body = in.one_in(16) ? in.below(4) - 1 : body;
        domains.sides = in.one_in(16) ? in.byte() : c;
        domains.nodes_each = each;
        domains.node = node.data();
        domains.position = position.in();
        domains.side = grit_matrix_view_of(side.memory.data(), 3 * c, c, 1);
        told(grit_contact_surfaces_add(&surfaces, particles, &domains, &error), error);
    }
    Field distance(nodes, 1), gap(nodes, 1);
    fuzz::Padded<grit_contact_distances> wanted;
    grit_contact_distances& what = wanted.here;
    what.struct_size = size_of(in, sizeof what);
    what.stiffer = in.below(2);
    what.measure = in.below(surfaces.centre.base ? 3 : 2);
    if (!in.one_in(4)) what.distance = distance.out();
    if (!in.one_in(4)) what.gap = gap.out();
    const auto is_one = [](double x) { return x > -INFINITY; };
    if (told(grit_contact_surfaces_finish(&surfaces, nodes, &what, &error), error) == GRIT_OK) {
        demand(std::all_of(distance.memory.begin(), distance.memory.end(), is_one));
        demand(std::all_of(gap.memory.begin(), gap.memory.end(), is_one));
    }
}

// Unit normals and zeros, or what was there.
void check_normals(Field& normal, const std::vector<grit_status>& status, int components) {
    for (std::size_t i = 0; i < status.size(); ++i) {
        double sum = 0.0;
        for (int k = 0; k < components; ++k) {
            const double n = normal.at(static_cast<std::ptrdiff_t>(i), k);
            sum += n * n;
        }
        if (status[i] == GRIT_OK) demand(sum == 0.0 || std::fabs(sum - 1.0) < 1e-9);
    }
}

void normals_from_gradients(Bytes& in) {
    const int c = 2 + in.below(2);
    const std::ptrdiff_t n = 1 + in.below(12);
    Field a(in, n, c, 1.0), b(in, n, c, -0.7), given(in, n, c, 0.3), scale(in, n, 1, 1.0),
        normal(n, c);
    std::vector<int> fixed;
    for (std::ptrdiff_t i = 0; i < n; ++i) fixed.push_back(in.one_in(4) ? in.byte() % 10 : 0);
    std::vector<grit_status> status(static_cast<std::size_t>(n));
    fuzz::Padded<grit_contact_gradients> later;
    grit_contact_gradients& gradients = later.here;
    gradients.struct_size = size_of(in, sizeof gradients);
    gradients.components = c;
    gradients.source = in.below(in.one_in(16) ? 100 : 4);
    gradients.gradient_a = a.in();
    gradients.gradient_b = b.in();
    gradients.given = given.in();
    if (in.one_in(2)) gradients.scale = scale.in();
    if (in.one_in(4)) gradients.threshold = in.number(1e-8);
    if (in.one_in(2)) gradients.fixed = fixed.data();
    gradients.status = status.data();
    gradients.normal = normal.out();
    grit_contact_normal_counts counts{};
    counts.struct_size = sizeof counts;
    grit_error error{};
    told(grit_contact_normals_from_gradients(n, &gradients, &counts, &error), error);
    check_normals(normal, status, c);
}

void normals_by_regression(Bytes& in) {
    const int c = 2 + in.below(2);
    const std::ptrdiff_t n = 1 + in.below(4), each = 1 + in.below(12), particles = n * each;
    Field position(particles, c), weight(in, particles, 1, 0.25), normal(n, c);
    std::vector<std::ptrdiff_t> offset, particle;
    std::vector<int> body, fixed;
    for (std::ptrdiff_t p = 0; p < particles; ++p) {
        body.push_back(in.one_in(32) ? in.raw<int>() : static_cast<int>(p % 2));
        for (int k = 0; k < c; ++k)
            position.at(p, k) = in.number(k == 0 ? 1.0 + 0.3 * static_cast<double>(p % 2)
                                                 : 0.2 * static_cast<double>((p + k) % 5));
        particle.push_back(id(in, particles - 1 - p));
    }
    for (std::ptrdiff_t i = 0; i <= n; ++i) offset.push_back(i * each);
    for (std::ptrdiff_t i = 0; i < n; ++i) fixed.push_back(in.one_in(8) ? in.byte() % 10 : 0);
    std::vector<grit_status> status(static_cast<std::size_t>(n));
    fuzz::Padded<grit_contact_clouds> later;
    grit_contact_clouds& clouds = later.here;
    clouds.struct_size = size_of(in, sizeof clouds);
    clouds.components = c;
    if (in.one_in(16)) clouds.instruction_set = in.raw<int>();
    clouds.offset = offset.data();
    if (in.one_in(2)) clouds.particle = particle.data();
    clouds.particles = particles;
    clouds.position = position.in();
    clouds.body = body.data();
    if (in.one_in(2)) clouds.weight = weight.in();
    clouds.length = in.number(1.0);
    if (in.one_in(4)) clouds.ridge = in.number(1e-3);
    clouds.iteration_limit = in.one_in(8) ? in.below(20) : 0;
    if (in.one_in(2)) clouds.fixed = fixed.data();
    clouds.status = status.data();
    clouds.normal = normal.out();
    Workspace room(in, grit_contact_regression_workspace_size(each, c));
    grit_contact_normal_counts counts{};
    counts.struct_size = sizeof counts;
    grit_error error{};
    told(grit_contact_normals_by_regression(n, &clouds, room.at(), room.size(), &counts, &error),
         error);
    check_normals(normal, status, c);
}

// ---- files ---------------------------------------------------------------------------------------

void stl(Bytes& in) {
    using grit::mpm::surface_of_stl;
    const double unit = in.number(1.0);
    const grit::Vector3 none{0.0, 0.0, 0.0}, moved{in.number(0.0), 0.0, in.number(0.0)},
        place{in.number(0.25), in.number(0.25), in.number(0.25)};
    try {
        const grit::mpm::ClosedSurface surface = surface_of_stl(in.rest(), "x.stl", unit, moved);
        surface.has(place);
        const grit::mpm::ClosedSurface again =
            surface_of_stl(grit::mpm::stl_text(surface), "x.stl", 1.0, none);
        demand(again.size() == surface.size() && again.has(place) == surface.has(place));
        for (int d = 0; d < 3; ++d)
            demand(again.from()[d] == surface.from()[d] && again.to()[d] == surface.to()[d]);
    } catch (const std::invalid_argument& refused) {
        fuzz::refusal = refused.what();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr void (*calls[])(Bytes&) = {
        penalty_forces, penalty_remesh,         surface_correct,       surface_find_free,
        distances,      normals_from_gradients, normals_by_regression, stl};
    Bytes in(data, size);
    calls[in.below(static_cast<int>(std::size(calls)))](in);
    return 0;
}
