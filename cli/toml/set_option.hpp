// SPDX-License-Identifier: BSD-3-Clause
// --set KEY=VALUE, of every command that reads a case.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cli {

// settings: for parse_document. example: a key and its value.
CLI::Option* add_set_option(CLI::App& command, std::vector<std::string>& settings,
                            const std::string& example);

}  // namespace cli
