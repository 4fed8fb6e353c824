// SPDX-License-Identifier: BSD-3-Clause
#include "cli/sand/sand_options.hpp"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/process/option_checks.hpp"
#include "cli/sand/sand_command.hpp"

namespace cli {

void add_sand_command(CLI::App& app, Command& asked) {
    CLI::App* sand = app.add_subcommand("sand", "Sands with published parameters");
    sand->require_subcommand(1);
    sand->add_subcommand("list", "Names and status")->callback([&] { asked = list_sands; });
    CLI::App* show = sand->add_subcommand("show", "Parameters and source of one sand");
    const auto name = std::make_shared<std::string>();
    show->add_option("NAME", *name,
                     "As grit sand list prints it, or a file as grit calibrate writes it")
        ->required();
    const auto form = std::make_shared<std::string>();
    CLI::Option* props = show->add_option("--props", *form, "As PROPS of a UMAT, see docs/umat.md")
                             ->check(one_of(props_forms()));
    const auto void_ratio = std::make_shared<double>(0.0);
    show->add_option("--void-ratio", *void_ratio, "Of the sample, for PROPS")
        ->check(within(0.01, 10.0))
        ->needs(props);
    show->callback([&asked, name, form, void_ratio] {
        asked = [name, form, void_ratio] {
            return form->empty() ? show_sand(*name) : show_props(*name, *form, *void_ratio);
        };
    });
}

}  // namespace cli
