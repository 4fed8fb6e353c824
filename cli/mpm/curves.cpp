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
};

struct Sheet {
    const char* y_label;
    std::vector<Line> lines;
    double scale;  // values times this are shown
};

// Panels, and columns of the history that they show.
const std::vector<Sheet>& sheets() {
    static const std::vector<Sheet> all = {
        {"depth [m]", {{"depth", ""}}, 1.0},
        {"velocity [m/s]", {{"velocity", ""}}, 1.0},
        {"force [kN]",
         {{"hammer_force", "hammer"},
          {"tip_force", "tip"},
          {"shaft_force", "shaft"},
          {"base_force", "base"}},
         1.0},
        {"energy [kJ]",
         {{"external_work", "external"},
          {"rigid_work", "rigid bodies"},
          {"kinetic_energy", "kinetic"},
          {"stored_energy", "stored"},
          {"contact_loss", "contact"},
          {"transfer_loss", "mapping"}},
         1e-3},
        {"energy residual [kJ]", {{"energy_residual", ""}}, 1e-3},
        {"time step [µs]", {{"dt", ""}}, 1e6},
    };
    return all;
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
        panel.y_label = sheet.y_label;
        panel.own_key = sheet.lines.size() > 1;
        int colour = 0;
        for (const Line& line : sheet.lines) {
            const int own = colour++;
            const std::vector<double>* values = history.find(line.column);
            if (!values || (panel.own_key && is_zero(*values))) continue;
            Series series{line.label, t, *values, own, false};
            for (double& x : series.y) x *= sheet.scale;
            panel.series.push_back(thinned(series));
        }
        if (!panel.series.empty()) out.panels.push_back(std::move(panel));
    }
    return out;
}

}  // namespace cli
