// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml/case_setting.hpp"

namespace cli {
namespace {

void append_words(const std::string& words, std::string& out) {
    out += out.empty() ? "with " : ", ";
    for (const char c : words) out += c == '\n' || c == '\r' ? ' ' : c;
}

}  // namespace

std::string words_of(const std::vector<CaseSetting>& settings,
                     const std::vector<std::string>& options) {
    std::string out;
    for (const CaseSetting& setting : settings) append_words(setting.text, out);
    for (const std::string& option : options) append_words(option, out);
    return out;
}

}  // namespace cli
