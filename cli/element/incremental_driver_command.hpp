// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "cli/process/exit_code.hpp"

namespace cli {

struct IncrementalDriverRequest {
    std::filesystem::path folder;  // of parameters.inp, initialconditions.inp, test.inp
    std::filesystem::path out;     // folder for the output file, empty: the same
    std::filesystem::path umat;    // empty: Grit's own sand
    bool no_plot = false;
    bool quiet = false;
};

// Run the folder (docs/incremental-driver.md) and write the file that test.inp names, and a
// picture beside it.
// Throws BadInput before anything is computed or written if any of the files is wrong.
ExitCode run_incremental_driver(const IncrementalDriverRequest& request);

}  // namespace cli
