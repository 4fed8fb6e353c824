// SPDX-License-Identifier: BSD-3-Clause
// --set KEY=VALUE, of every command that reads a case.
#pragma once

#include <string>
#include <vector>

#include "cli/toml/case_setting.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cli {

// settings: added to. example: a key and its value.
CLI::Option* add_set_option(CLI::App& command, std::vector<CaseSetting>& settings,
                            const std::string& example);

}  // namespace cli
