// SPDX-License-Identifier: BSD-3-Clause
// What the words of a stage ask for, as programs of steps.
#pragma once

#include <string>
#include <vector>

#include "cli/toml/toml_table.hpp"
#include "element/step.hpp"

namespace cli {

struct StageProgram {
    element::Program steps;
    bool shear = false;  // loaded by gamma_12; otherwise along 11
    bool cyclic = false;
};

const std::vector<std::string>& test_names();

// The keys of one of these tests, with increments and duration. Throws BadInput.
StageProgram read_test(TomlTable& table, const std::string& test);

// The same program so many times.
element::Program repeated(element::Program program, int times);

}  // namespace cli
