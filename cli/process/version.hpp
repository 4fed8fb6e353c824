// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace cli {

// Of the library, and the commit of the program: "0.1.0 (0123456789ab)".
std::string version();

// What a result begins with: "Grit 0.1.0 (0123456789ab), case NAME: TITLE", of what "case NAME".
std::string made_by_grit(const std::string& what, const std::string& title);

// "grit 0.1.0 (0123456789ab), instruction set AVX2"
std::string version_and_instruction_set();

}  // namespace cli
