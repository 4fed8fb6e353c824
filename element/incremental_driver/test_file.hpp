// SPDX-License-Identifier: BSD-3-Clause
// test.inp: the name of the output file, then steps up to *End or the end of the file.
#pragma once

#include "element/incremental_driver/step_reader.hpp"
#include "element/step.hpp"

namespace incremental_driver {

// Of every step as element::simulate counts them, repetitions counted through.
struct StepNote {
    int line = 0;  // of its keyword
    std::string name;
};

struct Test {
    std::string output;  // name of the file, within the folder of the output
    int output_line = 0;
    std::string heading;  // behind # on the first line, empty: none
    element::Program program;
    std::vector<StepNote> notes;
    std::vector<std::filesystem::path> inputs;  // tables of *ImportFile
};

// Throws BadInput. Files of *ImportFile are read too, from the folder of path.
Test read_test(const std::filesystem::path& path, const std::vector<std::string>& state_names);

}  // namespace incremental_driver
