// SPDX-License-Identifier: BSD-3-Clause
// grit_surface_correct: where the surfaces meet, what carries the pressure, which impulses close the gap;
// grit_surface_correct_pairs: of several pairs together.
#include <new>

#include "contact/surface/ascending.hpp"
#include "contact/surface/call_checks.hpp"
#include "contact/surface/coupling.hpp"

namespace grit::surface {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Share of the reach: points that are nearer count in the mean gap. Without them a pressure would act on what has
// touched last, and lift off what rested there before: a curved surface would be printed with the path of its contact.
constexpr double closed = 0.02;

// A pair that a call has read and found to be sound.
struct Given {
    grit_surface_options options;
    grit_surface surface[2];
    grit_surface_report* reports;
    grit_surface_totals* totals;
};

// One pair, of so many components.
template <int C> class Pair {
  public:
    Pair(const Given& given, Arena& memory)
        : o(given.options), arena(memory),
          a(read_skin<C>(memory, given.surface[0], given.options.spacing)),
          b(read_skin<C>(memory, given.surface[1], given.options.spacing)),
          pressures(memory, a, o.spacing, o.end_spacings), system(memory, a, b, pressures) {}

    // Its rows; false where the workspace is too small.
    bool find_rows() {
        return !arena.is_overrun() && find_points() && find_shares() &&
               system.build(points, n_points, shares, n_shares, layer) && system.make_lists();
    }
    Sweeping<C> sweeping() {
        return {&system, o.friction_coefficient, o.sweep_limit, o.sweep_tolerance};
    }

    void report(grit_surface_report* reports) const {
        const double dt = o.time_step;
        for (std::ptrdiff_t f = 0; f < a.given->facets; ++f)
            reports[f] = {0.0, smallest_gap[f], 0.0, 0.0, {}};
        for (std::ptrdiff_t p = 0; p < n_points; ++p)
            reports[points[p].facet_a].area += points[p].size;
        auto* along = friction;
        std::fill_n(along, a.given->facets, Vector<double, C>{});
        system.each_row([&](const Row<C>& row) {
            const auto add = [&](const MeetingPoint<C>& p, double share,
                                 const Directions<C>& direction) {
                const double size = share * p.size / dt;
                const auto normal = size * system.traction(row, direction, 0, 1);
                const auto tangential = size * system.traction(row, direction, 1, C);
                grit_surface_report& r = reports[p.facet_a];
                r.normal_force -= dot(normal, a.facet[p.facet_a].n);
                along[p.facet_a] = along[p.facet_a] + tangential;
                for (int c = 0; c < C; ++c) r.force[c] += normal[c] + tangential[c];
            };
            system.each_share(row.pressure, add);
        });
        for (std::ptrdiff_t f = 0; f < a.given->facets; ++f)
            reports[f].friction_force = norm(along[f]);
    }
    grit_surface_totals totals(const Swept& outcome) const {
        grit_surface_totals t{};
        t.smallest_gap = infinite;
        for (std::ptrdiff_t f = 0; f < a.given->facets; ++f)
            t.smallest_gap = std::min(t.smallest_gap, smallest_gap[f]);
        for (std::ptrdiff_t p = 0; p < n_points; ++p) t.area += points[p].size;
        const bool has_old = (a.given->rigid || a.given->previous_velocity.base) &&
                             (b.given->rigid || b.given->previous_velocity.base);
        system.each_row([&](const Row<C>& row) {
            t.normal_impulse += row.impulse[0];
            t.pressures += row.impulse[0] > 0.0;
            const Vector2 work = has_old ? system.dissipation(row) : Vector2{0.0, 0.0};
            t.dissipation_normal += work[0];
            t.dissipation_tangential += work[1];
            const auto add = [&](const MeetingPoint<C>& p, double share,
                                 const Directions<C>& direction) {
                const auto impulse = share * p.size * system.traction(row, direction, 0, C);
                for (int c = 0; c < C; ++c) t.impulse_on_a[c] += impulse[c];
            };
            system.each_share(row.pressure, add);
        });
        for (int c = 0; c < C; ++c) t.impulse_on_b[c] = -t.impulse_on_a[c];
        t.largest_approach = outcome.largest_approach;
        t.residual = outcome.residual;
        t.sweeps = outcome.sweeps;
        t.points = n_points;
        system.fill_lists();
        system.list(&t.row, &t.term, &t.rows);
        return t;
    }
    void write() const { system.write(); }

  private:
    // Where B's facets may lie. In space along the normal alone: none of the others has anything opposite. In the plane they
    // part what is integrated.
    Box<C> what_it_sees(const Facet<C>& facet) const {
        if constexpr (C == 2) return facet.box().grown(o.reach);
        Box<C> box = Box<C>::empty();
        for (const auto& x : facet.x)
            for (const double side : {-o.reach, o.reach}) box.include(x + side * facet.n);
        return box.grown(1e-6 * o.reach);
    }
    // Points of integration whose gap the step overruns, or nearly.
    bool find_points() {
        const std::ptrdiff_t n_b = b.given->facets;
        smallest_gap = arena.take<double>(a.given->facets);
        friction = arena.take<Vector<double, C>>(a.given->facets);
        auto* boxes = arena.take<Box<C>>(n_b);
        auto* candidates = arena.take<std::ptrdiff_t>(n_b);
        if (arena.is_overrun()) return false;
        for (std::ptrdiff_t f = 0; f < n_b; ++f) boxes[f] = b.facet[f].box();
        const BoxTree<C> tree(arena, boxes, n_b);
        Meeting<C> meeting(arena, a, b, tree, o.reach);
        if (arena.is_overrun()) return false;
        Growing<MeetingPoint<C>> found(arena);
        for (std::ptrdiff_t f = 0; f < a.given->facets; ++f) {
            smallest_gap[f] = infinite;
            std::ptrdiff_t n = 0;
            tree.each(what_it_sees(a.facet[f]),
                      [&](std::ptrdiff_t other) { candidates[n++] = other; });
            sort_ascending(candidates, candidates + n);
            meeting.each_point(f, candidates, n, [&](MeetingPoint<C> p) {
                smallest_gap[f] = std::min(smallest_gap[f], p.gap);
                const auto v =
                    a.velocity_at(p.facet_a, p.place_a) - b.velocity_at(p.facet_b, p.place_b);
                const double at_end = p.gap - o.time_step * dot(v, a.facet[f].n);
                p.size *= layer.weight(p.gap, at_end, closed * o.reach);
                if (p.size == 0.0) return;
                if (o.axisymmetric) p.size *= radius(p);
                if (p.size > 0.0) found.add(p);
            });
        }
        n_points = found.size();
        points = found.close();
        return !arena.is_overrun();
    }
    double radius(const MeetingPoint<C>& p) const {
        double r = 0.0;
        for (int i = 0; i < C; ++i) r += p.place_a[i] * a.facet[p.facet_a].x[i][0];
        return std::max(r, 0.0);
    }
    bool find_shares() {
        const BoxTree<C> tree(arena, pressures.point_boxes(), pressures.size());
        auto* near = arena.take<std::ptrdiff_t>(pressures.size());
        if (arena.is_overrun()) return false;
        double longest = 0.0;
        for (std::ptrdiff_t p = 0; p < n_points; ++p)
            longest = std::max(longest, a.facet[points[p].facet_a].longest_edge());
        pressures.set_longest(longest);
        Growing<Share> found(arena);
        for (std::ptrdiff_t p = 0; p < n_points; ++p) {
            const Facet<C>& facet = a.facet[points[p].facet_a];
            Vector<double, C> x{};
            for (int i = 0; i < C; ++i) x = x + points[p].place_a[i] * facet.x[i];
            pressures.each_share(tree, points[p].facet_a, x, near,
                                 [&](std::ptrdiff_t k, double share) {
                                     if (share > 0.0) found.add({k, p, share});
                                 });
        }
        n_shares = found.size();
        shares = found.close();
        return !arena.is_overrun();
    }

    const grit_surface_options& o;
    const Layer layer{o.time_step, o.contact_stiffness, o.relaxation_time};
    Arena& arena;
    Skin<C> a, b;
    Pressures<C> pressures;
    System<C> system;
    double* smallest_gap = nullptr;         // [facets of A]
    Vector<double, C>* friction = nullptr;  // [facets of A] for the reports
    const MeetingPoint<C>* points = nullptr;
    const Share* shares = nullptr;
    std::ptrdiff_t n_points = 0, n_shares = 0;
};

constexpr std::size_t least_workspace = 4096;
constexpr std::ptrdiff_t most_pairs = 1000000;

grit_status refuse_workspace(std::size_t size, std::size_t* needed, grit_error* error) {
    if (needed) *needed = 2 * size;
    return failure(
        error, GRIT_BAD_CALL, -1,
        "workspace of %zu bytes is too small for the places where these surfaces meet: try %zu",
        size, 2 * size);
}

template <int C>
grit_status correct(const Given* given, std::ptrdiff_t n, Arena arena, std::size_t workspace_size,
                    std::size_t* needed, grit_error* error) {
    const auto too_small = [&] { return refuse_workspace(workspace_size, needed, error); };
    auto* pairs = arena.take<Pair<C>>(n);
    auto* sweeping = arena.take<Sweeping<C>>(n);
    if (arena.is_overrun()) return too_small();
    for (std::ptrdiff_t p = 0; p < n; ++p) {
        new (&pairs[p]) Pair<C>(given[p], arena);
        if (!pairs[p].find_rows()) return too_small();
        sweeping[p] = pairs[p].sweeping();
    }
    Coupling<C> coupling(arena, n);
    if (!coupling.find(sweeping)) return too_small();
    coupling.sweep();
    for (std::ptrdiff_t p = 0; p < n; ++p) {
        if (given[p].reports) pairs[p].report(given[p].reports);
        if (given[p].totals) write_versioned(pairs[p].totals(coupling.of(p)), given[p].totals);
        if (!given[p].options.validate_only) pairs[p].write();
    }
    return GRIT_OK;
}

grit_status correct(const Given* given, std::ptrdiff_t n, const Arena& arena,
                    std::size_t workspace_size, std::size_t* needed, grit_error* error) {
    return given[0].options.components == 2
               ? correct<2>(given, n, arena, workspace_size, needed, error)
               : correct<3>(given, n, arena, workspace_size, needed, error);
}

// first: of the call; null: this is it.
grit_status read_pair(const grit_surface_pair& pair, const Given* first, Given& to,
                      grit_error* error) {
    to.reports = pair.reports;
    to.totals = pair.totals;
    const grit_surface_options& o = to.options;
    const grit_surface *a = &to.surface[0], *b = &to.surface[1];
    GRIT_CHECK(read_options(pair.options, to.options, error));
    GRIT_REQUIRE(!first || o.components == first->options.components,
                 "components must be those of pair 0, %d, got %d", first->options.components,
                 o.components);
    GRIT_CHECK(read_surface(pair.a, "surface a", o, to.surface[0], error));
    GRIT_CHECK(read_surface(pair.b, "surface b", o, to.surface[1], error));
    GRIT_REQUIRE(!a->rigid || !b->rigid, "surface a and surface b are both rigid");
    const bool both_move = !a->rigid && !b->rigid && a->facets > 0 && b->facets > 0;
    GRIT_REQUIRE(!both_move || a->velocity.base != b->velocity.base,
                 "surface a and surface b: velocity is written to the same memory");
    GRIT_REQUIRE(!both_move || !a->pores.base || !b->pores.base ||
                     a->seepage.base != b->seepage.base,
                 "surface a and surface b: seepage is written to the same memory");
    GRIT_REQUIRE(!both_move || a->body == 0 || a->body != b->body,
                 "surface a and surface b are of the same body, %d", a->body);
    return check_understood(!pair.totals || is_possible_size(size_of_versioned(pair.totals)),
                            pair.totals, "grit_surface_totals", set_it_to_sizeof, error);
}

// Says of which pair a message is.
void name_pair(std::ptrdiff_t pair, grit_error* error) {
    if (!error) return;
    const grit_error said = *error;
    failure(error, said.status, said.point, "pair %td: %s", pair, said.message);
}

std::size_t workspace_size_of(const grit_surface* a, const grit_surface* b) {
    grit_surface s[2]{};
    if (!a || !b || !read_versioned(a, s[0]) || !read_versioned(b, s[1])) return 0;
    std::size_t bytes = least_workspace;
    for (const grit_surface& one : s) {
        if (one.vertices < 0 || one.facets < 0 || one.vertices > largest_count ||
            one.facets > largest_count || one.nodes_each < 0 || one.nodes_each > 64)
            return 0;
        const auto nodes = static_cast<std::size_t>(one.rigid ? 1 : std::max(one.nodes_each, 1));
        bytes += static_cast<std::size_t>(one.facets) * 6000 +
                 static_cast<std::size_t>(one.vertices) * (500 + 500 * nodes);
    }
    return bytes;
}

grit_surface_options defaults() {
    grit_surface_options o{};
    o.components = 2;
    o.sweep_limit = 500;
    o.sweep_tolerance = 1e-6;
    o.end_spacings = 1.0;
    return o;
}

}  // namespace
}  // namespace grit::surface

