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
    std::vector<std::string> ends;   // how stages ended
    std::vector<double> history;     // all rows, one after the other
    std::vector<double> frames;      // times of fields [s]
    double next_frame = 0.0;         // [s]
    bool frame_is_open = false;      // fields of this time are still to be written
    std::vector<std::string> given;  // what its case says, "KEY = VALUE", ascending

    template <class Self, class Archive> static void visit(Self& run, Archive& archive) {
        grit::mpm::RunState::visit(run.state, archive);
        archive.texts(run.ends);
        archive.list(run.history);
        archive.list(run.frames);
        archive.value(run.next_frame);
        archive.value(run.frame_is_open);
        archive.texts(run.given);
    }
};

std::string bytes_of(const SavedRun& run);
// Throws std::runtime_error where the case of a checkpoint says something else that its run has begun with. How steps are
// taken, stages, loads and motions over time, and what is written may change.
void compare_cases(const std::vector<std::string>& written, const std::vector<std::string>& here);
// Throws std::runtime_error if these are not the bytes of a run of so many stages and columns.
SavedRun saved_run_of(std::string_view bytes, std::size_t stages, std::size_t columns);

}  // namespace cli
