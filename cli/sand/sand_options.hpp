// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/command.hpp"

namespace cli {

// grit sand list, grit sand show NAME
void add_sand_command(CLI::App& app, Command& asked);

}  // namespace cli
