// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

// The larger of two numbers, NaN if either is: std::max and std::fmax lose a NaN, and what is then
// expected of the worst of many differences holds.
inline double larger(double a, double b) { return a < b || std::isnan(b) ? b : a; }
