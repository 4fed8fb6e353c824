// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <functional>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <grit/grit.h>

#include "cli/element/element_command.hpp"
#include "cli/element/incremental_driver_command.hpp"
#include "cli/process/abnormal_end.hpp"
#include "cli/process/exit_code.hpp"
#ifdef GRIT_CLI_HAS_MPM
#include "cli/mpm/command.hpp"
#endif
#include "cli/plot/plot_command.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/process/version.hpp"
#include "cli/sand/sand_command.hpp"

namespace {

std::string version() {
    constexpr const char* names[] = {"", "baseline", "AVX2", "AVX-512"};
    return fmt::format("grit {}, instruction set {}", cli::version(),
                       names[grit_instruction_set()]);
}

#ifdef GRIT_CLI_HAS_MPM
void add_mpm_options(CLI::App& app, cli::MpmRequest& request) {
    app.add_option("CASE", request.file, "TOML file");
    app.add_option("--keys", request.keys,
                   "Print the keys of case files or the words of fix grit/mpm, as in docs/")
        ->check(CLI::IsMember({"cases", "fix"}));
    app.add_option("--out", request.out, "Folder for data and pictures, made if missing [.]");
    app.add_option("--threads", request.threads, "Instead of the case's; changes no result")
        ->check(CLI::Range(1, 1024));
    app.add_option("--checkpoint-minutes", request.checkpoint_minutes,
                   "Between checkpoints DIR/<case>.checkpoint; without, an interrupted run alone "
                   "leaves one")
        ->check(CLI::PositiveNumber);
    app.add_flag("--restart", request.restart, "Go on from the checkpoint in DIR");
    app.add_option("--to-lammps", request.to_lammps,
                   "Folder for the case as input of LAMMPS, see docs/lammps.md; computes nothing");
    app.add_flag("--no-plot", request.no_plot, "Data only");
    app.add_flag("--quiet", request.quiet, "Nothing but errors");
}
#endif

int follow(int argc, char** argv) {
    std::function<cli::ExitCode()> command;
    CLI::App app("Grit: hypoplastic sand. Exit status 0: done, 1: the computation failed or missed "
                 "its reference, 2: bad input.",
                 "grit");
    app.set_version_flag("--version", version());
    app.require_subcommand(1);

    CLI::App* sand = app.add_subcommand("sand", "Sands with published parameters");
    sand->require_subcommand(1);
    sand->add_subcommand("list", "Names and status")->callback([&] { command = cli::list_sands; });
    CLI::App* show = sand->add_subcommand("show", "Parameters and source of one sand");
    std::string name;
    show->add_option("NAME", name, "As grit sand list prints it")->required();
    show->callback([&] { command = [&] { return cli::show_sand(name); }; });

    CLI::App* element =
        app.add_subcommand("element", "Run element tests, see docs/element-tests.md");
    cli::ElementRequest request;
    CLI::Option* cases = element->add_option("CASE", request.cases,
                                             "TOML files; several are compared in one picture");
    CLI::Option* out = element->add_option("--out", request.out,
                                           "Folder for data and pictures, made if missing [.]");
    element->add_flag("--no-plot", request.no_plot, "Data only");
    element->add_flag("--quiet", request.quiet, "The table of references alone");
    CLI::Option* residuals = element->add_flag(
        "--residuals", request.residuals, "Print the residuals of Newton's method for every row");
    cli::IncrementalDriverRequest driver;
    CLI::Option* folder =
        element->add_option("--incremental-driver", driver.folder,
                            "Folder of incrementalDriver's input files, see "
                            "docs/incremental-driver.md; output goes there or to --out");
    folder->excludes(cases)->excludes(residuals);
    CLI::Option* umat = element->add_option("--umat", request.umat.library,
                                            "Library with a UMAT or VUMAT, instead of Grit's sand");
    element
        ->add_option("--layout", request.umat.layout,
                     "PROPS and STATEV of that library [classic], see docs/umat.md")
        ->check(CLI::IsMember({"classic", "radian"}))
        ->needs(umat)
        ->excludes(folder);
    element->callback([&] {
        if (!*cases && !*folder) throw CLI::RequiredError("CASE or --incremental-driver");
        if (*folder && *out) driver.out = request.out;
        driver.umat = request.umat.library;
        driver.no_plot = request.no_plot;
        driver.quiet = request.quiet;
        command = [&, of_folder = static_cast<bool>(*folder)] {
            return of_folder ? cli::run_incremental_driver(driver)
                             : cli::run_element_tests(request);
        };
    });

#ifdef GRIT_CLI_HAS_MPM
    CLI::App* mpm = app.add_subcommand("mpm", "Run a material-point case, see "
                                              "docs/material-points.md");
    cli::MpmRequest run;
    add_mpm_options(*mpm, run);
    mpm->callback([&] {
        if (run.file.empty() && run.keys.empty()) throw CLI::RequiredError("CASE or --keys");
        command = [&] { return cli::run_mpm(run); };
    });
#endif

    CLI::App* picture = app.add_subcommand("plot", "Draw results and laboratory data together");
    cli::PlotRequest plot;
    picture->add_option("RUN", plot.runs, "CSV files of grit element, drawn as lines");
    picture->add_option("--data", plot.data, "CSV files of laboratories, drawn as points");
    picture->add_option("--only", plot.only, "Rows of the data with this first cell");
    picture->add_option("--kind", plot.kind,
                        "Kind of picture, see docs/element-tests.md [triaxial]");
    picture->add_option("--title", plot.title, "Above the picture");
    picture->add_option("--out", plot.out, "Stem of the files .svg and .png [plot]");
    picture->callback([&] {
        if (plot.runs.empty() && plot.data.empty()) throw CLI::RequiredError("RUN or --data");
        command = [&] { return cli::plot(plot); };
    });

    try {
        app.parse(argc, argv);
        return command();
    } catch (const CLI::ParseError& error) {
        std::ostringstream help, complaint;
        const int status = app.exit(error, help, complaint);
        cli::say("{}", help.str());
        cli::warn("{}", complaint.str());
        return status == 0 ? cli::ok : cli::bad_input;
    } catch (const cli::BadInput& error) {
        cli::warn("grit: {}\n", error.what());
        return cli::bad_input;
    } catch (const std::exception& error) {
        cli::warn("grit: {}\n", error.what());
        return cli::failed_computation;
    }
}

}  // namespace

int main(int argc, char** argv) {
    cli::occupy_standard_streams();
    cli::handle_abnormal_ends();
    const int status = follow(argc, argv);
    const std::string unsaid = cli::unsaid();
    if (unsaid.empty()) return status;
    cli::warn("grit: {}\n", unsaid);
    return status == cli::ok ? int{cli::failed_computation} : status;
}
