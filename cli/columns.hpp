// SPDX-License-Identifier: BSD-3-Clause
// What a row of a result holds: names, units and how they follow from a record.
#pragma once

#include <string>
#include <vector>

#include "cli/table.hpp"
#include "element/grit_law.hpp"
#include "element/record.hpp"

namespace cli {

// A record and where it belongs.
struct StagedRecord {
    int stage = 0;       // from 1, 0: the start
    bool shear = false;  // loaded by gamma_12; otherwise along 11
    element::Record record;
};

// Columns that every result has; state variables of the law follow them.
const std::vector<std::string>& standard_column_names();

// sand: null where the law is not Grit's, whose internal quantities are then NaN.
Table tabulate(const std::vector<StagedRecord>& records, const element::GritLaw* sand,
               const std::vector<std::string>& state_names);

}  // namespace cli
