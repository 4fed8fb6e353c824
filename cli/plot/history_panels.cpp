// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/history_panels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/plot/thinning.hpp"
#include "cli/process/exit_code.hpp"

namespace cli {
namespace {

struct HistoryLine {
    const char* column;
    const char* label;  // empty: it is alone
    // As they are called where nothing is a pile, see cli/mpm/geometry_words.hpp.
    const char* other_column = nullptr;
    const char* other_label = nullptr;
};

struct HistorySheet {
    const char* quantity;
    const char* prefix;  // of the unit
    std::vector<HistoryLine> lines;
    double scale;           // values times this are shown
    bool of_steps = false;  // since the row before: where no step was made, there is none
};

// Panels, and columns of the history that they show.
const std::vector<HistorySheet>& sheets() {
    static const std::vector<HistorySheet> all = {
        {"depth", "", {{"depth", ""}}, 1.0},
        {"velocity", "", {{"velocity", ""}}, 1.0},
        {"force",
         "",
         {{"hammer_force", "hammer", "load_force", "load"},
          {"tip_force", "tip", "under_force", "under it"},
          {"shaft_force", "shaft", "side_force", "sides"},
          {"base_force", "base"}},
         1.0,
         true},
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
        {"time step", "µ", {{"dt", ""}}, 1e6, true},
    };
    return all;
}

const Column* column_of(const Table& table, const HistoryLine& line, const char*& label) {
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

// Its rows that have a step before them; all, where it does not tell steps.
std::vector<char> rows_of_steps(const Table& history) {
    std::vector<char> out(history.rows(), 1);
    if (const std::vector<double>* dt = history.find("dt"))
        std::transform(dt->begin(), dt->end(), out.begin(), [](double x) { return x != 0.0; });
    return out;
}

// Adds the curve's line of a sheet to its panel, number `own` of the sheet's; beside others in the key by its label.
void add_line(Panel& panel, const HistorySheet& sheet, std::size_t own, const Curve& curve,
              int number, bool several) {
    const char* label = nullptr;
    const std::vector<double>* t = curve.table.find("t");
    const Column* column = column_of(curve.table, sheet.lines[own], label);
    if (!t || !column || (panel.own_key && is_zero(column->values))) return;
    if (!column->problem.empty()) throw BadInput(column->problem);
    const std::string y_label =
        fmt::format("{} [{}{}]", sheet.quantity, sheet.prefix, column->unit);
    if (panel.y_label.empty()) panel.y_label = y_label;
    if (y_label != panel.y_label)
        throw BadInput(fmt::format("{}: {} is in {}, and of what is drawn beside it {}",
                                   curve.label, column->name, y_label, panel.y_label));
    Series series{label, {}, {}, static_cast<int>(own), curve.points};
    const std::vector<char> stepped = rows_of_steps(curve.table);
    for (std::size_t i = 0; i < t->size(); ++i) {
        if (sheet.of_steps && !stepped[i]) {
            panel.x_from = std::fmin(panel.x_from, (*t)[i]);
            continue;
        }
        series.x.push_back((*t)[i]);
        series.y.push_back(sheet.scale * column->values[i]);
    }
    // Of several each has its dashes; in a panel with a key of its own this tells the lines of one.
    const auto called = [&](const Series& other) { return other.label == series.label; };
    if (several && !panel.own_key) series.label = curve.label;
    else if (std::any_of(panel.series.begin(), panel.series.end(), called)) series.label.clear();
    if (!panel.own_key && curve.points) series.colour = curve.colour;
    if (!panel.own_key && !curve.points) series.colour = number;
    series.dashes = number;
    panel.series.push_back(curve.points ? spaced(series) : thinned(series));
}

}  // namespace

bool is_history(const Table& table) {
    const auto has = [&](const char* name) {
        return std::any_of(table.columns.begin(), table.columns.end(),
                           [&](const Column& column) { return column.name == name; });
    };
    return has("t") && has("depth") && has("velocity") && has("kinetic_energy") &&
           has("energy_residual");
}

std::vector<std::string> columns_of_histories() {
    std::vector<std::string> out = {"t"};
    for (const HistorySheet& sheet : sheets())
        for (const HistoryLine& line : sheet.lines) {
            out.emplace_back(line.column);
            if (line.other_column) out.emplace_back(line.other_column);
        }
    return out;
}

Picture picture_of_histories(const std::vector<Curve>& curves, const std::string& title) {
    Picture out;
    out.title = title;
    for (const HistorySheet& sheet : sheets()) {
        Panel panel;
        panel.x_label = "time [s]";
        panel.own_key = sheet.lines.size() > 1;
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (std::size_t own = 0; own < sheet.lines.size(); ++own)
                add_line(panel, sheet, own, curves[i], static_cast<int>(i), curves.size() > 1);
        if (!panel.series.empty()) out.panels.push_back(std::move(panel));
    }
    return out;
}

}  // namespace cli
