// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "cli/exit_code.hpp"

namespace cli {

struct MpmRequest {
    std::filesystem::path file;
    std::filesystem::path out = ".";
    std::optional<int> threads;  // instead of the case's
    bool no_plot = false;
    bool quiet = false;
};

// Run a case, write DIR/<case>.csv. Throws BadInput before anything is computed if the case is wrong, or
// if a file would be overwritten.
ExitCode run_mpm(const MpmRequest& request);

}  // namespace cli
