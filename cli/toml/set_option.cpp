// SPDX-License-Identifier: BSD-3-Clause
#include "cli/toml/set_option.hpp"

#include <CLI/CLI.hpp>

namespace cli {

CLI::Option* add_set_option(CLI::App& command, std::vector<CaseSetting>& settings,
                            const std::string& example) {
    return command
        .add_option_function<std::vector<std::string>>(
            "--set",
            [&settings](const std::vector<std::string>& texts) {
                settings.insert(settings.end(), texts.begin(), texts.end());
            },
            "KEY=VALUE instead of a case's, as " + example)
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
}

}  // namespace cli
