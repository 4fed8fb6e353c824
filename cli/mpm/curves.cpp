// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "cli/mpm/pictures.hpp"
#include "cli/plot/thinning.hpp"

namespace cli {
namespace {

struct Line {
    const char* column;
    const char* label;  // empty: it is alone
    // As they are called where nothing is a pile, see geometry_words.hpp.
    const char* other_column = nullptr;
    const char* other_label = nullptr;
};

struct Sheet {
    const char* quantity;
    const char* prefix;  // of the unit
    std::vector<Line> lines;
    double scale;  // values times this are shown
};

// Panels, and columns of the history that they show.
const std::vector<Sheet>& sheets() {
    static const std::vector<Sheet> all = {
        {"depth", "", {{"depth", ""}}, 1.0},
        {"velocity", "", {{"velocity", ""}}, 1.0},
        {"force",
         "",
         {{"hammer_force", "hammer", "load_force", "load"},
          {"tip_force", "tip", "under_force", "under it"},
          {"shaft_force", "shaft", "side_force", "sides"},
          {"base_force", "base"}},
         1.0},
        {"energy",
         "k",
         {{"external_work", "external"},
          {"rigid_work", "rigid bodies"},
          {"kinetic_energy", "kinetic"},
          {"stored_energy", "stored"},
          {"contact_loss", "contact"},
          {"transfer_loss", "mapping"}},
         1e-3},
        {"energy residual", "", {{"energy_residual", ""}}, 1.0},
        {"time step", "µ", {{"dt", ""}}, 1e6},
    };
    return all;
}

const Column* column_of(const Table& table, const Line& line, const char*& label) {
    for (const Column& column : table.columns) {
        if (column.name == line.column) return label = line.label, &column;
        if (line.other_column && column.name == line.other_column)
            return label = line.other_label, &column;
    }
    return nullptr;
}

bool is_zero(const std::vector<double>& values) {
    for (const double x : values)
        if (std::isfinite(x) && x != 0.0) return false;
    return true;
}

}  // namespace

Picture picture_of_history(const Table& history, const std::string& title) {
    Picture out;
    out.title = title;
    const std::vector<double>& t = history.at("t");
    for (const Sheet& sheet : sheets()) {
        Panel panel;
        panel.x_label = "time [s]";
        panel.own_key = sheet.lines.size() > 1;
        int colour = 0;
        for (const Line& line : sheet.lines) {
            const int own = colour++;
            const char* label = nullptr;
            const Column* column = column_of(history, line, label);
            if (!column || (panel.own_key && is_zero(column->values))) continue;
            if (panel.y_label.empty())
                panel.y_label =
                    fmt::format("{} [{}{}]", sheet.quantity, sheet.prefix, column->unit);
            Series series{label, t, column->values, own, false};
            for (double& x : series.y) x *= sheet.scale;
            panel.series.push_back(thinned(series));
        }
        if (!panel.series.empty()) out.panels.push_back(std::move(panel));
    }
    return out;
}

}  // namespace cli
