// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/colour_range.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace cli {

ColourRange colour_range(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return {0.0, 1.0};
    std::sort(values.begin(), values.end());
    const double low = values.front(), high = values.back();
    const double least = std::max(1e-6 * std::max(std::abs(low), std::abs(high)), 1e-12);
    if (high - low < least) return {low - least, high + least};
    const std::size_t few = values.size() / 200;  // at each end
    const double inner_low = values[few], inner_high = values[values.size() - 1 - few];
    const double inner = inner_high - inner_low;
    // Hardly any inner range: most values are the same.
    if (inner > 0.5 * (high - low) || inner < 1e-3 * (high - low)) return {low, high};
    return {inner_low, inner_high, fmt::format("{:.3g} … {:.3g}", low, high)};
}

}  // namespace cli
