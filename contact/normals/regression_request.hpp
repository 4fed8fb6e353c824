// SPDX-License-Identifier: BSD-3-Clause
// What passes between the C entry point of the regression and its kernels.
#pragma once

#include <cstddef>

#include <grit/contact_normals.h>

namespace grit {

enum class RegressionFault {
    none,
    list_decreasing,
    particle_out_of_range,
    body_unknown,
    position_not_finite,
    weight_out_of_range,
    too_far_apart,
    fixed_out_of_range,
    not_converged
};

inline constexpr grit_status status_of_regression(RegressionFault fault) {
    switch (fault) {
        case RegressionFault::none: return GRIT_OK;
        case RegressionFault::position_not_finite:
        case RegressionFault::weight_out_of_range:
        case RegressionFault::too_far_apart: return GRIT_BAD_STATE;
        case RegressionFault::not_converged: return GRIT_NOT_CONVERGED;
        default: return GRIT_BAD_CALL;
    }
}

inline constexpr double smallest_particle_weight = 1e-100;  // or 0
inline constexpr double largest_particle_weight = 1e100;
inline constexpr double largest_cloud = 200.0;  // its extent along an axis, in lengths

struct RegressionRequest {
    const grit_contact_clouds* clouds;
    std::ptrdiff_t n;
    double* workspace;        // aligned to 64 bytes
    std::ptrdiff_t capacity;  // particles per node that it holds, whole packs of any kernel
    double ridge;
    int iteration_limit;
};

struct RegressionOutcome {
    RegressionFault fault = RegressionFault::none;  // of the first failed node
    std::ptrdiff_t place = -1;                      // its place in 0 ... n-1
    std::ptrdiff_t entry = -1;                      // of particle, where the fault is a particle's
    std::ptrdiff_t defined = 0, undefined = 0, failed = 0;
};

namespace baseline {
RegressionOutcome regress(const RegressionRequest& request);
}
namespace avx2 {
RegressionOutcome regress(const RegressionRequest& request);
}
namespace avx512 {
RegressionOutcome regress(const RegressionRequest& request);
}

}  // namespace grit
