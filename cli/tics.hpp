// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace cli {

// Places of the numbers on a logarithmic axis from low to high > low > 0: decades, or digits of every
// decade, or even steps where the axis is short; three at least.
std::vector<double> logarithmic_tics(double low, double high);

}  // namespace cli
