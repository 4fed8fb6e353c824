// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml/case_setting.hpp"

namespace cli {

std::string words_of(const std::vector<CaseSetting>& settings) {
    std::string out;
    for (const CaseSetting& setting : settings) {
        out += out.empty() ? "with " : ", ";
        for (const char c : setting.text) out += c == '\n' || c == '\r' ? ' ' : c;
    }
    return out;
}

}  // namespace cli
