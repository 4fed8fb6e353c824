// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace cli {

// stem.svg and stem.png of width x height points, stem.pdf if that is wanted, of definitions of data, then the drawing, once
// for each. Returns why there is none: that there is no gnuplot; empty if it is drawn. Throws element::CannotWrite.
std::string draw_with_gnuplot(const std::filesystem::path& stem, int width, int height,
                              const std::string& data, const std::string& drawing,
                              bool pdf = false);

// 'text' for a script, quotes doubled.
std::string gnuplot_quoted(const std::string& text);

}  // namespace cli
