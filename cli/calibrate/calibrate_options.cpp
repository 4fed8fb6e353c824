// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/calibrate_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "cli/calibrate/calibrate_command.hpp"
#include "cli/calibrate/calibration_case.hpp"
#include "cli/process/option_checks.hpp"

namespace cli {

void add_calibrate_command(CLI::App& app, Command& asked) {
    CLI::App* calibrate = app.add_subcommand(
        "calibrate",
        "Find the parameters of a sand from laboratory tests, see docs/calibration.md");
    const auto request = std::make_shared<CalibrateRequest>();
    calibrate->add_option("CASE", request->file, "TOML file")->required();
    calibrate->add_option("--out", request->out,
                          "Folder for the sand and the report, made if missing [.]");
    calibrate
        ->add_option("--samples", request->samples,
                     "Of the posterior, instead of the case's; 0: none")
        ->check(within(0.0, most_samples));
    calibrate->add_option("--threads", request->threads, "Changes no result [all processors]")
        ->check(within(1.0, 1024.0));
    calibrate->add_flag("--quiet", request->quiet, "Nothing but errors");
    calibrate->callback(
        [&asked, request] { asked = [request] { return run_calibration(*request); }; });
}

}  // namespace cli
