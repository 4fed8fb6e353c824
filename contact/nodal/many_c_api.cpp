// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_correct_many: every pair passes the checks of a pair alone.
#include <cstring>

#include "contact/nodal/call_checks.hpp"
#include "contact/nodal/request.hpp"
#include "support/call_checks.hpp"
#include "support/instruction_set.hpp"

namespace grit {
namespace {

// The pair as grit_contact_correct would see it.
grit_contact_nodes nodes_of(const grit_contact_bodies& b, const grit_contact_pair& pair) {
    grit_contact_nodes q{};
    q.struct_size = sizeof q;
    q.index = b.index;
    q.mass_a = b.mass[pair.a];
    q.mass_b = b.mass[pair.b];
    q.velocity_a = b.velocity[pair.a];
    q.velocity_b = b.velocity[pair.b];
    if (b.acceleration) {
        q.acceleration_a = b.acceleration[pair.a];
        q.acceleration_b = b.acceleration[pair.b];
    }
    if (b.previous_velocity) {
        q.previous_velocity_a = b.previous_velocity[pair.a];
        q.previous_velocity_b = b.previous_velocity[pair.b];
    }
    q.position = b.position;
    q.normal = pair.normal;
    q.distance = pair.distance;
    q.cell_size = pair.cell_size;
    q.spacing = pair.spacing;
    q.gap = pair.gap;
    q.contact_area = pair.contact_area;
    q.pore_impulse = pair.pore_impulse;
    return q;
}

// Say which pair a message is about.
grit_status of_pair(int p, grit_status status, grit_error* error) {
    if (!error) return status;
    const grit_error found = *error;
    return failure(error, status, found.point, "pair %d, %.230s", p, found.message);
}

grit_status check_bodies(const grit_contact_bodies& b, grit_error* error) {
    GRIT_CHECK(check_dimension(b.components, error));
    GRIT_REQUIRE(b.count >= 2 && b.count <= most_bodies, "count must be in [2, %d] bodies, got %d",
                 most_bodies, b.count);
    GRIT_REQUIRE(b.mass && b.velocity, "mass and velocity need one view per body, got null");
    GRIT_REQUIRE(b.sweep_tolerance >= 0.0 && b.sweep_tolerance <= 1.0,
                 "sweep_tolerance must be in (0, 1] [-], or 0 for 1e-3, got %g", b.sweep_tolerance);
    GRIT_CHECK(check_count(b.sweep_limit, "sweep_limit", error));
    GRIT_CHECK(check_reserved(b.reserved, "grit_contact_bodies.reserved", error));
    GRIT_CHECK(check_switch(b.validate_only, "validate_only", error));
    for (int body = 0; body < b.count; ++body) {
        GRIT_CHECK(check_base(b.mass[body], {"body", body, "mass"}, error));
        GRIT_CHECK(check_base(b.velocity[body], {"body", body, "velocity"}, error));
        if (b.previous_velocity)
            GRIT_CHECK(
                check_base(b.previous_velocity[body], {"body", body, "previous_velocity"}, error));
    }
    return check_instruction_set(b.instruction_set, error);
}

// struct_size: of the first pair.
grit_status read_pair(const grit_contact_bodies& b, std::size_t struct_size,
                      const grit_contact_pair* caller, grit_contact_pair& pair,
                      grit_contact_options& o, std::ptrdiff_t n, grit_error* error) {
    const bool understood =
        size_of_versioned(caller) == struct_size && read_versioned(caller, pair);
    GRIT_CHECK(check_understood(understood, caller, "grit_contact_pair", set_it_to_sizeof, error));
    GRIT_REQUIRE(is_index(pair.a, b.count) && is_index(pair.b, b.count) && pair.a != pair.b,
                 "a and b must be two different bodies of 0 ... %d, got %d and %d", b.count - 1,
                 pair.a, pair.b);
    GRIT_CHECK(read_given_options(pair.options, o, error));
    o.components = b.components;
    o.instruction_set = b.instruction_set;
    o.validate_only = b.validate_only;
    GRIT_CHECK(check_contact_options(o, error));
    return n == 0 ? GRIT_OK : check_nodes(nodes_of(b, pair), o, n, error);
}

// A body is rigid in all of its pairs or in none; two bodies meet in one pair.
grit_status check_agreement(int count, const grit_contact_pair* pairs,
                            const grit_contact_options* options, grit_error* error) {
    int rigid[most_bodies];
    std::memset(rigid, -1, sizeof rigid);
    bool met[most_bodies][most_bodies] = {};
    for (int p = 0; p < count; ++p) {
        const int bodies[2] = {pairs[p].a, pairs[p].b};
        GRIT_REQUIRE(!met[bodies[0]][bodies[1]], "pair %d: bodies %d and %d have a pair already", p,
                     bodies[0], bodies[1]);
        met[bodies[0]][bodies[1]] = met[bodies[1]][bodies[0]] = true;
        for (int side = 0; side < 2; ++side) {
            const int here = options[p].rigid == side + 1;
            int& known = rigid[bodies[side]];
            GRIT_REQUIRE(known < 0 || known == here,
                         "pair %d: body %d must be rigid in all of its pairs or in none", p,
                         bodies[side]);
            known = here;
        }
    }
    return GRIT_OK;
}

}  // namespace
}  // namespace grit

