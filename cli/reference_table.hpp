// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/case_file.hpp"
#include "element/driver.hpp"

namespace cli {

// Keys a [reference] may have a value for, at the end of the loading.
const std::vector<std::string>& reference_quantities();

struct Comparison {
    std::string text;    // lines: case | quantity | computed | reference | difference | limit
    bool within = true;  // every difference is within the tolerance of its case
};

// One table over all cases; empty if none has a reference.
Comparison compare(const std::vector<CaseFile>& cases, const std::vector<element::Run>& runs);

}  // namespace cli
