// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/process/exit_code.hpp"

namespace cli {

struct PlotRequest {
    std::vector<std::filesystem::path> runs;  // lines
    std::vector<std::filesystem::path> data;  // points: laboratory sheets, references
    std::vector<std::string> columns;         // "OURS=THEIRS": what a column of the data is
    std::string only;                         // rows of the data whose first cell it is
    std::string kind;                         // of picture; empty: the files say it
    std::string x;                            // column; empty: kind says what is drawn
    std::vector<std::string> y;               // columns over it, a panel for each
    std::string title;
    bool pdf = false;                    // beside .svg and .png
    std::filesystem::path out = "plot";  // stem of the picture's files
};

// Runs and laboratory data in one picture. Throws BadInput.
ExitCode plot(const PlotRequest& request);

}  // namespace cli
