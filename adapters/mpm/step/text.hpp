// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstdio>
#include <string>

namespace grit::mpm {

// A number in a message: six digits.
inline std::string text(double value) {
    char out[32];
    std::snprintf(out, sizeof out, "%.6g", value);
    return out;
}

// ... with as many as tell it from any other.
inline std::string exact_text(double value) {
    char out[32];
    return {out, std::to_chars(out, out + sizeof out, value).ptr};
}

// "(0.1, -0.2) m", of r or x and z.
inline std::string place_text(double across, double z) {
    char out[72];
    std::snprintf(out, sizeof out, "(%.6g, %.6g) m", across, z);
    return out;
}

}  // namespace grit::mpm
