// SPDX-License-Identifier: BSD-3-Clause
// grit_penalty_forces: checks both surfaces, searches in both directions, runs both passes.
#include "contact/penalty/area.hpp"
#include "contact/penalty/call_checks.hpp"
#include "contact/penalty/pass.hpp"
#include "contact/penalty/search.hpp"

namespace grit::penalty {
namespace {

constexpr const char* names[2] = {"surface a", "surface b"};

grit_penalty_totals add_up(const PassSums& a, const PassSums& b, bool plane, std::ptrdiff_t tests) {
    grit_penalty_totals t{};
    const Vector2 on_a = a.force - b.force;
    t.force_on_a[0] = on_a[0], t.force_on_a[1] = on_a[1];
    t.force_on_b[0] = -on_a[0], t.force_on_b[1] = -on_a[1];
    t.moment_on_a = plane ? a.moment_on_slave + b.moment_on_master : 0.0;
    t.moment_on_b = plane ? b.moment_on_slave + a.moment_on_master : 0.0;
    t.contact_area = a.area + b.area;
    t.normal_force = a.normal_force + b.normal_force;
    t.energy_normal = a.energy_normal + b.energy_normal;
    t.energy_tangential = a.energy_tangential + b.energy_tangential;
    t.dissipation = a.dissipation + b.dissipation;
    t.largest_penetration = std::max(a.depth, b.depth);
    t.contacts_a = a.contacts;
    t.contacts_b = b.contacts;
    t.slips = a.slips + b.slips;
    t.tests = tests;
    return t;
}

}  // namespace
}  // namespace grit::penalty

using namespace grit;
using namespace grit::penalty;

extern "C" {

grit_status grit_penalty_options_init(grit_penalty_options* options, size_t struct_size) {
    return init_versioned(grit_penalty_options{}, options, struct_size) ? GRIT_OK : GRIT_BAD_CALL;
}

size_t grit_penalty_workspace_size(ptrdiff_t n_a, ptrdiff_t n_b) {
    const auto possible = [](ptrdiff_t n) { return n >= 2 && n <= largest_count; };
    return possible(n_a) && possible(n_b) ? line_size(n_a) + line_size(n_b) : 0;
}

grit_status grit_penalty_forces(const grit_penalty_options* options, const grit_penalty_surface* a,
                                const grit_penalty_surface* b, void* workspace,
                                size_t workspace_size, grit_penalty_totals* totals,
                                grit_error* error) {
    grit_penalty_options o{};
    GRIT_CHECK(read_options(options, o, error));
    grit_penalty_surface surface[2]{};
    const grit_penalty_surface* given[2] = {a, b};
    for (int i = 0; i < 2; ++i) GRIT_CHECK(read_surface(given[i], names[i], surface[i], error));
    GRIT_CHECK(check_understood(!totals || is_possible_size(size_of_versioned(totals)), totals,
                                "grit_penalty_totals", set_it_to_sizeof, error));
    const size_t needed = grit_penalty_workspace_size(surface[0].count, surface[1].count);
    GRIT_CHECK(check_workspace(workspace, workspace_size, needed, error));

    auto* memory = static_cast<char*>(workspace);
    Body body[2];
    for (int i = 0; i < 2; ++i) {
        const grit_penalty_surface& s = surface[i];
        GRIT_CHECK(check_motion(s, names[i], o, error));
        body[i] = {&s, place_line(memory, s.count, s.closed == 1)};
        const Geometry geometry{s.count, s.closed == 1, o.axisymmetric == 1, s.position};
        GRIT_CHECK(read_line(geometry, names[i], body[i].line, error));
        build_tree(body[i].line);
    }
    ptrdiff_t tests = 0;
    for (int i = 0; i < 2; ++i) {  // (S1)
        tests += search(body[i].line, body[1 - i].line, o.depth_max);
        keep_facing_hits(body[i].line);
    }
    const Pass pass{{o.normal_stiffness, o.tangential_stiffness, o.friction_coefficient},
                    o.time_step,
                    o.axisymmetric == 1,
                    o.validate_only == 1};
    const PassSums sums_a = run_pass(pass, body[0], body[1]);
    const PassSums sums_b = run_pass(pass, body[1], body[0]);
    const grit_penalty_totals ours = add_up(sums_a, sums_b, !pass.axisymmetric, tests);
    if (totals) write_versioned(ours, totals);
    return GRIT_OK;
}
}
