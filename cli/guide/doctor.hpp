// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/process/exit_code.hpp"

namespace cli {

// What this program is, what of its surroundings is there, and how to get what is missing.
ExitCode examine();

}  // namespace cli
