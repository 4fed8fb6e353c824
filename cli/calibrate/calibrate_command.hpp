// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "cli/process/exit_code.hpp"

namespace cli {

struct CalibrateRequest {
    std::filesystem::path file;
    std::filesystem::path out = ".";
    std::optional<long> samples;  // instead of the case's
    int threads = 0;              // 0: as many as there are processors; changes no result
    bool quiet = false;           // nothing but errors
};

// Find the parameters, write DIR/<case>_sand.toml and the report, print what was found. Throws BadInput before
// anything is computed if any of the files is wrong, or if one would be overwritten.
ExitCode run_calibration(const CalibrateRequest& request);

}  // namespace cli
