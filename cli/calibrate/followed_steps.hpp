// SPDX-License-Identifier: BSD-3-Clause
// A step that leads a sample through the rows of a sheet.
#pragma once

#include <vector>

#include "cli/element/laboratory_words.hpp"

namespace cli {

struct Followed {
    element::Step step;
    std::vector<int> increments;  // after which a row is reached; of the first: 0
};

// From value to value of what drives the test: a strain, or the stress as the way's key gives it, which the sample has
// at the first. Increments are finest after each turn; resolution times as many as usual.
Followed follow(const Way& way, const std::vector<double>& values, double resolution);

}  // namespace cli
