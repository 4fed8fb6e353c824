// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace cli {

// Which of stem.svg, stem.png and stem.pdf.
struct PictureFiles {
    bool svg = true, png = true, pdf = false;
};

// Pictures of width x height points, of definitions of data, then the drawing, once for each. Returns why there is none:
// that there is no gnuplot; empty if they are drawn. Throws element::CannotWrite.
std::string draw_with_gnuplot(const std::filesystem::path& stem, int width, int height,
                              const std::string& data, const std::string& drawing,
                              const PictureFiles& files);

// 'text' for a script, quotes doubled.
std::string gnuplot_quoted(const std::string& text);

}  // namespace cli
