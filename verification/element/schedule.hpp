// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "element/case.hpp"

namespace element {

// Shares of the path reached after 0, 1, ... increments, ending with 1. Strain is straight within
// an increment, so increments that follow a reversal must resolve R: they may start small and grow
// geometrically. Throws BadCase.
std::vector<double> schedule(const Loading& loading);

}  // namespace element
