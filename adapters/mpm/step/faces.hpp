// SPDX-License-Identifier: BSD-3-Clause
// Contact forces apart by where they push.
#pragma once

#include <cmath>

#include "support/vector.hpp"

namespace grit::mpm {

// Forces [N] of contact whose direction is more along r, as on a shaft, and more along z, as at a tip.
struct Faces {
    Vector2 along_r{0.0, 0.0}, along_z{0.0, 0.0};

    static bool is_along_z(double n_r, double n_z) { return std::fabs(n_z) > std::fabs(n_r); }
};

}  // namespace grit::mpm
