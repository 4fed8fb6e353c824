// SPDX-License-Identifier: BSD-3-Clause
// A case computed.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cli/element/case_file.hpp"
#include "cli/table/table.hpp"

namespace cli {

struct CaseResult {
    Table table;   // a row per record; the columns that somebody wants
    Table cycles;  // a row per cycle, no columns if nothing was cycled
    std::string failure;
    std::vector<std::string> exits;  // conditions that ended a stage
    std::vector<std::string> never;  // conditions that did not
    long increments = 0, rows = 0;
    long iterations = 0, evaluations = 0, halvings = 0;
    double seconds = 0.0;
    double milliseconds = 0.0;  // of the fastest of five runs, if the case limits them
};

struct CaseOutput {
    std::filesystem::path csv;      // written while the run is going on
    std::set<std::string> columns;  // that are kept, besides stage and increment
    bool residuals = false;         // of Newton's method, printed for every row
};

// Shows progress on stderr. Throws element::CannotWrite.
CaseResult run_case(const CaseFile& file, const CaseOutput& output);

}  // namespace cli
