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
#include "cli/report/result_head.hpp"
#include "cli/table/foreign_columns.hpp"
#include "element/number.hpp"

namespace cli {
namespace {

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
    else out.own_key = true;
    return out.series.empty() ? std::vector<Panel>{} : std::vector<Panel>{out};
}

Curve computed(const Finding& finding, const Table& table, const std::string& label, int colour) {
    Curve out;
    out.label = label;
    out.table = standardised(table);
    if (!finding.cycles.empty()) out.cycles = read_table(finding.cycles);
    out.colour = colour;
    return out;
}

// of: empty, or the run that it belongs to.
Curve reference(const Finding& finding, const std::string& of) {
    const bool measured = head_of(finding.reference).made.starts_with("measured");
    const std::string label = measured ? "measured" : "reference";
    return {of.empty() ? label : fmt::format("{}: {}", label, of),
            standardised(read_table(finding.reference)),
            {},
            true,
            -1};
}

// Of its picture; empty: it is none of grit element's or grit mpm's.
std::string kind_of(const Finding& finding, const Table& table) {
    return picture_of_result(comments_above(finding.table), table);
}

// Those of the kind, and below them what went on from cycle to cycle.
std::vector<Panel> panels_and_cycles(const std::string& kind, const std::vector<Curve>& curves) {
    std::vector<Panel> out = picture_of_curves(kind, "", curves).panels;
    if (shows_cycles(kind)) return out;
    for (Panel& panel : picture_of_curves("cycles", "", curves).panels)
        if (says_anything(panel)) out.push_back(std::move(panel));
    return out;
}

std::vector<Panel> panels_of_result(const Finding& finding, const std::string& kind, Curve curve) {
    if (kind == "history") return picture_of_histories({curve}, "").panels;
    if (is_of_cycles(curve.table)) std::swap(curve.table, curve.cycles);
    std::vector<Curve> curves = {curve};
    if (!finding.reference.empty()) curves.push_back(reference(finding, ""));
    return panels_and_cycles(kind, curves);
}

// Files of a run beside a comparison.
Finding run_beside(const Finding& comparison, const std::string& name) {
    const auto file = [&](const char* ending) {
        std::filesystem::path out = comparison.table.parent_path() / (name + ending);
        return std::filesystem::is_regular_file(out) ? out : std::filesystem::path();
    };
    Finding out;
    out.stem = name;
    out.table = file(".csv");
    out.cycles = file("_cycles.csv");
    out.reference = file("_reference.csv");
    return out;
}

std::vector<Panel> panels_of_comparison(const Finding& finding) {
    std::vector<Curve> runs, references;
    std::vector<std::string> names;
    std::string kind;
    for (const ComparedRun& run : compared_runs(finding)) {
        const Finding files = run_beside(finding, run.name);
        if (files.table.empty()) continue;
        const std::string label = run.label.empty() ? head_of(files.table).title : run.label;
        const Curve curve =
            computed(files, read_table(files.table), label, static_cast<int>(runs.size()));
        const std::string kind_of_run = kind_of(files, curve.table);
        if (kind_of_run.empty() || kind_of_run == "history") continue;
        if (kind.empty()) kind = kind_of_run;
        runs.push_back(curve);
        names.push_back(run.name);
        if (!files.reference.empty()) references.push_back(reference(files, label));
    }
    if (runs.size() < 2) return {};
    tell_apart(runs, names);
    runs.insert(runs.end(), references.begin(), references.end());
    return panels_and_cycles(kind, runs);
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

bool is_comparison(const Finding& finding) {
    return finding.table.filename() == "comparison.csv" &&
           read_cells(finding.table).rows.front() == std::vector<std::string>{"run", "label"};
}

std::vector<ComparedRun> compared_runs(const Finding& finding) {
    std::vector<ComparedRun> out;
    const std::vector<std::vector<std::string>> rows = read_cells(finding.table).rows;
    for (std::size_t i = 1; i < rows.size(); ++i) out.push_back({rows[i][0], rows[i][1]});
    return out;
}

Shown shown_of(const Finding& finding) {
    Shown out;
    if (is_comparison(finding)) {
        out.panels = panels_of_comparison(finding);
        out.compared = !out.panels.empty();
        out.command = "grit element";
    } else if (const Table table = read_table(finding.table); all_numbers(table)) {
        const Curve curve = computed(finding, table, "computed", 0);
        const std::string kind = kind_of(finding, curve.table);
        out.panels = kind.empty() ? plain(table) : panels_of_result(finding, kind, curve);
        if (!kind.empty()) out.command = kind == "history" ? "grit mpm" : "grit element";
    }
    if (out.panels.empty()) out.cells = read_cells(finding.table).rows;
    return out;
}

std::string json_of(const Shown& shown) {
    std::string out = "[";
    for (const Panel& panel : shown.panels) {
        const bool marked = shown.compared || (!panel.own_key && panel.series.size() <= 2);
        const auto words = [&](const std::string& label) {  // labels of axis.hpp
            return json_text(marked ? unmarked(label) : label);
        };
        out += fmt::format(
            "{}{{\"x\":{},\"y\":{},\"log\":{},\"from\":{},\"zero\":{},\"all\":{},\"key\":{},"
            "\"series\":[",
            out.size() > 1 ? "," : "", words(panel.x_label), words(panel.y_label), panel.log_x,
            std::isnan(panel.x_from) ? std::string("null") : fmt::format("{:.6g}", panel.x_from),
            panel.y_from_zero, shown.compared, panel.own_key);
        bool first = true;
        for (const Series& series : panel.series) {
            if (series.x.empty()) continue;  // a reference that has no such column
            out += fmt::format(
                "{}{{\"label\":{},\"points\":{},\"colour\":{},\"x\":{},\"y\":{}}}",
                first ? "" : ",", json_text(series.label.empty() ? panel.y_label : series.label),
                series.points, series.colour, json_numbers(series.x), json_numbers(series.y));
            first = false;
        }
        out += "]}";
    }
    return out + "]";
}

}  // namespace cli
