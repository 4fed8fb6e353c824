// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/plot_command.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/panels.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/table/columns.hpp"
#include "cli/table/foreign_columns.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

using Renames = std::map<std::string, std::string>;  // theirs to ours

// Names that --column may give: our own, and what we understand of others.
std::vector<std::string> understood() {
    std::vector<std::string> out = foreign_column_names();
    out.insert(out.end(), standard_column_names().begin(), standard_column_names().end());
    return out;
}

bool is_in(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Renames renames_of(const std::vector<std::string>& columns) {
    Renames out;
    for (const std::string& each : columns) {
        const std::size_t equals = each.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == each.size())
            throw BadInput(
                fmt::format("--column needs OURS=THEIRS, as q_kPa=Deviator, got \"{}\"", each));
        const std::string ours = each.substr(0, equals);
        if (!is_in(understood(), ours))
            throw BadInput(fmt::format("--column: there is no column \"{}\"{}", ours,
                                       element::suggestion(ours, understood())));
        out[each.substr(equals + 1)] = ours;
    }
    return out;
}

// Of the data, with the names that --column gives.
Table read_data(const fs::path& path, const std::string& only, const Renames& renames) {
    Table out = read_table(path, only);
    for (Column& column : out.columns)
        if (const auto found = renames.find(column.name); found != renames.end())
            column.name = found->second;
    return out;
}

// What nobody has taken notice of is said: it may be the column that is missing in the picture.
void say_unused(const fs::path& path, const Table& table, bool first_is_a_name) {
    std::string names;
    for (const Column& column : table.columns)
        if (!is_in(understood(), column.name) &&
            !(first_is_a_name && &column == &table.columns.front()))
            names += (names.empty() ? "" : ", ") + column.name;
    if (!names.empty())
        say("{}: not used: {}; --column OURS=THEIRS says what a column is\n", path.string(), names);
}

// What is understood and not in such a picture; stresses and strains are parts of p, q and the like.
void say_not_drawn(const fs::path& path, const Table& data, const std::string& kind) {
    const std::vector<std::string> drawn = columns_of_picture(kind);
    std::string names;
    for (const Column& column : data.columns) {
        const Table alone = standardised({{column}});
        const std::string& name = alone.columns.front().name;
        const bool part = name.starts_with("stress_") || name.starts_with("strain_");
        if (is_in(understood(), column.name) && !part && !is_in(drawn, name))
            names += (names.empty() ? "" : ", ") + column.name;
    }
    if (!names.empty()) say("{}: not in a picture of {}: {}\n", path.string(), kind, names);
}

// The stem, and the folder where another file has the same.
std::string label_of(const fs::path& path, const std::vector<fs::path>& all) {
    const auto twin = [&](const fs::path& other) {
        return other != path && other.stem() == path.stem();
    };
    const std::string folder = path.parent_path().filename().string();
    return (std::any_of(all.begin(), all.end(), twin) && !folder.empty() ? folder + "/" : "") +
           path.stem().string();
}

void check_used(const Renames& renames, const std::vector<fs::path>& data) {
    for (const auto& [theirs, ours] : renames) {
        std::vector<std::string> known;
        for (const fs::path& path : data) {
            const Cells cells = read_cells(path);
            for (const std::string& cell : cells.rows.front())
                known.push_back(grit::csv::head_of(cell).name);
        }
        if (!is_in(known, theirs))
            throw BadInput(fmt::format("--column {}={}: none of the data has a column {}{}", ours,
                                       theirs, theirs, element::suggestion(theirs, known)));
    }
}

Curve curve_of(const fs::path& path, const std::string& only, bool points, int colour,
               const Renames& renames = {}) {
    Curve out;
    out.label = path.stem().string() + (only.empty() ? "" : " " + only);
    out.table = standardised(read_data(path, only, renames));
    fs::path cycles = path;
    cycles.replace_filename(path.stem().string() + "_cycles.csv");
    if (!points && fs::exists(cycles)) out.cycles = read_table(cycles);
    out.points = points;
    out.colour = colour;
    return out;
}

bool says_anything(const Picture& picture, const PlotRequest& request,
                   const std::vector<Curve>& curves) {
    const auto cycled = [](const Curve& curve) { return curve.cycles.rows() > 0; };
    if (request.kind == "degradation" && std::none_of(curves.begin(), curves.end(), cycled))
        return false;
    return std::any_of(picture.panels.begin(), picture.panels.end(), [](const Panel& panel) {
        return std::any_of(panel.series.begin(), panel.series.end(),
                           [](const Series& series) { return !series.x.empty(); });
    });
}

}  // namespace

ExitCode plot(const PlotRequest& request) {
    const std::vector<std::string>& kinds = picture_names();
    if (std::find(kinds.begin(), kinds.end(), request.kind) == kinds.end())
        throw BadInput(fmt::format("--kind must be one of {}; got \"{}\"{}", fmt::join(kinds, ", "),
                                   request.kind, element::suggestion(request.kind, kinds)));
    const Renames renames = renames_of(request.columns);
    check_used(renames, request.data);
    std::vector<Curve> curves;
    for (const fs::path& run : request.runs)
        curves.push_back(curve_of(run, "", false, static_cast<int>(curves.size())));
    for (std::size_t i = 0; i < request.runs.size(); ++i)
        curves[i].label = label_of(request.runs[i], request.runs);
    for (std::size_t i = 0; i < request.data.size(); ++i)
        curves.push_back(curve_of(request.data[i], request.only, true,
                                  i == 0 ? -1 : static_cast<int>(curves.size()), renames));
    const bool by_kind = request.x.empty();
    for (const fs::path& path : request.data) {
        const Table data = read_data(path, request.only, renames);
        if (by_kind) say_unused(path, data, !request.only.empty());
        if (by_kind) say_not_drawn(path, data, request.kind);
    }
    Picture picture = by_kind ? picture_of_curves(request.kind, request.title, curves)
                              : picture_of_columns(request.x, request.y, request.title, curves);
    picture.pdf = request.pdf;
    if (!says_anything(picture, request, curves))
        throw BadInput(
            fmt::format("none of the files has columns for a picture of {}", request.kind));
    Outputs outputs;
    std::vector<std::string> endings = {".svg", ".png"};
    if (request.pdf) endings.emplace_back(".pdf");
    for (const std::string& ending : endings)
        outputs.add(request.out.string() + ending, "the picture");
    const auto lock = outputs.lock();
    const std::string problem = draw(request.out, picture);
    if (!problem.empty()) {
        warn("grit: no picture: {}\n", problem);
        return failed_computation;
    }
    say("picture: {}.svg and .png{}\n", request.out.string(), request.pdf ? ", .pdf" : "");
    return ok;
}

}  // namespace cli
