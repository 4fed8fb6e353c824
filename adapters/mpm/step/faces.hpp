// SPDX-License-Identifier: BSD-3-Clause
// Contact forces apart by where they push.
#pragma once

#include <array>
#include <cmath>

#include "adapters/mpm/kernel/exchange.hpp"
#include "support/vector.hpp"

namespace grit::mpm {

// Forces [N] of contact whose direction is more along r, as on a shaft, and more along z, as at a tip.
struct Faces {
    Vector2 along_r{0.0, 0.0}, along_z{0.0, 0.0};

    static bool is_along_z(double n_r, double n_z) { return std::fabs(n_z) > std::fabs(n_r); }

    // Of a surface with this normal; what bears, its pressure along z, does so at the tip wherever it acts.
    void add(const Vector2& normal, const Vector2& force, double bearing) {
        if (is_along_z(normal[0], normal[1])) {
            along_z = along_z + force;
            return;
        }
        along_z[1] += bearing;
        along_r = along_r + Vector2{force[0], force[1] - bearing};
    }
};

// ... added up over the nodes that each process counts.
class FaceSums {
  public:
    explicit FaceSums(bool in_fixed_point) : fixed_point(in_fixed_point) {}
    void add(const double* normal, const double* force) {
        const std::size_t first = Faces::is_along_z(normal[0], normal[1]) ? 2 : 0;
        sums[first].add(force[0], fixed_point);
        sums[first + 1].add(force[1], fixed_point);
    }
    Faces of_all(Exchange& exchange) {
        exchange.sum(sums, fixed_point);
        return {{sums[0].value(), sums[1].value()}, {sums[2].value(), sums[3].value()}};
    }

  private:
    bool fixed_point;
    std::array<Total, 4> sums;
};

}  // namespace grit::mpm
