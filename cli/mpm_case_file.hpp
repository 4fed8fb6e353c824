// SPDX-License-Identifier: BSD-3-Clause
// Runs of the material-point driver as TOML files; verification/mpm/every_key.toml shows and explains
// every key.
#pragma once

#include <filesystem>
#include <vector>

#include <adapters/mpm/case.hpp>

namespace cli {

struct MpmCaseFile {
    grit::mpm::Case plan;
    std::vector<std::filesystem::path> inputs;  // all files that were read
};

// Throws BadInput naming file, line and key.
MpmCaseFile read_mpm_case(const std::filesystem::path& path);

}  // namespace cli
