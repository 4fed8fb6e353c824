// SPDX-License-Identifier: BSD-3-Clause
// Text within HTML and SVG.
#pragma once

#include <string>

namespace cli {

std::string escaped(const std::string& text);

}  // namespace cli
