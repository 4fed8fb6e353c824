// SPDX-License-Identifier: BSD-3-Clause
// What a material-point run has done so far, as bytes in front of its checkpoint.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <adapters/mpm/run/run.hpp>

namespace cli {

struct SavedRun {
    grit::mpm::RunState state;
    std::vector<std::string> ends;  // how stages ended
    std::vector<double> history;    // all rows, one after the other
    std::vector<double> frames;     // times of fields [s]
    double next_frame = 0.0;        // [s]
};

std::string bytes_of(const SavedRun& run);
// Throws std::runtime_error if these are not the bytes of a run of so many stages and columns.
SavedRun saved_run_of(std::string_view bytes, std::size_t stages, std::size_t columns);

}  // namespace cli
