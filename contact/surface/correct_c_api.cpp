// SPDX-License-Identifier: BSD-3-Clause
// grit_surface_correct: where the surfaces meet, what carries the pressure, which impulses close the gap.
#include "contact/surface/ascending.hpp"
#include "contact/surface/call_checks.hpp"
#include "contact/surface/system.hpp"

namespace grit::surface {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Share of the reach: points that are nearer count in the mean gap. Without them a pressure would act on what has
// touched last, and lift off what rested there before: a curved surface would be printed with the path of its contact.
constexpr double closed = 0.02;

// One call, of so many components.
template <int C> class Call {
  public:
    Call(const grit_surface_options& given, const grit_surface& of_a, const grit_surface& of_b,
         Arena& memory)
        : o(given), arena(memory), a(read_skin<C>(memory, of_a)), b(read_skin<C>(memory, of_b)),
          pressures(memory, a, given.spacing, given.end_spacings), system(memory, a, b, pressures) {
    }

    // False where the workspace is too small: nothing is written then.
    bool run() { return !arena.is_overrun() && find_points() && find_shares() && solve(); }

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
    grit_surface_totals totals() const {
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
    bool solve() {
        if (!system.build(points, n_points, shares, n_shares, layer)) return false;
        if (!system.make_lists()) return false;
        outcome = system.sweep(o.friction_coefficient, o.sweep_limit, o.sweep_tolerance);
        return true;
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
    typename System<C>::Outcome outcome{};
};

template <int C>
grit_status correct(const grit_surface_options& o, const grit_surface& a, const grit_surface& b,
                    Arena arena, std::size_t* needed, grit_surface_report* reports,
                    grit_surface_totals* totals, grit_error* error) {
    const std::size_t size = arena.left();
    Call<C> call(o, a, b, arena);
    if (!call.run()) {
        if (needed) *needed = 2 * size;
        return failure(error, GRIT_BAD_CALL, -1,
                       "workspace of %zu bytes is too small for the places where these surfaces "
                       "meet: try %zu",
                       size, 2 * size);
    }
    if (reports) call.report(reports);
    if (totals) write_versioned(call.totals(), totals);
    if (!o.validate_only) call.write();
    return GRIT_OK;
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
    grit_surface s[2]{};
    if (!a || !b || !read_versioned(a, s[0]) || !read_versioned(b, s[1])) return 0;
    size_t bytes = 4096;
    for (const grit_surface& one : s) {
        if (one.vertices < 0 || one.facets < 0 || one.vertices > largest_count ||
            one.facets > largest_count || one.nodes_each < 0 || one.nodes_each > 64)
            return 0;
        const auto nodes = static_cast<size_t>(one.rigid ? 1 : std::max(one.nodes_each, 1));
        bytes += static_cast<size_t>(one.facets) * 6000 +
                 static_cast<size_t>(one.vertices) * (500 + 500 * nodes);
    }
    return bytes;
}

grit_status grit_surface_correct(const grit_surface_options* options, const grit_surface* a,
                                 const grit_surface* b, void* workspace, size_t workspace_size,
                                 size_t* needed, grit_surface_report* reports,
                                 grit_surface_totals* totals, grit_error* error) {
    if (needed) *needed = 0;
    grit_surface_options o{};
    GRIT_CHECK(read_options(options, o, error));
    grit_surface s[2]{};
    GRIT_CHECK(read_surface(a, "surface a", o, s[0], error));
    GRIT_CHECK(read_surface(b, "surface b", o, s[1], error));
    GRIT_REQUIRE(!s[0].rigid || !s[1].rigid, "surface a and surface b are both rigid");
    const bool both_move = !s[0].rigid && !s[1].rigid && s[0].facets > 0 && s[1].facets > 0;
    GRIT_REQUIRE(!both_move || s[0].velocity.base != s[1].velocity.base,
                 "surface a and surface b: velocity is written to the same memory");
    GRIT_REQUIRE(!both_move || !s[0].pores.base || !s[1].pores.base ||
                     s[0].seepage.base != s[1].seepage.base,
                 "surface a and surface b: seepage is written to the same memory");
    GRIT_CHECK(check_understood(!totals || is_possible_size(size_of_versioned(totals)), totals,
                                "grit_surface_totals", set_it_to_sizeof, error));
    constexpr size_t least = 4096;
    const grit_status has_memory = check_workspace(workspace, workspace_size, least, error);
    if (has_memory != GRIT_OK) {
        if (needed && (!workspace || workspace_size < least))
            *needed = grit_surface_workspace_size(a, b);
        return has_memory;
    }
    const Arena arena(workspace, workspace_size);
    return o.components == 2 ? correct<2>(o, s[0], s[1], arena, needed, reports, totals, error)
                             : correct<3>(o, s[0], s[1], arena, needed, reports, totals, error);
}
}
