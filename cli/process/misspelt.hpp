// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cli {

// What a command line that cannot be understood may have meant: the first command or option of it that there is none of,
// with the nearest one. Empty: they are all known.
std::string misspelt(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace cli
