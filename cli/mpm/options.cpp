// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/options.hpp"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <adapters/mpm/case/case_words.hpp>

#include "cli/mpm/command.hpp"
#include "cli/process/option_checks.hpp"
#include "cli/toml/set_option.hpp"

namespace cli {

void add_mpm_command(CLI::App& app, Command& asked) {
    CLI::App* mpm =
        app.add_subcommand("mpm", "Run a material-point case, see docs/material-points.md");
    const auto request = std::make_shared<MpmRequest>();
    constexpr grit::mpm::Interval threads = grit::mpm::case_word("numerics", "threads").range;
    std::vector<std::string> tables;
    for (const auto& table : printed_tables()) tables.push_back(table.first);
    mpm->add_option("CASE", request->file, "TOML file");
    mpm->add_option(
           "--keys", request->keys,
           "Print the keys of case files, the words of fix grit/mpm, the variables of fields "
           "or the columns of the history, as in docs/")
        ->check(one_of(tables));
    mpm->add_option("--out", request->out, "Folder for data and pictures, made if missing [.]");
    mpm->add_option(
        "--sand", request->sand,
        "Name of a sand, or a file as grit calibrate writes it, for all bodies of sand");
    add_set_option(*mpm, request->settings, "body.soil.sand.void_ratio=0.7");
    mpm->add_option("--threads", request->threads, "Instead of the case's; changes no result")
        ->check(within(threads.low, threads.high));
    mpm->add_option("--checkpoint-minutes", request->checkpoint_minutes,
                    "Between checkpoints DIR/<case>.checkpoint; without, an interrupted run alone "
                    "leaves one")
        ->check(CLI::PositiveNumber);
    mpm->add_flag("--restart", request->restart, "Go on from the checkpoint in DIR");
    mpm->add_option("--to-lammps", request->to_lammps,
                    "Folder for the case as input of LAMMPS, see docs/lammps.md; computes nothing");
    mpm->add_flag("--no-plot", request->no_plot, "Data only");
    mpm->add_flag("--field-svg", request->field_svg,
                  "Pictures of fields as .svg too, megabytes each");
    mpm->add_flag("--quiet", request->quiet, "Nothing but errors");
    mpm->callback([&asked, request] {
        if (request->file.empty() && request->keys.empty())
            throw CLI::RequiredError("CASE or --keys");
        asked = [request] { return run_mpm(*request); };
    });
}

}  // namespace cli
