// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_normals_by_regression: checks the call, chooses the instruction set, words the failures.
#include <cstdint>

#include <grit/version.h>

#include "contact/normals/regression_request.hpp"
#include "support/call_checks.hpp"
#include "support/instruction_set.hpp"

namespace grit {
namespace {

constexpr double default_ridge = 1e-3;
constexpr int default_iteration_limit = 100;
constexpr std::ptrdiff_t widest_pack = 8;
constexpr std::size_t alignment = 64;

// Arrays of a cloud: the signed coordinates, the sign, the weight.
constexpr int arrays_of(int components) { return components + 2; }

std::ptrdiff_t capacity_of(std::size_t bytes, int components) {
    if (bytes < alignment) return 0;
    const std::size_t of_each = (bytes - alignment) / sizeof(double) / arrays_of(components);
    return static_cast<std::ptrdiff_t>(of_each) / widest_pack * widest_pack;
}

double* aligned(void* workspace) {
    const auto address = reinterpret_cast<std::uintptr_t>(workspace);
    return reinterpret_cast<double*>((address + alignment - 1) / alignment * alignment);
}

grit_status check_options(const grit_contact_clouds& q, grit_error* error) {
    GRIT_CHECK(check_dimension(q.components, error));
    GRIT_CHECK(check_reserved(q.reserved, "grit_contact_clouds.reserved", error));
    GRIT_REQUIRE(q.length > 0.0 && is_finite(q.length),
                 "length must be finite and > 0 [length], got %g", q.length);
    GRIT_REQUIRE(q.ridge == 0.0 || (q.ridge >= 1e-6 && q.ridge <= 1e3),
                 "ridge must be in [1e-6, 1000], or 0 for the default, got %g", q.ridge);
    GRIT_CHECK(check_count(q.iteration_limit, "iteration_limit", error));
    GRIT_CHECK(check_count(q.particles, "particles", error));
    return check_instruction_set(q.instruction_set, error);
}

grit_status check_views(const grit_contact_clouds& q, std::ptrdiff_t n, grit_error* error) {
    GRIT_CHECK(check_given(q.offset, "offset", error));
    if (q.particles > 0) {
        GRIT_CHECK(check_usable(q.position, q.components, "position", error));
        GRIT_CHECK(check_given(q.body, "body", error));
    }
    GRIT_CHECK(check_usable(q.normal, q.components, "normal", error));
    return check_written(q.normal, n, "normal", "nodes", error);
}

grit_status check_workspace(const grit_contact_clouds& q, std::ptrdiff_t n, std::ptrdiff_t capacity,
                            grit_error* error) {
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const std::ptrdiff_t node = q.index ? q.index[i] : i;
        const std::ptrdiff_t count = q.offset[node + 1] - q.offset[node];
        GRIT_REQUIRE(count <= capacity,
                     "workspace holds %td particles per node, node %td has %td: see "
                     "grit_contact_regression_workspace_size",
                     capacity, i, count);
    }
    return GRIT_OK;
}

// Say in words what was found at a node, from the same numbers the kernel saw.
grit_status describe(const RegressionRequest& request, const RegressionOutcome& found,
                     grit_error* error) {
    const grit_contact_clouds& q = *request.clouds;
    const std::ptrdiff_t node = q.index ? q.index[found.place] : found.place;
    const std::ptrdiff_t p = q.particle && found.entry >= 0 ? q.particle[found.entry] : found.entry;
    const auto say = [&](const char* format, auto... values) {
        return failure(error, status_of_regression(found.fault), node, format, node, values...);
    };
    switch (found.fault) {
        case RegressionFault::list_decreasing:
            return refuse_range(q.offset[node], q.offset[node + 1], node, {"node", node, "offset"},
                                error);
        case RegressionFault::particle_out_of_range:
            return refuse_index(p, q.particles, node, {"node", node, "particle id"}, error);
        case RegressionFault::body_unknown:
            return say("node %td: body of particle %td must be 0 (A) or 1 (B), got %d", p,
                       integer_at(q.body, q.body_stride, p));
        case RegressionFault::weight_out_of_range:
            return say("node %td: weight of particle %td must be 0 or in [%g, %g], got %g", p,
                       smallest_particle_weight, largest_particle_weight,
                       component(q.weight, p, 0));
        case RegressionFault::position_not_finite:
            for (int c = 0; c < q.components; ++c) {
                const double x = component(q.position, p, c);
                if (!is_finite(x))
                    return say("node %td: position component %d of particle %td must be finite, "
                               "got %g",
                               c, p, x);
            }
            break;
        case RegressionFault::too_far_apart:
            return say("node %td: particle %td is more than %g lengths of %g from another: units?",
                       p, largest_cloud, q.length);
        case RegressionFault::fixed_out_of_range:
            return refuse_mask(mask_at(q.fixed, q.fixed_stride, node), q.components, node,
                               {"node", node, "fixed"}, error);
        case RegressionFault::not_converged:
            return say("node %td: not converged after %d evaluations (iteration_limit)",
                       request.iteration_limit);
        case RegressionFault::none: break;
    }
    return failure(error, GRIT_INTERNAL, node, "node %td: unknown fault", node);
}

}  // namespace
}  // namespace grit

extern "C" {

size_t grit_contact_regression_workspace_size(ptrdiff_t most_particles_per_node, int components) {
    using namespace grit;
    if (most_particles_per_node < 0 || most_particles_per_node > PTRDIFF_MAX / 128 ||
        (components != 2 && components != 3))
        return 0;
    const ptrdiff_t packs = (most_particles_per_node + widest_pack - 1) / widest_pack;
    const auto numbers = static_cast<size_t>(packs * widest_pack * arrays_of(components));
    return alignment + numbers * sizeof(double);
}

grit_status grit_contact_normals_by_regression(ptrdiff_t n, const grit_contact_clouds* clouds,
                                               void* workspace, size_t workspace_size,
                                               grit_contact_normal_counts* counts,
                                               grit_error* error) {
    using namespace grit;
    const char* const name = "grit_contact_normals_by_regression";
    GRIT_CHECK(check_given(clouds, {name, "clouds"}, error));
    GRIT_CHECK(check_count(n, {name, "n"}, error));
    grit_contact_clouds q{};
    GRIT_CHECK(read_struct(clouds, q, "grit_contact_clouds", error));
    grit_contact_normal_counts numbers{};
    GRIT_CHECK(begin_result(numbers, counts, "grit_contact_normal_counts", error));
    GRIT_CHECK(check_options(q, error));
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    GRIT_CHECK(check_views(q, n, error));
    GRIT_CHECK(check_given(workspace, {name, "workspace"}, error));
    const ptrdiff_t capacity = capacity_of(workspace_size, q.components);
    GRIT_CHECK(check_workspace(q, n, capacity, error));

    const RegressionRequest request{&q,
                                    n,
                                    aligned(workspace),
                                    capacity,
                                    q.ridge > 0.0 ? q.ridge : default_ridge,
                                    q.iteration_limit ? q.iteration_limit
                                                      : default_iteration_limit};
    const RegressionOutcome found = GRIT_DISPATCH(q.instruction_set, regress(request));
    numbers.defined = found.defined;
    numbers.undefined = found.undefined;
    numbers.failed = found.failed;
    if (counts) write_versioned(numbers, counts);
    return found.fault == RegressionFault::none ? GRIT_OK : describe(request, found, error);
}
}
