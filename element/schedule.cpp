// SPDX-License-Identifier: BSD-3-Clause
#include "element/schedule.hpp"

#include <cmath>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// g of (g^n - 1)/(g - 1) = 1/first, by bisection: the sum grows with g, and g = 1 gives n.
double growth(int n, double first) {
    double low = 1.0, high = 1.0 / first;
    for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
        const double g = low + 0.5 * (high - low);
        const double sum = g > 1.0 ? std::expm1(n * std::log(g)) / (g - 1.0) : n;
        (sum < 1.0 / first ? low : high) = g;
    }
    return low;
}

}  // namespace

void check_schedule(int n, double first_share) {
    if (n < 1 || n > increment_limit)
        throw BadCase(text("increments must be in [1, %d], got %d", increment_limit, n));
    if (!(first_share * n <= 1.0 + 1e-9))
        throw BadCase(
            text("the first increment must be <= 1/%d of the path, got %g of it", n, first_share));
}

std::vector<double> schedule(int n, double first_share) {
    check_schedule(n, first_share);
    const double even = 1.0 / n;
    const double first = first_share > 0.0 ? first_share : even;
    std::vector<double> shares{0.0};
    const double g = first < even * (1.0 - 1e-9) ? growth(n, first) : 1.0;
    for (int i = 1; i < n; ++i)
        shares.push_back(g > 1.0 ? first * std::expm1(i * std::log(g)) / (g - 1.0) : i * even);
    shares.push_back(1.0);
    return shares;
}

}  // namespace element
