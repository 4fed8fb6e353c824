// SPDX-License-Identifier: BSD-3-Clause
// A case computed.
#pragma once

#include <string>
#include <vector>

#include "cli/case_file.hpp"
#include "cli/table.hpp"

namespace cli {

struct CaseResult {
    Table table;   // a row per record
    Table cycles;  // a row per cycle, no columns if nothing was cycled
    std::string failure;
    std::vector<std::string> exits;  // conditions that ended a stage
    long increments = 0;
    int iterations = 0, evaluations = 0, halvings = 0;
    double seconds = 0.0;
    double milliseconds = 0.0;  // of the fastest of five runs, if the case limits them
};

// Shows progress on stderr. Throws BadInput where the case makes no sense.
CaseResult run_case(const CaseFile& file);

}  // namespace cli
