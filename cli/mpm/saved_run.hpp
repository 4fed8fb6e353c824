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

    template <class Self, class Archive> static void visit(Self& run, Archive& archive) {
        grit::mpm::RunState::visit(run.state, archive);
        archive.texts(run.ends);
        archive.list(run.history);
        archive.list(run.frames);
        archive.value(run.next_frame);
    }
};

std::string bytes_of(const SavedRun& run);
// Throws std::runtime_error if these are not the bytes of a run of so many stages and columns.
SavedRun saved_run_of(std::string_view bytes, std::size_t stages, std::size_t columns);

}  // namespace cli
