// SPDX-License-Identifier: BSD-3-Clause
// Texts that are compiled in: cmake/GritEmbed.cmake writes them.
#pragma once

#include <string>

namespace cli {

const std::string& chart_library();  // Chart.js; empty where the build had none
const std::string& page_script();
const std::string& page_style();

}  // namespace cli
