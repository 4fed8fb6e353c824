// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml/set_option.hpp"

#include <CLI/CLI.hpp>

namespace cli {

CLI::Option* add_set_option(CLI::App& command, std::vector<std::string>& settings,
                            const std::string& example) {
    return command.add_option("--set", settings, "KEY=VALUE instead of a case's, as " + example)
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
}

}  // namespace cli
