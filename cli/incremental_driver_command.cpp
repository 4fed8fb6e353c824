// SPDX-License-Identifier: BSD-3-Clause
#include "cli/incremental_driver_command.hpp"

#include <fmt/format.h>

#include "cli/progress.hpp"
#include "incremental_driver/run.hpp"

namespace cli {

ExitCode run_incremental_driver(const IncrementalDriverRequest& request) {
    Progress progress(request.folder.string());
    incremental_driver::Report report;
    try {
        report = incremental_driver::run({request.folder, request.out, request.umat},
                                         [&](const element::Progress& now) {
                                             progress(now.increment, now.increments);
                                             return true;
                                         });
    } catch (const incremental_driver::BadInput& error) {
        throw BadInput(error.what());
    }
    progress.finish();
    fmt::print("data:    {}\n{} increments, {} rows, {:.3f} s\n", report.output.string(),
               report.increments, report.rows, progress.seconds());
    for (const std::string& exit : report.exits) fmt::print("exit:    {}\n", exit);
    if (report.failure.empty()) return ok;
    std::fflush(stdout);
    fmt::print(stderr, "grit: stopped early at {}\n", report.failure);
    return failed_computation;
}

}  // namespace cli
