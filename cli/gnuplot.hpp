// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace cli {

// Run a script. Returns what went wrong, empty if nothing.
std::string run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& log);

// 'text' for a script, quotes doubled.
std::string gnuplot_quoted(const std::string& text);

}  // namespace cli
