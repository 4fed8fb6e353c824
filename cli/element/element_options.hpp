// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/command.hpp"

namespace cli {

// grit element CASE ..., grit element --incremental-driver FOLDER
void add_element_command(CLI::App& app, Command& asked);

}  // namespace cli
