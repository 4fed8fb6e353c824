// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/option_checks.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "element/nearest.hpp"

namespace cli {

CLI::Validator one_of(std::vector<std::string> words) {
    const std::string type = fmt::format("{{{}}}", fmt::join(words, ","));
    return CLI::Validator(
        [words = std::move(words)](const std::string& word) {
            if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
            return fmt::format("there is no \"{}\"{}", word, element::suggestion(word, words));
        },
        type);
}

CLI::Validator within(double low, double high) {
    const std::string range = fmt::format("in [{:g}, {:g}]", low, high);
    return CLI::Validator(
        [=](const std::string& word) {
            double value = 0.0;
            if (CLI::detail::lexical_cast(word, value) && value >= low && value <= high)
                return std::string();
            return fmt::format("must be {}, got {}", range, word);
        },
        range);
}

}  // namespace cli
