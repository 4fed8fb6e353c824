// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace cli {

// Of the library, "0.1.0".
std::string version();

// "grit 0.1.0, instruction set AVX2"
std::string version_and_instruction_set();

}  // namespace cli
