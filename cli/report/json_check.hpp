// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace cli {

// Why a browser would not read this text as JSON, "LINE: why"; empty: it would.
std::string problem_of_json(const std::string& text);

}  // namespace cli
