// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "cli/process/exit_code.hpp"

namespace CLI {
class App;
}

namespace cli {

// What a command line asks for, once it is parsed. A room adds its subcommand to the program's; where the
// command line names it, it says in "asked" what to do. That must live as long as the app.
using Command = std::function<ExitCode()>;

}  // namespace cli
