// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/command.hpp"

namespace cli {

// grit plot RUN ... --data FILE ...
void add_plot_command(CLI::App& app, Command& asked);

}  // namespace cli
