// SPDX-License-Identifier: BSD-3-Clause
// Points whose consistent tangent is wanted.
#pragma once

#include "umat/batch/single_points.hpp"

namespace grit::GRIT_TARGET {

UpdateOutcome update_with_tangents(const UpdateRequest& request) {
    const Control control = control_of(request);
    SinglePoints<Dual> points(request, control);
    for (std::ptrdiff_t i = 0; i < request.n; ++i) points.take(i);
    return points.outcome;
}

}  // namespace grit::GRIT_TARGET
