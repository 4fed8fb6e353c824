// SPDX-License-Identifier: BSD-3-Clause
// grit_penalty_remesh: merges, counts, then writes the new line.
#include "contact/penalty/call_checks.hpp"
#include "contact/penalty/remesh.hpp"

namespace grit::penalty {
namespace {

grit_status check(const grit_penalty_remeshing& q, grit_error* error) {
    GRIT_CHECK(check_switch(q.closed, "closed", error));
    GRIT_CHECK(check_reserved(q.reserved, "reserved", error));
    GRIT_REQUIRE(q.longest > 0.0 && q.longest <= largest_length,
                 "longest must be in (0, 1e30] (length), got %g", q.longest);
    GRIT_REQUIRE(q.shortest >= 0.0 && q.shortest <= 0.5 * q.longest,
                 "shortest must be in [0, longest / 2 = %g] (length), got %g", 0.5 * q.longest,
                 q.shortest);
    GRIT_REQUIRE(q.tolerance >= 0.0 && q.tolerance <= q.shortest,
                 "tolerance must be in [0, shortest = %g] (length), got %g", q.shortest,
                 q.tolerance);
    GRIT_CHECK(check_vertex_count(q.count, q.closed, "count", error));
    GRIT_CHECK(check_vectors(q.position, "position", error));
    if (q.history.base)
        GRIT_CHECK(check_components(q.history, GRIT_PENALTY_HISTORY_SIZE, "history", error));
    GRIT_CHECK(check_given(q.parents, "parents", error));
    GRIT_CHECK(check_given(q.weight, "weight", error));
    GRIT_CHECK(check_output(q.new_position, 2, {"line", "new_position"}, error));
    return q.history.base ? check_output(q.new_history, GRIT_PENALTY_HISTORY_SIZE,
                                         {"line", "new_history"}, error)
                          : GRIT_OK;
}

void write_vertex(const grit_penalty_remeshing& q, ptrdiff_t at, ptrdiff_t a, ptrdiff_t b,
                  double w) {
    q.parents[2 * at] = a;
    q.parents[2 * at + 1] = b;
    q.weight[at] = w;
    const auto between = [&](const grit_view& from, const grit_mutable_view& to, int c) {
        const double start = component(from, a, c);
        component(to, at, c) = w == 0.0 ? start : (1.0 - w) * start + w * component(from, b, c);
    };
    for (int c = 0; c < 2; ++c) between(q.position, q.new_position, c);
    for (int c = 0; q.history.base && c < GRIT_PENALTY_HISTORY_SIZE; ++c)
        between(q.history, q.new_history, c);
}

}  // namespace
}  // namespace grit::penalty

using namespace grit;
using namespace grit::penalty;

extern "C" {

size_t grit_penalty_remesh_workspace_size(ptrdiff_t count) {
    return count >= 2 && count <= largest_count ? static_cast<size_t>(count) * sizeof(ptrdiff_t)
                                                : 0;
}

grit_status grit_penalty_remesh(const grit_penalty_remeshing* remeshing, void* workspace,
                                size_t workspace_size, ptrdiff_t* new_count, grit_error* error) {
    GRIT_CHECK(check_given(remeshing, "remeshing", error));
    GRIT_CHECK(check_given(new_count, "new_count", error));
    grit_penalty_remeshing q{};
    GRIT_CHECK(read_struct(remeshing, q, "grit_penalty_remeshing", error));
    GRIT_CHECK(check(q, error));
    const size_t needed = grit_penalty_remesh_workspace_size(q.count);
    GRIT_CHECK(check_workspace(workspace, workspace_size, needed, error));
    const Geometry line{q.count, q.closed == 1, false, q.position};
    GRIT_CHECK(check_vertices(line, "line", error));

    auto* kept = static_cast<ptrdiff_t*>(workspace);
    const ptrdiff_t stay = merge_short(line, {q.longest, q.shortest, q.tolerance}, kept);
    const ptrdiff_t segments = line.closed ? stay : stay - 1;
    const auto end_of = [&](ptrdiff_t k) { return kept[k + 1 < stay ? k + 1 : 0]; };
    const auto parts = [&](ptrdiff_t k) {
        const Vector2 e = vector_of(q.position, end_of(k)) - vector_of(q.position, kept[k]);
        return parts_of(norm(e), q.longest);
    };
    double total = line.closed ? 0.0 : 1.0;
    for (ptrdiff_t k = 0; k < segments; ++k) total += parts(k);
    GRIT_REQUIRE(total <= static_cast<double>(largest_count),
                 "longest %g would make %g vertices: at most 2^40", q.longest, total);
    *new_count = static_cast<ptrdiff_t>(total);
    GRIT_REQUIRE(q.capacity >= *new_count, "capacity must be at least %td vertices, got %td",
                 *new_count, q.capacity);

    ptrdiff_t at = 0;
    for (ptrdiff_t k = 0; k < segments; ++k) {
        const auto n = static_cast<ptrdiff_t>(parts(k));
        write_vertex(q, at++, kept[k], kept[k], 0.0);
        for (ptrdiff_t i = 1; i < n; ++i)
            write_vertex(q, at++, kept[k], end_of(k),
                         static_cast<double>(i) / static_cast<double>(n));
    }
    if (!line.closed) write_vertex(q, at, kept[stay - 1], kept[stay - 1], 0.0);
    return GRIT_OK;
}
}
