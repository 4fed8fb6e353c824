// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/element/case_run.hpp"

namespace cli {

struct Comparison {
    std::string text;  // lines: case | what | computed | reference | difference | limit
    std::vector<std::vector<std::string>>
        rows;            // the same as cells, a head and a verdict: within, EXCEEDED, told
    bool within = true;  // every difference is within the tolerance of its case
};

// One table over all cases; empty if none has a reference or a limit.
Comparison compare(const std::vector<CaseFile>& cases, const std::vector<CaseResult>& results);

}  // namespace cli
