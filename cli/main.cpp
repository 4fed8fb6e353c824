// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/element/element_options.hpp"
#include "cli/guide/guide_options.hpp"
#include "cli/plot/plot_options.hpp"
#include "cli/process/abnormal_end.hpp"
#include "cli/process/misspelt.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/process/version.hpp"
#include "cli/report/report_options.hpp"
#include "cli/sand/sand_options.hpp"
#ifdef GRIT_CLI_HAS_CALIBRATION
#include "cli/calibrate/calibrate_options.hpp"
#endif
#ifdef GRIT_CLI_HAS_MPM
#include "cli/mpm/options.hpp"
#endif

namespace {

int follow(int argc, char** argv) {
    cli::Command asked;
    CLI::App app("Grit: hypoplastic sand. Exit status 0: done, 1: the computation failed or missed "
                 "its reference, 2: bad input.",
                 "grit");
    app.footer("docs/...: in the source tree and the package grit-doc; grit doctor says where.");
    app.set_version_flag("--version", cli::version_and_instruction_set());
    app.require_subcommand(1);
    cli::add_sand_command(app, asked);
    cli::add_element_command(app, asked);
#ifdef GRIT_CLI_HAS_MPM
    cli::add_mpm_command(app, asked);
#endif
    cli::add_plot_command(app, asked);
#ifdef GRIT_CLI_HAS_CALIBRATION
    cli::add_calibrate_command(app, asked);
#else
    CLI::App* calibrate = app.add_subcommand("calibrate", "Left out of this build");
    calibrate->allow_extras();
    calibrate->callback([&asked] {
        asked = []() -> cli::ExitCode {
            throw cli::BadInput("calibrate: this grit was built without Ceres, libzip and pugixml, "
                                "see docs/calibration.md");
        };
    });
#endif
    cli::add_report_command(app, asked);
    cli::add_guide_commands(app, asked);
    std::vector<std::string> words(argv + 1, argv + std::max(argc, 1));
    if (!words.empty() && words.front() == "help") {  // as other programs have it
        words.erase(words.begin());
        if (cli::misspelt(app, words).empty()) words.emplace_back("--help");
    }
    if (words == std::vector<std::string>{"version"}) words = {"--version"};
    try {
        // As the parser takes them.
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return asked();
    } catch (const CLI::ParseError& error) {
        std::ostringstream help, complaint;
        const int status = app.exit(error, help, complaint);
        cli::say("{}", help.str());
        const std::string unknown = status == 0 ? "" : cli::misspelt(app, words);
        if (unknown.empty()) cli::warn("{}", complaint.str());
        else cli::warn("{}\nRun with --help for more information.\n", unknown);
        return status == 0 ? cli::ok : cli::bad_input;
    } catch (const cli::BadInput& error) {
        cli::warn("grit: {}\n", cli::legible(error.what()));
        return cli::bad_input;
    } catch (const std::bad_alloc&) {
        cli::warn("grit: this needs more memory than there is\n");
        return cli::failed_computation;
    } catch (const std::exception& error) {
        cli::warn("grit: {}\n", cli::legible(error.what()));
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
