// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/plotted_data.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/contents.hpp"
#include "cli/plot/history_panels.hpp"
#include "cli/plot/panels.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/table/columns.hpp"
#include "cli/table/foreign_columns.hpp"
#include "cli/table/laboratory_unit.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

bool is_in(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void append(Names& names, const Names& more) {
    for (const std::string& name : more)
        if (!is_in(names, name)) names.push_back(name);
}

bool is_part(const std::string& name) {
    return name.starts_with("stress_") || name.starts_with("strain_");
}

// Our own names, and what we understand of others.
Names understood() {
    Names out = foreign_column_names();
    append(out, standard_column_names());
    append(out, columns_of_pictures());
    append(out, columns_of_histories());
    return out;
}

// Of these what pictures draw, those of laboratories first.
Names drawn_names() {
    Names out = laboratory_column_names();
    append(out, columns_of_pictures());
    for (const std::string& name : standard_column_names())
        if (is_part(name)) append(out, {name});
    return out;
}

// "q": q_kPa, before names with as many letters changed.
std::string hint(const std::string& name, const Names& known) {
    Names longer;
    for (const std::string& each : known)
        if (each.starts_with(name + "_")) longer.push_back(each);
    if (longer.empty()) return element::suggestion(name, known);
    return fmt::format("; nearest: {}", fmt::join(longer, ", "));
}

std::string header_of(const Column& column) {
    return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

// "Axial strain (%)": "Axial strain".
std::string without_unit(const std::string& header) {
    const std::string unit = unit_in_brackets(header);
    return unit.empty() ? header
                        : grit::csv::trimmed(header.substr(0, header.size() - unit.size() - 2));
}

// Of what lies on one side of zero; 0: on both.
int sign_of(const std::vector<double>& values) {
    constexpr double most_beyond = 1.0 / 3.0;
    double low = 0.0, high = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    return -low < most_beyond * high ? 1 : high < most_beyond * -low ? -1 : 0;
}

void rename(Column& column, const std::string& ours) {
    if (column.unit.empty()) column.unit = unit_in_brackets(column.name);
    const char* unit = unit_of_column(ours);
    const std::string said = unit_in(column.name);
    if (column.unit.empty() && unit && laboratory_unit(said, unit)) column.unit = said;
    column.name = ours;
}

// Tables in it, to be named instead of it.
std::string results_in(const fs::path& folder) {
    constexpr std::size_t most = 5;
    Names out;
    std::error_code problem;
    for (fs::directory_iterator at(folder, problem), end; !problem && at != end;
         at.increment(problem))
        if (at->path().extension() == ".csv") out.push_back(at->path().string());
    if (out.empty()) return fmt::format("{} is a folder, without results", folder.string());
    std::sort(out.begin(), out.end());
    const std::string more = out.size() > most ? fmt::format(", ... ({})", out.size()) : "";
    out.resize(std::min(out.size(), most));
    return fmt::format("{} is a folder: name results in it, {}{}; grit report {} shows all",
                       folder.string(), fmt::join(out, ", "), more, folder.string());
}

}  // namespace

Renames renames_of(const std::vector<std::string>& columns, bool any) {
    Names known = drawn_names();
    Renames out;
    for (const std::string& each : columns) {
        const std::size_t equals = each.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == each.size())
            throw BadInput(
                fmt::format("--column needs OURS=THEIRS, as q_kPa=Deviator, got \"{}\"", each));
        const std::string ours = each.substr(0, equals);
        const bool drawn = is_in(known, standard_column_name(ours)) && is_in(understood(), ours);
        if (!is_in(understood(), ours))
            throw BadInput(fmt::format("--column {}: there is no column \"{}\"{}", each, ours,
                                       hint(ours, known)));
        if (!any && !drawn)
            throw BadInput(fmt::format("--column {}: no picture of a kind draws \"{}\"{}", each,
                                       ours, hint(ours, known)));
        out[each.substr(equals + 1)] = ours;
    }
    return out;
}

PlottedFile read_plotted(const fs::path& path, bool data, const std::string& only,
                         const Renames& renames) {
    if (fs::is_directory(path)) throw BadInput(results_in(path));
    PlottedFile out{path, data, "", read_table(path, only), {}};
    for (Column& column : out.named.columns) {
        auto found = renames.find(column.name);
        if (found == renames.end()) found = renames.find(header_of(column));
        if (found == renames.end()) found = renames.find(without_unit(column.name));
        if (found != renames.end()) rename(column, found->second);
    }
    out.standardised = standardised(out.named);
    out.kind = picture_of_result(comments_above(path), out.standardised);
    return out;
}

void check_renames_used(const Renames& renames, const std::vector<PlottedFile>& files) {
    for (const auto& [theirs, ours] : renames) {
        Names headers, names;
        for (const PlottedFile& file : files) {
            if (!file.data) continue;
            const Cells cells = read_cells(file.path);
            for (const std::string& cell : cells.rows.front()) {
                headers.push_back(cell);
                names.push_back(grit::csv::head_of(cell).name);
                names.push_back(without_unit(cell));
            }
        }
        if (!is_in(headers, theirs) && !is_in(names, theirs))
            throw BadInput(fmt::format("--column {}={}: none of the data has a column {}{}", ours,
                                       theirs, theirs, element::suggestion(theirs, headers)));
    }
}

void say_mirrored(const PlottedFile& data, const PlottedFile& run) {
    for (std::size_t i = 0; i < data.named.columns.size(); ++i) {
        const std::string& name = data.named.columns[i].name;
        const Column& column = data.standardised.columns[i];
        if (!is_in({"axial_strain", "stress_11", "stress_22"}, column.name)) continue;
        const auto is_opposite = [&](const Column& beside) {
            return beside.name == column.name &&
                   sign_of(beside.values) * sign_of(column.values) < 0;
        };
        if (std::none_of(run.standardised.columns.begin(), run.standardised.columns.end(),
                         is_opposite))
            continue;
        std::string laboratory;
        for (const std::string& each : laboratory_column_names())
            if (standard_column_name(each) == column.name) laboratory = each;
        say("{} of {} has the other sign than {}; {}\n", name, data.path.string(),
            run.path.string(),
            name == laboratory ? fmt::format("tension positive is {}", column.name)
                               : fmt::format("compression positive is {}", laboratory));
    }
}

void say_unused(const PlottedFile& data, bool first_is_a_name) {
    Names names;
    for (const Column& column : data.named.columns)
        if (!is_in(understood(), column.name) &&
            !(first_is_a_name && &column == &data.named.columns.front()))
            names.push_back(column.name);
    if (!names.empty())
        say("{}: not used: {}; --column OURS=THEIRS says what a column is\n", data.path.string(),
            fmt::join(names, ", "));
}

void say_not_drawn(const PlottedFile& data, const std::string& kind) {
    const Names drawn = columns_drawn(kind);
    Names names;
    for (const Column& column : data.named.columns) {
        const std::string name = standard_column_name(column.name);
        if (is_in(understood(), column.name) && !is_part(name) && !is_in(drawn, name))
            names.push_back(column.name);
    }
    if (!names.empty())
        say("{}: not in a picture of {}: {}\n", data.path.string(), kind, fmt::join(names, ", "));
}

}  // namespace cli
