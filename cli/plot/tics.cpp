// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/tics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace cli {
namespace {

constexpr std::size_t fewest = 3;

std::vector<double> of_digits(double low, double high, const std::vector<int>& digits) {
    std::vector<double> out;
    for (double decade = std::pow(10.0, std::floor(std::log10(low))); decade <= high;
         decade *= 10.0)
        for (const int digit : digits)
            if (digit * decade >= low * (1.0 - 1e-9) && digit * decade <= high * (1.0 + 1e-9))
                out.push_back(digit * decade);
    return out;
}

}  // namespace

bool has_length(double low, double high) {
    return high - low > std::max(1e-7 * std::max(std::abs(low), std::abs(high)), 1e-300);
}

std::vector<double> even_tics(double low, double high) {
    if (!has_length(low, high)) return {low};
    const double unit = std::pow(10.0, std::floor(std::log10(high - low)) - 1.0);
    std::vector<double> out;
    for (const double step :
         {50.0 * unit, 20.0 * unit, 10.0 * unit, 5.0 * unit, 2.0 * unit, unit}) {
        out.clear();
        for (double i = std::ceil(low / step - 1e-9); i * step <= high * (1.0 + 1e-9); ++i)
            out.push_back(i * step + 0.0);  // never -0
        if (out.size() >= fewest + 1) break;
    }
    return out;
}

int longest_number(double low, double high) {
    if (!std::isfinite(low) || !std::isfinite(high)) return 0;
    if (!has_length(low, high)) {
        const double around = std::max(0.01 * std::abs(low), 1e-8);
        return longest_number(low - around, low + around);
    }
    const double unit = std::pow(10.0, std::floor(std::log10(high - low)));
    const double steps = 20.0 * unit / (high - low);  // gnuplot's quantize_normal_tics
    const double step = unit * (steps > 10.0 ? 0.2 : steps > 4.0 ? 0.5 : 1.0);
    std::size_t out = 0;
    for (double i = std::floor(low / step); i <= std::ceil(high / step); ++i)
        out = std::max(out, fmt::format("{:g}", i * step + 0.0).size());
    return static_cast<int>(out);
}

std::vector<double> logarithmic_tics(double low, double high) {
    if (!has_length(low, high)) return {low};
    for (const std::vector<int>& digits : {std::vector<int>{1}, {1, 2, 5}, {1, 2, 3, 5, 7}}) {
        const std::vector<double> out = of_digits(low, high, digits);
        if (out.size() >= fewest) return out;
    }
    return even_tics(low, high);
}

}  // namespace cli
