// SPDX-License-Identifier: BSD-3-Clause
// Nodal sums in fixed point. Each quantity of a body has a scale of its own, which follows the largest
// contribution: where one is too large, or all are too small, the sums are done again.
#include <algorithm>
#include <cmath>

#include "adapters/mpm/simulation.hpp"

namespace grit::mpm {
namespace {

constexpr int aim = 48;                // bits of the largest contribution after a change of scale
constexpr double least_size = 0x1p42;  // ... and what it may shrink to

}  // namespace

// The scales that the contributions want; true if the sums must be done again.
bool Simulation::rescale() {
    bool again = false;
    for (Part& part : parts) {
        std::array<double, record::size> largest{};
        for (const FixedPoint& strip : part.fixed_points)
            for (std::size_t c = 0; c < largest.size(); ++c)
                largest[c] = std::max(largest[c], strip.largest[c]);
        exchange.max(largest.data(), record::size);
        for (std::size_t c = 0; c < largest.size(); ++c) {
            const bool fits =
                largest[c] == 0.0 || (largest[c] >= least_size && largest[c] < FixedPoint::limit);
            if (fits) continue;
            part.scale[c] = std::ldexp(part.scale[c], aim - std::ilogb(largest[c]));
            again = true;
        }
    }
    return again;
}

void Simulation::scatter_fixed(unsigned parts_wanted) {
    do {
        for (Part& part : parts) {
            std::fill(part.integers.begin(), part.integers.end(), NodeIntegers{});
            for (FixedPoint& strip : part.fixed_points) {
                strip = {};
                strip.nodes = part.integers.data();
                std::copy(part.scale.begin(), part.scale.end(), strip.scale);
            }
        }
        scatter_strips(parts_wanted);
    } while (rescale());
    for (Part& part : parts) {
        exchange.sum_nodes(part.integers.data(), static_cast<std::ptrdiff_t>(part.integers.size()));
        for (std::size_t i = 0; i < part.integers.size(); ++i)
            for (int c = 0; c < record::size; ++c)
                part.records[i][c] += static_cast<double>(part.integers[i].value[c]) /
                                      part.scale[static_cast<std::size_t>(c)];
    }
}

}  // namespace grit::mpm
