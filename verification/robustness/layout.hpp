// SPDX-License-Identifier: BSD-3-Clause
// Numbers of n points in the memory of a host: in a row, by component, far apart, backwards.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <grit/view.h>

#include "support/trials/split_mix.hpp"

namespace robustness {

class Layout {
  public:
    Layout(grit::SplitMix& random, std::ptrdiff_t points, std::ptrdiff_t components)
        : count(components) {
        switch (random.below(5)) {
            case 0: point = components, each = 1; break;
            case 1: point = 1, each = points; break;
            case 2: point = components + 1 + random.below(7), each = 1; break;
            case 3: point = -2 * components, each = 2; break;
            default: point = -components * 257, each = -1;
        }
        const std::ptrdiff_t along = (points - 1) * point, across = (components - 1) * each;
        const std::ptrdiff_t low =
            std::min<std::ptrdiff_t>(0, along) + std::min<std::ptrdiff_t>(0, across);
        const std::ptrdiff_t high =
            std::max<std::ptrdiff_t>(0, along) + std::max<std::ptrdiff_t>(0, across);
        memory.assign(static_cast<std::size_t>(high - low + 1), 0.0);
        first = memory.data() - low;
    }
    void put(std::ptrdiff_t i, const double* values) {
        for (std::ptrdiff_t c = 0; c < count; ++c) first[i * point + c * each] = values[c];
    }
    void get(std::ptrdiff_t i, double* values) const {
        for (std::ptrdiff_t c = 0; c < count; ++c) values[c] = first[i * point + c * each];
    }
    std::ptrdiff_t components() const { return count; }
    // Is all 0, as at first, but the numbers of these points?
    bool blank_but(const std::vector<std::ptrdiff_t>& points) const {
        std::vector<double> rest = memory;
        for (const std::ptrdiff_t i : points)
            for (std::ptrdiff_t c = 0; c < count; ++c)
                rest[static_cast<std::size_t>(first - memory.data() + i * point + c * each)] = 0.0;
        return std::all_of(rest.begin(), rest.end(), [](double x) { return x == 0.0; });
    }
    grit_view in() const { return grit_view_of(first, point, each); }
    grit_mutable_view out() const { return grit_mutable_view_of(first, point, each); }
    grit_mutable_matrix_view matrix(std::ptrdiff_t size) const {
        return grit_mutable_matrix_view_of(first, point, each * size, each);
    }

  private:
    std::ptrdiff_t count, point = 0, each = 0;
    std::vector<double> memory;
    double* first;
};

// 0 ... n - 1 in any order.
inline std::vector<std::ptrdiff_t> shuffled(grit::SplitMix& random, std::ptrdiff_t n) {
    std::vector<std::ptrdiff_t> out(static_cast<std::size_t>(n));
    std::iota(out.begin(), out.end(), 0);
    for (std::size_t i = out.size(); i > 1; --i)
        std::swap(out[i - 1], out[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    return out;
}

}  // namespace robustness
