// SPDX-License-Identifier: BSD-3-Clause
// What is drawn for which kind of test.
#pragma once

#include <string>
#include <vector>

#include "cli/plot/picture.hpp"
#include "cli/table/table.hpp"

namespace cli {

const std::vector<std::string>& picture_names();
// For a laboratory test: "triaxial_drained" -> "triaxial", or "cyclic".
std::string picture_of(const std::string& test, bool cyclic);
// For a path of strain_11 ... p of which no more is known.
std::string picture_of_path(const Table& path);
// Of a result, without those of its cycles.
std::vector<std::string> columns_of_picture(const std::string& kind);

// A curve of a picture: a result, a reference or laboratory data, with standard column names.
struct Curve {
    std::string label;
    Table table;
    Table cycles;  // may be empty
    bool points = false;
    int colour = 0;  // -1: that of data
};

Picture picture_of_curves(const std::string& kind, const std::string& title,
                          const std::vector<Curve>& curves);

// One panel for each y, over x, of columns by name. Throws BadInput naming the nearest where a curve has no such column.
Picture picture_of_columns(const std::string& x, const std::vector<std::string>& ys,
                           const std::string& title, const std::vector<Curve>& curves);

// Panels of a kind's picture.
std::size_t panels_of(const std::string& kind);

// One of them, by number from 0.
Panel panel_of_curves(const std::string& kind, std::size_t number,
                      const std::vector<Curve>& curves);

}  // namespace cli
