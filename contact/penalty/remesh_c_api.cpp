// SPDX-License-Identifier: BSD-3-Clause
// grit_penalty_remesh: merges, counts, then writes the new line.
#include "contact/penalty/call_checks.hpp"
#include "contact/penalty/remesh.hpp"
#include "support/versioned.hpp"

namespace grit::penalty {
namespace {

grit_status check(const grit_penalty_remeshing& q, grit_error* error) {
    GRIT_REQUIRE(is_switch(q.closed), "closed must be 0 or 1, got %d", q.closed);
    GRIT_REQUIRE(q.reserved == 0, "reserved must be 0, got %d", q.reserved);
    GRIT_REQUIRE(q.longest > 0.0 && q.longest <= largest_length,
                 "longest must be in (0, 1e30] (length), got %g", q.longest);
    GRIT_REQUIRE(q.shortest >= 0.0 && q.shortest <= 0.5 * q.longest,
                 "shortest must be in [0, longest / 2 = %g] (length), got %g", 0.5 * q.longest,
                 q.shortest);
    GRIT_REQUIRE(q.tolerance >= 0.0 && q.tolerance <= q.shortest,
                 "tolerance must be in [0, shortest = %g] (length), got %g", q.shortest,
                 q.tolerance);
    GRIT_REQUIRE(q.count >= (q.closed ? 3 : 2) && q.count <= largest_count,
                 "count must be at least %d vertices for %s line, got %td", q.closed ? 3 : 2,
                 q.closed ? "a closed" : "an open", q.count);
    GRIT_REQUIRE(q.position.base, "position has no base pointer");
    GRIT_REQUIRE(q.parents, "parents is null");
    GRIT_REQUIRE(q.weight, "weight is null");
    if (const grit_status s = check_output(q.new_position, "line", "new_position", 2, error))
        return s;
    return q.history.base ? check_output(q.new_history, "line", "new_history",
                                         GRIT_PENALTY_HISTORY_SIZE, error)
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
    GRIT_REQUIRE(remeshing, "remeshing is null");
    GRIT_REQUIRE(new_count, "new_count is null");
    grit_penalty_remeshing q{};
    GRIT_REQUIRE(read_versioned(remeshing, q),
                 "grit_penalty_remeshing.struct_size %zu is not understood: set it to sizeof",
                 remeshing->struct_size);
    if (const grit_status s = check(q, error)) return s;
    const size_t needed = grit_penalty_remesh_workspace_size(q.count);
    GRIT_REQUIRE(workspace, "workspace is null: %zu bytes are needed", needed);
    GRIT_REQUIRE(is_aligned(workspace), "workspace must be aligned to %zu bytes", alignof(double));
    GRIT_REQUIRE(workspace_size >= needed, "workspace must have at least %zu bytes, got %zu",
                 needed, workspace_size);
    const Geometry line{q.count, q.closed == 1, false, q.position};
    if (const grit_status s = check_vertices(line, "line", error)) return s;

    auto* kept = static_cast<ptrdiff_t*>(workspace);
    const ptrdiff_t stay = merge_short(line, {q.longest, q.shortest, q.tolerance}, kept);
    const ptrdiff_t segments = line.closed ? stay : stay - 1;
    const auto end_of = [&](ptrdiff_t k) { return kept[k + 1 < stay ? k + 1 : 0]; };
    const auto parts = [&](ptrdiff_t k) {
        const Vec e = vector_of(q.position, end_of(k)) - vector_of(q.position, kept[k]);
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
