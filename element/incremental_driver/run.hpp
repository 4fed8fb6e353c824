// SPDX-License-Identifier: BSD-3-Clause
// A folder of incrementalDriver input, from files to the file it asks for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "element/incremental_driver/lines.hpp"
#include "element/record.hpp"

namespace incremental_driver {

struct Request {
    std::filesystem::path folder;  // of parameters.inp, initialconditions.inp, test.inp
    std::filesystem::path out;     // folder of the output file, empty: the same
    std::filesystem::path umat;    // library with the law, empty: Grit's sand, classic layout
};

struct Report {
    std::filesystem::path output;
    long increments = 0;
    long rows = 0;
    std::vector<std::string> exits;  // conditions that ended a step
    std::string failure;             // the run stopped early; the rows before that are written
};

// Throws BadInput before anything is computed or written if one of the files is wrong, or if the
// output would overwrite one of them. listeners.record sees what is written.
Report run(const Request& request, const element::Listeners& listeners = {});

}  // namespace incremental_driver
