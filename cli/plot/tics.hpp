// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace cli {

// Whether an axis from low to high has any length, where data are written with eight digits.
bool has_length(double low, double high);

// Places of the numbers on a logarithmic axis from low to high > low > 0: decades, or digits of every
// decade, or even steps where the axis is short; three at least.
std::vector<double> logarithmic_tics(double low, double high);

// Multiples of 1, 2 or 5 times a power of ten between low and high: four or a few more; low alone where that has no length.
std::vector<double> even_tics(double low, double high);

// Characters of the longest number that gnuplot writes at a linear axis of its own choice.
int longest_number(double low, double high);

}  // namespace cli
