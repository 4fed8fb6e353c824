// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/command.hpp"

namespace cli {

void add_report_command(CLI::App& app, Command& asked);

}  // namespace cli
