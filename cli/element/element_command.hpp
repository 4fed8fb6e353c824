// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/element/case_file.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/toml/case_setting.hpp"

namespace cli {

struct ElementRequest {
    std::vector<std::filesystem::path> cases;
    std::filesystem::path out = ".";
    UmatChoice umat;
    std::filesystem::path sand;         // instead of the sands of the cases, empty: none
    std::vector<CaseSetting> settings;  // "KEY=VALUE" instead of what the cases say
    std::vector<std::string> varied;    // "KEY=VALUE,VALUE...": a run for each
    bool no_plot = false;
    bool quiet = false;      // the table alone
    bool residuals = false;  // of Newton's method, printed
};

// Run every case, write DIR/<case>.csv, _cycles.csv and pictures, print the table beside the
// references. Throws BadInput before anything is computed if any of the files is wrong, or if one would
// be overwritten.
ExitCode run_element_tests(const ElementRequest& request);

}  // namespace cli
