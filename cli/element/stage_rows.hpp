// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/table/table.hpp"

namespace cli {

struct StageRows {
    std::size_t first, last;
};

// The rows of a stage, from the state it begins with: the last row of the stage before, or its own row
// of increment 0 if its strains count anew. 0: all rows.
StageRows rows_of_stage(const Table& table, int stage);

}  // namespace cli
