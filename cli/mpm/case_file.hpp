// SPDX-License-Identifier: BSD-3-Clause
// Runs of the material-point driver as TOML files; verification/mpm/every_key.toml shows and explains
// every key.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <adapters/mpm/case/case.hpp>

#include "cli/mpm/fields.hpp"
#include "cli/toml/case_setting.hpp"

namespace cli {

// [fields]: files for ParaView.
struct FieldsPlan {
    double interval = 0.0;  // between times [s]; 0: the start and the ends of stages alone
    std::vector<MpmField> variables;
};

struct MpmCaseFile {
    grit::mpm::Case plan;
    std::optional<FieldsPlan> fields;
    std::vector<std::filesystem::path> inputs;  // all files that were read
    std::vector<std::string> given;             // "KEY = VALUE" of all that it says, ascending
};

// sand: a file whose parameters take the place of those of all bodies of sand, empty: none. settings: "KEY=VALUE", see
// toml_document.hpp. Throws BadInput naming file, line and key.
MpmCaseFile read_mpm_case(const std::filesystem::path& path, const std::filesystem::path& sand = {},
                          const std::vector<CaseSetting>& settings = {});

}  // namespace cli
