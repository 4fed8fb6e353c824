// SPDX-License-Identifier: BSD-3-Clause
// Random tensors that are the same on every machine.
#pragma once

#include "support/tensors.hpp"
#include "support/trials/split_mix.hpp"

namespace tests {

struct Random : grit::SplitMix {
    using SplitMix::SplitMix;

    // Uniform on the unit sphere of symmetric tensors.
    Vec direction() {
        Vec A;
        for (int i = 0; i < 6; ++i) A[i] = normal();
        return A.normalized();
    }
    Full rotation() {
        const double w = normal(), x = normal(), y = normal(), z = normal();
        return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    }
};

}  // namespace tests
