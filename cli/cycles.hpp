// SPDX-License-Identifier: BSD-3-Clause
// Stiffness and damping of every cycle.
#pragma once

#include <vector>

#include "cli/table.hpp"

namespace cli {

// A cycle runs from one reversal of the shear strain to the second after it. Of each: secant shear
// modulus from tip to tip, damping ratio D = loop area/(2 pi G gamma^2), and the state at its end.
// cyclic: of every stage. No columns where there is no whole cycle.
Table cycles_of(const Table& result, const std::vector<bool>& cyclic);

}  // namespace cli
