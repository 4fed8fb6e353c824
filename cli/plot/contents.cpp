// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/contents.hpp"

#include <algorithm>
#include <initializer_list>

#include "cli/plot/history_panels.hpp"
#include "cli/plot/panels.hpp"

namespace cli {
namespace {

const std::string of_picture = "picture: ";

bool has_numbers(const Table& table, const std::string& name) {
    return std::any_of(table.columns.begin(), table.columns.end(), [&](const Column& column) {
        return column.name == name && column.problem.empty();
    });
}

bool is_path(const Table& table) {
    const auto names = {"stress_11",  "strain_11",         "strain_22", "strain_33",     "gamma_12",
                        "void_ratio", "volumetric_strain", "p",         "axial_deviator"};
    return std::all_of(names.begin(), names.end(),
                       [&](const char* name) { return has_numbers(table, name); });
}

}  // namespace

const std::vector<std::string>& plot_kinds() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out = picture_names();
        out.emplace_back("history");
        return out;
    }();
    return names;
}

std::vector<std::string> columns_drawn(const std::string& kind) {
    if (kind == "history") return columns_of_histories();
    std::vector<std::string> out = columns_of_picture(kind);
    const std::vector<std::string> cycles = columns_of_cycles(kind);
    out.insert(out.end(), cycles.begin(), cycles.end());
    return out;
}

std::string picture_comment(const std::string& picture) { return of_picture + picture; }

bool is_of_cycles(const Table& table) {
    const std::vector<std::string> others = columns_of_cycles("cycles");
    return has_numbers(table, "cycle") &&
           std::any_of(others.begin(), others.end(), [&](const std::string& name) {
               return name != "cycle" && has_numbers(table, name);
           });
}

std::string picture_of_result(const std::vector<std::string>& comments, const Table& table) {
    const std::vector<std::string>& known = picture_names();
    for (const std::string& comment : comments)
        if (comment.starts_with(of_picture)) {
            const auto named =
                std::find(known.begin(), known.end(), comment.substr(of_picture.size()));
            if (named != known.end()) return *named;
        }
    if (is_of_cycles(table)) return "cycles";
    if (is_history(table)) return "history";
    return is_path(table) ? picture_of_path(table) : "";
}

}  // namespace cli
