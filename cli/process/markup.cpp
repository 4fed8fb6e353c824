// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/markup.hpp"

namespace cli {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '&'   ? "&amp;"
               : c == '<' ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '"' ? "&quot;"
                          : std::string(1, c);
    return out;
}

}  // namespace cli
