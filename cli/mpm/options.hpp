// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/command.hpp"

namespace cli {

// grit mpm CASE, grit mpm --keys WHICH
void add_mpm_command(CLI::App& app, Command& asked);

}  // namespace cli