using namespace grit;
using namespace grit::surface;

extern "C" {

grit_status grit_surface_options_init(grit_surface_options* options, size_t struct_size) {
    return init_versioned(defaults(), options, struct_size) ? GRIT_OK : GRIT_BAD_CALL;
}

size_t grit_surface_workspace_size(const grit_surface* a, const grit_surface* b) {
    return workspace_size_of(a, b);
}

size_t grit_surface_pairs_workspace_size(const grit_surface_pair* pairs, ptrdiff_t n) {
    if (n < 0 || n > most_pairs || (n > 0 && !pairs)) return 0;
    size_t bytes = least_workspace;
    for (ptrdiff_t p = 0; p < n; ++p) {
        const size_t of_pair = workspace_size_of(pairs[p].a, pairs[p].b);
        if (of_pair == 0) return 0;
        bytes += of_pair;
    }
    return bytes;
}

grit_status grit_surface_correct(const grit_surface_options* options, const grit_surface* a,
                                 const grit_surface* b, void* workspace, size_t workspace_size,
                                 size_t* needed, grit_surface_report* reports,
                                 grit_surface_totals* totals, grit_error* error) {
    if (needed) *needed = 0;
    Given given{};
    GRIT_CHECK(read_pair({options, a, b, reports, totals}, nullptr, given, error));
    const grit_status has_memory =
        check_workspace(workspace, workspace_size, least_workspace, error);
    if (has_memory != GRIT_OK) {
        if (needed && (!workspace || workspace_size < least_workspace))
            *needed = workspace_size_of(a, b);
        return has_memory;
    }
    return correct(&given, 1, Arena(workspace, workspace_size), workspace_size, needed, error);
}

grit_status grit_surface_correct_pairs(const grit_surface_pair* pairs, ptrdiff_t n, void* workspace,
                                       size_t workspace_size, size_t* needed, grit_error* error) {
    if (needed) *needed = 0;
    GRIT_CHECK(check_count(n, "n", error, " pairs"));
    GRIT_REQUIRE(n <= most_pairs, "n must be at most %td pairs, got %td", most_pairs, n);
    if (n == 0) return GRIT_OK;
    GRIT_CHECK(check_given(pairs, "pairs", error));
    const grit_status has_memory =
        check_workspace(workspace, workspace_size, least_workspace, error);
    if (has_memory != GRIT_OK) {
        if (needed && (!workspace || workspace_size < least_workspace))
            *needed = grit_surface_pairs_workspace_size(pairs, n);
        return has_memory;
    }
    Arena arena(workspace, workspace_size);
    Given* given = arena.take<Given>(n);
    if (!given) return refuse_workspace(workspace_size, needed, error);
    for (ptrdiff_t p = 0; p < n; ++p) {
        const grit_status status =
            read_pair(pairs[p], p > 0 ? given : nullptr, *new (&given[p]) Given{}, error);
        if (status != GRIT_OK) return name_pair(p, error), status;
    }
    return correct(given, n, arena, workspace_size, needed, error);
}
}
