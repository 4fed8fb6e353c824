// SPDX-License-Identifier: BSD-3-Clause
// The columns of a history.
#pragma once

#include <span>

#include "adapters/mpm/run/run.hpp"

namespace grit::mpm {

struct HistoryColumn {
    const char* name;
    const char* unit;  // "" for numbers
    double (*value)(const HistoryRow&);
};

// In space some more, behind those of the plane.
std::span<const HistoryColumn> history_columns(bool in_space = false);

}  // namespace grit::mpm
