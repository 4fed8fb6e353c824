// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace element {

// An array that notices when a callee writes beyond its end.
class Guarded {
  public:
    explicit Guarded(std::size_t size) : n(size), values(size + guard_size, guard) {
        std::fill_n(values.begin(), n, 0.0);
    }
    explicit Guarded(int size) : Guarded(static_cast<std::size_t>(size)) {}

    void fill(const double* from) { std::copy_n(from, n, values.begin()); }
    double* data() { return values.data(); }
    bool intact() const {
        return std::all_of(values.begin() + static_cast<std::ptrdiff_t>(n), values.end(),
                           [](double x) { return x == guard; });
    }
    bool finite() const {
        return std::all_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n),
                           [](double x) { return std::isfinite(x); });
    }

  private:
    static constexpr double guard = -1.3717421e+271;  // no law computes it
    static constexpr std::size_t guard_size = 64;     // UMATs overrun by a few

    std::size_t n;
    std::vector<double> values;
};

}  // namespace element
