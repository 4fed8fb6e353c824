// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace cli {

// Of the library, "0.1.0".
std::string version();

}  // namespace cli
