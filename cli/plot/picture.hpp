// SPDX-License-Identifier: BSD-3-Clause
// Pictures by gnuplot.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace cli {

struct Series {
    std::string label;  // empty: not in the key
    std::vector<double> x, y;
    int colour = 0;  // of the palette; -1: that of data
    bool points = false;
    int dashes = 0;  // of a line, 0: none
};

struct Panel {
    std::string title;  // above the panel, may be empty
    std::string x_label, y_label;
    bool log_x = false;
    double x_from = NAN;  // where the axis begins, if data begin later
    bool y_from_zero = false;
    bool own_key = false;  // above it, not above the picture
    std::vector<Series> series;
};

// Whether there is more to see than nothing or the noise of a computation.
bool says_anything(const Panel& panel);

struct Picture {
    std::string title;             // plain text, or gnuplot's markup ...
    bool title_in_markup = false;  // ... if this says so
    int columns = 2;
    int width = 500, height = 400;  // of one panel [px]
    bool pdf = false;               // also stem.pdf
    bool labels_above = false;      // the title names the axes of all panels
    std::vector<Panel> panels;
};

// stem.svg and stem.png, written beside and renamed. Returns what went wrong, empty if nothing.
std::string draw(const std::filesystem::path& stem, const Picture& picture);

}  // namespace cli
