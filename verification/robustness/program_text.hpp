// SPDX-License-Identifier: BSD-3-Clause
// Numbers as a program in C has them, to the last bit.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace robustness {

inline std::string number_text(double x) {
    if (std::isnan(x)) return "(0.0 / 0.0)";
    if (std::isinf(x)) return x > 0.0 ? "1e999" : "-1e999";
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text;
}

// {a, b, c}; brackets "": without.
inline std::string numbers(const double* x, std::size_t n, const char* brackets = "{}") {
    std::string out;
    for (std::size_t i = 0; i < n; ++i) out += (i ? ", " : "") + number_text(x[i]);
    return brackets[0] ? brackets[0] + out + brackets[1] : out;
}

}  // namespace robustness