using namespace grit;

extern "C" grit_status grit_contact_correct_many(const grit_contact_bodies* bodies, int pair_count,
                                                 const grit_contact_pair* pairs, ptrdiff_t n,
                                                 grit_contact_report* reports,
                                                 grit_contact_sums* sums, grit_error* error) {
    GRIT_CHECK(check_given(bodies, {"grit_contact_correct_many", "bodies"}, error));
    GRIT_CHECK(check_count(n, {"grit_contact_correct_many", "n"}, error));
    grit_contact_bodies b{};
    GRIT_CHECK(read_struct(bodies, b, "grit_contact_bodies", error));
    GRIT_CHECK(check_bodies(b, error));
    GRIT_REQUIRE(pair_count >= 0 && pair_count <= b.count * (b.count - 1) / 2,
                 "pair_count must be in [0, %d] for %d bodies, got %d", b.count * (b.count - 1) / 2,
                 b.count, pair_count);
    if (pair_count > 0)
        GRIT_CHECK(check_given(pairs, {"grit_contact_correct_many", "pairs"}, error));
    grit_contact_pair ours[most_pairs] = {};
    grit_contact_options options[most_pairs];
    // The caller's struct may be longer or shorter than ours.
    const std::size_t size = pair_count == 0 ? sizeof *pairs : size_of_versioned(pairs);
    GRIT_CHECK(check_understood(size % alignof(grit_contact_pair) == 0, pairs, "grit_contact_pair",
                                set_it_to_sizeof, error));
    const auto* bytes = reinterpret_cast<const unsigned char*>(pairs);
    for (int p = 0; p < pair_count; ++p) {
        const auto* caller =
            reinterpret_cast<const grit_contact_pair*>(bytes + static_cast<std::size_t>(p) * size);
        if (const grit_status s = read_pair(b, size, caller, ours[p], options[p], n, error))
            return of_pair(p, s, error);
    }
    GRIT_CHECK(check_agreement(pair_count, ours, options, error));
    if (n == 0 || pair_count == 0) return GRIT_OK;

    const ManyRequest request{&b, ours, options, pair_count, n, reports, sums};
    const CorrectionOutcome outcome = GRIT_DISPATCH(b.instruction_set, correct_many(request));
    if (outcome.node < 0) return GRIT_OK;
    const ptrdiff_t at = b.index ? b.index[outcome.node] : outcome.node;
    if (outcome.status == GRIT_NOT_CONVERGED)
        return failure(
            error, outcome.status, at,
            "node %td: no impulses keep the bodies apart: one is squeezed between two that "
            "are rigid, or by springs around a ring",
            at);
    const int p = outcome.pair;
    return of_pair(p, describe_node(nodes_of(b, ours[p]), options[p], outcome.node, error), error);
}
