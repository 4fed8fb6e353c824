// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/charts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/plot/contents.hpp"
#include "cli/plot/history_panels.hpp"
#include "cli/plot/panels.hpp"
#include "cli/plot/thinning.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/report/json_text.hpp"
#include "cli/table/foreign_columns.hpp"
#include "element/number.hpp"

namespace cli {
namespace {

// "Grit 0.1.0, case NAME: TITLE".
std::string title_in(const std::vector<std::string>& comments) {
    if (comments.empty() || !comments.front().starts_with("Grit ")) return "";
    const std::size_t at = comments.front().find(": ");
    return at == std::string::npos ? "" : comments.front().substr(at + 2);
}

// All columns over the first.
std::vector<Panel> plain(const Table& table) {
    const auto label = [](const Column& column) {
        return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
    };
    Panel out;
    out.x_label = label(table.columns.front());
    for (std::size_t i = 1; i < table.columns.size(); ++i) {
        const Column& column = table.columns[i];
        Series series{label(column), table.columns.front().values, column.values,
                      static_cast<int>(i) - 1, false};
        const auto known = [](double value) { return std::isfinite(value); };
        if (std::any_of(series.y.begin(), series.y.end(), known))
            out.series.push_back(thinned(series));
    }
    if (out.series.size() == 1) out.y_label = out.series.front().label;
    return out.series.empty() ? std::vector<Panel>{} : std::vector<Panel>{out};
}

std::vector<Panel> panels_in(const Finding& finding, const std::vector<std::string>& comments,
                             const Table& table) {
    Curve curve{"computed", standardised(table)};
    const std::string kind = picture_of_result(comments, curve.table);
    if (kind.empty()) return plain(table);
    if (kind == "history") return picture_of_histories({curve}, "").panels;
    if (is_of_cycles(curve.table)) std::swap(curve.table, curve.cycles);
    if (!finding.cycles.empty()) curve.cycles = read_table(finding.cycles);
    const bool of_cycles = finding.cycles.empty() || shows_cycles(kind);
    return picture_of_curves(of_cycles ? kind : "degradation", "", {curve}).panels;
}

bool all_numbers(const Table& table) {
    return std::all_of(table.columns.begin(), table.columns.end(),
                       [](const Column& column) { return column.problem.empty(); });
}

// Gnuplot's marks become characters of their own: a_{11}.
std::string unmarked(const std::string& label) {
    static const std::pair<const char*, const char*> marks[] = {
        {"_{11}", "₁₁"}, {"_{22}", "₂₂"}, {"_v", "ᵥ"}, {"_a", "ₐ"}, {"_r", "ᵣ"}, {"_0", "₀"}};
    std::string out = label;
    for (const auto& [mark, character] : marks)
        for (std::size_t at; (at = out.find(mark)) != std::string::npos;)
            out.replace(at, std::char_traits<char>::length(mark), character);
    return out;
}

}  // namespace

Shown shown_of(const Finding& finding) {
    Shown out;
    out.comments = comments_above(finding.table);
    out.title = title_in(out.comments);
    const Table table = read_table(finding.table);
    if (all_numbers(table)) out.panels = panels_in(finding, out.comments, table);
    if (out.panels.empty()) out.cells = read_cells(finding.table).rows;
    return out;
}

std::string json_of(const std::vector<Panel>& panels) {
    std::string out = "[";
    for (const Panel& panel : panels) {
        const bool marked = !panel.own_key && panel.series.size() <= 2;  // labels of axis.hpp
        const auto words = [&](const std::string& label) {
            return json_text(marked ? unmarked(label) : label);
        };
        out += fmt::format("{}{{\"x\":{},\"y\":{},\"log\":{},\"zero\":{},\"series\":[",
                           out.size() > 1 ? "," : "", words(panel.x_label), words(panel.y_label),
                           panel.log_x, panel.y_from_zero);
        for (const Series& series : panel.series)
            out += fmt::format("{}{{\"label\":{},\"points\":{},\"colour\":{},\"x\":{},\"y\":{}}}",
                               &series == &panel.series.front() ? "" : ",",
                               json_text(series.label.empty() ? panel.y_label : series.label),
                               series.points, series.colour, json_numbers(series.x),
                               json_numbers(series.y));
        out += "]}";
    }
    return out + "]";
}

}  // namespace cli
