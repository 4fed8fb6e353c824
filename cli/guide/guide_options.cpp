// SPDX-License-Identifier: BSD-3-Clause
#include "cli/guide/guide_options.hpp"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/guide/completion.hpp"
#include "cli/guide/doctor.hpp"
#include "cli/guide/manual_page.hpp"
#include "cli/process/option_checks.hpp"
#include "cli/process/standard_streams.hpp"

namespace cli {

void add_guide_commands(CLI::App& app, Command& asked) {
    app.add_subcommand("doctor",
                       "What this grit is, what it finds around it, and how to get what is missing")
        ->callback([&asked] { asked = examine; });
    CLI::App* completion =
        app.add_subcommand("completion", "Print the completion script of a shell");
    const auto shell = std::make_shared<std::string>();
    completion->add_option("SHELL", *shell, "As in: source <(grit completion bash)")
        ->required()
        ->check(one_of(shells()));
    completion->callback([&asked, &app, shell] {
        asked = [&app, shell] {
            say("{}", completion_of(words_of(app), *shell));
            return ok;
        };
    });
    app.add_subcommand("man", "Print the manual page, as in: grit man | man -l -")
        ->callback([&asked, &app] {
            asked = [&app] {
                say("{}", manual_page(words_of(app)));
                return ok;
            };
        });
}

}  // namespace cli
