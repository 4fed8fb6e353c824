// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "cli/process/exit_code.hpp"

namespace cli {

struct ReportRequest {
    std::filesystem::path folder;
    std::filesystem::path out;  // empty: index.html in the folder
    std::string title;
    std::filesystem::path story;  // empty: none
};

// One page with everything in it: tables with verdicts, curves to be looked into, pictures, the frames of material points.
// Throws BadInput.
ExitCode report_folder(const ReportRequest& request);

}  // namespace cli
