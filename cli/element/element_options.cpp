// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/element_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "cli/element/element_command.hpp"
#include "cli/element/element_keys.hpp"
#include "cli/element/incremental_driver_command.hpp"
#include "cli/process/option_checks.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/toml/set_option.hpp"

namespace cli {

void add_element_command(CLI::App& app, Command& asked) {
    CLI::App* element =
        app.add_subcommand("element", "Run element tests, see docs/element-tests.md");
    const auto request = std::make_shared<ElementRequest>();
    CLI::Option* cases = element->add_option("CASE", request->cases,
                                             "TOML files; several are compared in one picture");
    const std::string prints = "Print a case that has and explains every key, and no more";
    CLI::Option* keys = element->add_flag("--keys", prints);
    CLI::Option* out = element->add_option("--out", request->out,
                                           "Folder for data and pictures, made if missing [.]");
    element->add_flag("--no-plot", request->no_plot, "Data only");
    element->add_flag("--quiet", request->quiet, "The table of references alone");
    CLI::Option* sand = element->add_option(
        "--sand", request->sand,
        "Name of a sand, or a file as grit calibrate writes it, instead of the cases' own");
    CLI::Option* set = add_set_option(*element, request->settings, "sand.critical_void_ratio=0.9");
    CLI::Option* vary =
        element
            ->add_option("--vary", request->varied,
                         "KEY=VALUE,VALUE,...: a run for each, in one picture where tests may be "
                         "together; of several all combinations")
            ->take_all()
            ->expected(1)
            ->allow_extra_args(false);
    CLI::Option* residuals = element->add_flag(
        "--residuals", request->residuals, "Print the residuals of Newton's method for every row");
    const auto driver = std::make_shared<IncrementalDriverRequest>();
    CLI::Option* folder =
        element->add_option("--incremental-driver", driver->folder,
                            "Folder of incrementalDriver's input files, see "
                            "docs/incremental-driver.md; output goes there or to --out");
    folder->excludes(cases)->excludes(residuals)->excludes(sand)->excludes(set)->excludes(vary);
    CLI::Option* umat = element->add_option("--umat", request->umat.library,
                                            "Library with a UMAT or VUMAT, instead of Grit's sand");
    element
        ->add_option("--layout", request->umat.layout,
                     "PROPS and STATEV of that library [classic], see docs/umat.md")
        ->check(one_of({"classic", "radian"}))
        ->needs(umat)
        ->excludes(folder);
    element->callback([&asked, request, driver, cases, folder, out, keys] {
        if (*keys) {
            asked = [] {
                say("{}", element_keys());
                return ok;
            };
            return;
        }
        if (!*cases && !*folder) throw CLI::RequiredError("CASE, --incremental-driver or --keys");
        if (!*folder) {
            asked = [request] { return run_element_tests(*request); };
            return;
        }
        if (*out) driver->out = request->out;
        driver->umat = request->umat.library;
        driver->no_plot = request->no_plot;
        driver->quiet = request->quiet;
        asked = [driver] { return run_incremental_driver(*driver); };
    });
}

}  // namespace cli
