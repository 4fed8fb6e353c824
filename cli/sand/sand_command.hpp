// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/process/exit_code.hpp"

namespace cli {

ExitCode list_sands();
// Of the catalogue, or a file. Throws BadInput for an unknown name.
ExitCode show_sand(const std::string& name);

}  // namespace cli
