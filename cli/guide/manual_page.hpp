// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/guide/command_words.hpp"

namespace cli {

// grit(1), of the words that --help prints.
std::string manual_page(const CommandWords& grit);

}  // namespace cli
