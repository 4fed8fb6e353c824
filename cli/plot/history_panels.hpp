// SPDX-License-Identifier: BSD-3-Clause
// Histories of grit mpm over time.
#pragma once

#include <string>
#include <vector>

#include "cli/plot/panels.hpp"

namespace cli {

bool is_history(const Table& table);
std::vector<std::string> columns_of_histories();

// Depth, velocity, forces, energies and time step of histories, as far as they have them; of several the label tells which.
// Throws BadInput where they are in different units.
Picture picture_of_histories(const std::vector<Curve>& curves, const std::string& title);

}  // namespace cli
