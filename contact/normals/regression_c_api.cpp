// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_normals_by_regression: checks the call, chooses the instruction set, words the failures.
#include <cstdint>

#include <grit/version.h>

#include "contact/geometry_call.hpp"
#include "contact/normals/regression_request.hpp"
#include "support/instruction_set.hpp"
#include "support/versioned.hpp"

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
    GRIT_REQUIRE(q.components == 2 || q.components == 3, "components must be 2 or 3, got %d",
                 q.components);
    GRIT_REQUIRE(q.reserved == 0, "grit_contact_clouds.reserved must be 0, got %d", q.reserved);
    GRIT_REQUIRE(q.length > 0.0 && is_finite_number(q.length),
                 "length must be finite and > 0 [length], got %g", q.length);
    GRIT_REQUIRE(q.ridge == 0.0 || (q.ridge >= 1e-6 && q.ridge <= 1e3),
                 "ridge must be in [1e-6, 1000], or 0 for the default, got %g", q.ridge);
    GRIT_REQUIRE(q.iteration_limit >= 0, "iteration_limit must be >= 0, got %d", q.iteration_limit);
    GRIT_REQUIRE(q.particles >= 0, "particles must be >= 0, got %td", q.particles);
    return check_instruction_set(q.instruction_set, error);
}

grit_status check_views(const grit_contact_clouds& q, std::ptrdiff_t n, grit_error* error) {
    GRIT_REQUIRE(q.offset, "offset is null");
    if (q.particles > 0)
        if (const grit_status bad = check_usable(q.position, q.components, "position", error))
            return bad;
    GRIT_REQUIRE(q.particles == 0 || q.body, "body is null");
    if (const grit_status bad = check_usable(q.normal, q.components, "normal", error)) return bad;
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
    const std::ptrdiff_t i = found.place, node = q.index ? q.index[i] : i;
    const std::ptrdiff_t p = q.particle && found.entry >= 0 ? q.particle[found.entry] : found.entry;
    const auto say = [&](const char* format, auto... values) {
        return failure(error, status_of_regression(found.fault), i, format, node, values...);
    };
    switch (found.fault) {
        case RegressionFault::list_decreasing:
            return say("node %td: offset must start at >= 0 and not decrease, got %td and %td",
                       q.offset[node], q.offset[node + 1]);
        case RegressionFault::particle_out_of_range:
            return say("node %td: particle id must be in [0, %td), got %td", q.particles, p);
        case RegressionFault::body_unknown:
            return say("node %td: body of particle %td must be 0 (A) or 1 (B), got %d", p,
                       q.body[p * (q.body_stride ? q.body_stride : 1)]);
        case RegressionFault::weight_out_of_range:
            return say("node %td: weight of particle %td must be 0 or in [%g, %g], got %g", p,
                       smallest_particle_weight, largest_particle_weight,
                       q.weight.base[p * q.weight.point_stride]);
        case RegressionFault::position_not_finite:
            for (int c = 0; c < q.components; ++c) {
                const double x =
                    q.position.base[p * q.position.point_stride + c * q.position.component_stride];
                if (!is_finite_number(x))
                    return say("node %td: position component %d of particle %td must be finite, "
                               "got %g",
                               c, p, x);
            }
            break;
        case RegressionFault::too_far_apart:
            return say(
                "node %td: particle %td is more than %g lengths of %g from the first: units?", p,
                largest_cloud, q.length);
        case RegressionFault::fixed_out_of_range:
            return say("node %td: fixed must be bits of %d components in [0, %d], got %d",
                       q.components, (1 << q.components) - 1,
                       fixed_of(q.fixed, q.fixed_stride, node));
        case RegressionFault::not_converged:
            return say("node %td: not converged after %d evaluations (iteration_limit)",
                       request.iteration_limit);
        case RegressionFault::none: break;
    }
    return failure(error, GRIT_INTERNAL, i, "node %td: unknown fault", i);
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
    GRIT_REQUIRE(clouds, "grit_contact_normals_by_regression: clouds is null");
    GRIT_REQUIRE(n >= 0, "grit_contact_normals_by_regression: n must be >= 0, got %td", n);
    grit_contact_clouds q{};
    GRIT_REQUIRE(read_versioned(clouds, q),
                 "grit_contact_clouds.struct_size %zu is not understood: set it to sizeof",
                 clouds->struct_size);
    grit_contact_normal_counts numbers{};
    GRIT_REQUIRE(!counts || write_versioned(numbers, counts),
                 "grit_contact_normal_counts.struct_size %zu is not understood: set it to sizeof",
                 counts->struct_size);
    if (const grit_status s = check_options(q, error)) return s;
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    if (const grit_status s = check_views(q, n, error)) return s;
    GRIT_REQUIRE(workspace, "grit_contact_normals_by_regression: workspace is null");
    const ptrdiff_t capacity = capacity_of(workspace_size, q.components);
    if (const grit_status s = check_workspace(q, n, capacity, error)) return s;

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
