// SPDX-License-Identifier: BSD-3-Clause
// What passes between the C entry point and the kernels of the instruction sets.
#pragma once

#include <cstddef>

#include <grit/sand.h>
#include <grit/sand_derivatives.h>

#include "umat/model/material.hpp"

namespace grit {

enum class Fault {
    none,
    strain_not_finite,
    stress_not_finite,
    state_not_finite,
    substep_not_finite,
    rotation_improper,
    void_ratio_out_of_range,
    separation_negative,
    h_out_of_plane,
    h_too_long,
    stress_too_large,
    turned_stress_too_large,
    derivative_not_finite,
    increment_too_large,
    void_ratio_leaves_range,
    stress_leaves_range,
    evaluation_limit,
    derivative_leaves_range
};

inline constexpr grit_status status_of(Fault fault) {
    switch (fault) {
        case Fault::none: return GRIT_OK;
        case Fault::strain_not_finite:
        case Fault::substep_not_finite:
        case Fault::rotation_improper:
        case Fault::derivative_not_finite: return GRIT_BAD_CALL;
        case Fault::increment_too_large:
        case Fault::void_ratio_leaves_range:
        case Fault::stress_leaves_range:
        case Fault::evaluation_limit:
        case Fault::derivative_leaves_range: return GRIT_NOT_CONVERGED;
        default: return GRIT_BAD_STATE;
    }
}

struct UpdateRequest {
    const Material* material;
    const grit_sand_options* options;
    const grit_sand_points* points;
    std::ptrdiff_t n;
    grit_sand_report* reports;  // may be null
    bool igs;                   // intergranular strain on
};

struct UpdateOutcome {
    Fault fault = Fault::none;  // of the first failed point
    std::ptrdiff_t point = -1;  // its place in 0 ... n-1
    double progress = 0.0;      // fraction of its increment that was integrated
    int evaluations = 0;
};

struct DifferentiationRequest {
    const UpdateRequest* update;
    const grit_sand_derivatives* derivatives;
};

struct WaveModuliRequest {
    const Material* material;
    const grit_sand_points* points;
    std::ptrdiff_t n;
    double* moduli;
    bool igs;
};

// update_with_tangents is the part of update where the consistent tangent is wanted. wave_moduli returns the first point that has none, or -1.
namespace baseline {
UpdateOutcome update(const UpdateRequest& request);
UpdateOutcome update_with_tangents(const UpdateRequest& request);
UpdateOutcome update_differentiated(const DifferentiationRequest& request);
std::ptrdiff_t wave_moduli(const WaveModuliRequest& request);
}  // namespace baseline
namespace avx2 {
UpdateOutcome update(const UpdateRequest& request);
UpdateOutcome update_with_tangents(const UpdateRequest& request);
UpdateOutcome update_differentiated(const DifferentiationRequest& request);
std::ptrdiff_t wave_moduli(const WaveModuliRequest& request);
}  // namespace avx2
namespace avx512 {
UpdateOutcome update(const UpdateRequest& request);
UpdateOutcome update_with_tangents(const UpdateRequest& request);
UpdateOutcome update_differentiated(const DifferentiationRequest& request);
std::ptrdiff_t wave_moduli(const WaveModuliRequest& request);
}  // namespace avx512

}  // namespace grit
