// SPDX-License-Identifier: BSD-3-Clause
// What contacts do to a body by height: impulses in parts of equal height.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/vector.hpp"

namespace grit::mpm {

struct ProfilePlan {
    double from = 0.0, to = 0.0;  // along z [m]
    int parts = 0;                // 0: none is wanted

    double height() const { return (to - from) / parts; }
    double begin(int part) const { return from + part * height(); }
    std::size_t numbers() const { return 3 * static_cast<std::size_t>(parts); }

    // An impulse that acts evenly between two heights; impulses: [parts][3], lowest first. What is beyond the
    // profile is left out.
    void add(double low, double high, const Vector3& impulse, std::vector<double>& impulses) const {
        const auto part_at = [this](double z) {
            return static_cast<int>(std::clamp((z - from) / height(), 0.0, parts - 1.0));
        };
        if (!(high > from && low < to)) return;
        for (int part = part_at(low); part <= part_at(high); ++part) {
            const double within = std::min(high, begin(part + 1)) - std::max(low, begin(part));
            const double share = high > low ? std::max(within, 0.0) / (high - low) : 1.0;
            for (int k = 0; k < 3; ++k)
                impulses[3 * static_cast<std::size_t>(part) + static_cast<std::size_t>(k)] +=
                    share * impulse[k];
        }
    }
};

}  // namespace grit::mpm
