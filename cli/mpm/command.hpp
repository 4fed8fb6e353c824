// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/process/exit_code.hpp"
#include "cli/toml/case_setting.hpp"

namespace cli {

struct MpmRequest {
    std::string keys;  // print this table, and no more; empty: none
    std::filesystem::path file;
    std::filesystem::path sand;  // instead of the sands of the case, empty: none
    std::filesystem::path out = ".";
    std::optional<int> threads;  // instead of the case's
    double checkpoint_minutes = 0.0;
    bool restart = false;
    std::vector<CaseSetting> settings;  // "KEY=VALUE", see toml_document.hpp
    bool no_plot = false;
    bool field_svg = false;  // pictures of fields as .svg too
    bool quiet = false;
    std::filesystem::path to_lammps;  // write the case for LAMMPS there, and no more; empty: run it
};

// Run a case, write DIR/<case>.csv. DIR/<case>.checkpoint is written every so many minutes, and when the
// run is interrupted, and removed when it is done. Throws BadInput before anything is computed if the
// case or the checkpoint is wrong, or if a file would be overwritten.
// By the word of --keys.
const std::map<std::string, std::string (*)()>& printed_tables();

ExitCode run_mpm(const MpmRequest& request);

}  // namespace cli
