// SPDX-License-Identifier: BSD-3-Clause
// Steps that lead a sample through the rows of a sheet.
#pragma once

#include <vector>

#include "cli/element/laboratory_words.hpp"

namespace cli {

// From value to value of what drives the test: a strain since the first row, or the stress as the way's key gives it.
// Increments are finest after each turn; resolution times as many as usual.
element::Program follow(const Way& way, const std::vector<double>& values, double resolution);

}  // namespace cli
