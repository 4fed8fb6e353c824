// SPDX-License-Identifier: BSD-3-Clause
// [[test]] of a calibration: sheets of a laboratory, and how the sample was treated.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/toml/toml_table.hpp"
#include "element/calibration/experiment.hpp"

namespace cli {

struct TestDefaults {
    grit_sand_parameters parameters{};  // for what the intergranular strain may be
    element::GritLawOptions options;
    element::Settings settings;
    double resolution = 1.0;  // times the usual number of increments
};

struct LaboratoryTests {
    std::vector<calibration::Experiment> experiments;
    std::vector<std::string> sources;  // of each: file, sheet, rows that are used
    std::vector<std::string> doubts;   // sentences about what may be wrong with the sheet
};

// One test, or one for each name in the column that its sheet is split by; the files read are added to inputs.
// Throws BadInput naming file, row, column or key.
LaboratoryTests read_tests(TomlTable table, const TestDefaults& defaults,
                           std::vector<std::filesystem::path>& inputs);

}  // namespace cli
