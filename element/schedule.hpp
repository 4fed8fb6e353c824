// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace element {

inline constexpr int increment_limit = 10000000;

// Shares of the path reached after 0, 1, ... increments, ending with 1: even, or geometric from the
// share of the first one. Strain is straight within an increment, so increments that follow a
// reversal must resolve R: they may start small and grow. Throws BadCase.
std::vector<double> schedule(int increments, double first_share);

// The same complaints without the shares.
void check_schedule(int increments, double first_share);

}  // namespace element
