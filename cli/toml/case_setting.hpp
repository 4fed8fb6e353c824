// SPDX-License-Identifier: BSD-3-Clause
// What an option changes in a case.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cli {

// "KEY=VALUE" with a key as of [override] in toml_document.hpp, and the option that it was given with; a value that is none
// of TOML is a text.
struct CaseSetting {
    CaseSetting(std::string key_and_value, std::string given_with = "--set")
        : text(std::move(key_and_value)), option(std::move(given_with)) {}

    std::string text, option;
};

// "with KEY=VALUE, KEY=VALUE, --sand SAND", of what a result says of its case: settings, and other options that change it;
// of none nothing.
std::string words_of(const std::vector<CaseSetting>& settings,
                     const std::vector<std::string>& options);

}  // namespace cli
