// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/report_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "cli/report/report_command.hpp"

namespace cli {

void add_report_command(CLI::App& app, Command& asked) {
    CLI::App* report = app.add_subcommand(
        "report", "One page of HTML of all results in a folder, see docs/report.md");
    const auto request = std::make_shared<ReportRequest>();
    report->add_option("DIR", request->folder, "Folder with results, and folders in it")
        ->required();
    report->add_option("--out", request->out, "The page [DIR/index.html]");
    report->add_option("--title", request->title, "Above the page [the folder's name]");
    report->add_option("--story", request->story,
                       "Headings, and sentences about results, in their order");
    report->callback([&asked, request] { asked = [request] { return report_folder(*request); }; });
}

}  // namespace cli
