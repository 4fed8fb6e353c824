// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/command.hpp"

namespace cli {

// grit doctor, grit completion and grit man. The latter two print what app knows once the command line is parsed.
void add_guide_commands(CLI::App& app, Command& asked);

}  // namespace cli
