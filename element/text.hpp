// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace element {

// printf into a string: enough for messages, and no dependency.
template <typename... Arguments> std::string text(const char* format, Arguments... arguments) {
    std::string out(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, arguments...)), ' ');
    std::snprintf(out.data(), out.size() + 1, format, arguments...);
    return out;
}

}  // namespace element
