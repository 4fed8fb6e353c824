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
// Of its cycles.
std::vector<std::string> columns_of_cycles(const std::string& kind);
// That have a panel in any picture, or are an axis of one.
std::vector<std::string> columns_of_pictures();
// The kind whose panels have the most of these columns; empty: none has a panel's two.
std::string picture_of_columns_named(const std::vector<std::string>& columns);
// Whether tests of these kinds may be in one picture: their first panels are the same.
bool may_be_together(const std::string& a, const std::string& b);
// Whether it needs a result's cycles.
bool shows_cycles(const std::string& kind);

// A curve of a picture: a result, a reference or laboratory data, with standard column names.
struct Curve {
    std::string label;
    Table table;
    Table cycles{};  // may be empty
    bool points = false;
    int colour = 0;  // -1: that of data
};

// A label that several of them have gets the name of each, in the same order.
void tell_apart(std::vector<Curve>& curves, const std::vector<std::string>& names);

// Without panels that show nothing or noise alone, unless none is left. Of results with a row for each cycle these count
// on from stage to stage.
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
