// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/command.hpp"

namespace cli {

// grit calibrate CASE
void add_calibrate_command(CLI::App& app, Command& asked);

}  // namespace cli
