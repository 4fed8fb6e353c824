// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/plot_command.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/contents.hpp"
#include "cli/plot/history_panels.hpp"
#include "cli/plot/panels.hpp"
#include "cli/plot/plotted_data.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/standard_streams.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

using Files = std::vector<PlottedFile>;

Files read_all(const PlotRequest& request) {
    const Renames renames = renames_of(request.columns, !request.x.empty());
    Files out;
    for (const fs::path& run : request.runs) out.push_back(read_plotted(run, false, "", {}));
    for (const fs::path& path : request.data)
        out.push_back(read_plotted(path, true, request.only, renames));
    check_renames_used(renames, out);
    return out;
}

std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> out;
    for (const Column& column : table.columns) out.push_back(column.name);
    return out;
}

// Of the picture in which all files may be: that of the first.
std::string common_kind(const Files& files) {
    const PlottedFile* first = nullptr;
    for (const PlottedFile& file : files) {
        if (file.kind.empty()) continue;
        if (!first) first = &file;
        if (!may_be_together(file.kind, first->kind))
            throw BadInput(fmt::format("{} is for a picture of {}, and {} for one of {}: draw them "
                                       "apart, or --kind says which picture it is to be",
                                       first->path.string(), first->kind, file.path.string(),
                                       file.kind));
    }
    if (first) return first->kind;
    for (const PlottedFile& file : files)
        if (std::string kind = picture_of_columns_named(names_of(file.standardised)); !kind.empty())
            return kind;
    throw BadInput(fmt::format("{}: no picture that is known here has two of its columns ({}); "
                               "--x COLUMN --y COLUMN,... draws any",
                               files.front().path.string(),
                               fmt::join(names_of(files.front().named), ", ")));
}

// The stem, and the folder where another file has the same.
std::string label_of(const PlottedFile& file, const Files& files) {
    const auto twin = [&](const PlottedFile& other) {
        return other.data == file.data && other.path != file.path &&
               other.path.stem() == file.path.stem();
    };
    const std::string folder = file.path.parent_path().filename().string();
    return (std::any_of(files.begin(), files.end(), twin) && !folder.empty() ? folder + "/" : "") +
           file.path.stem().string();
}

Curve curve_of(const PlottedFile& file, const std::string& kind, bool by_kind) {
    Curve out;
    const bool cycles_alone = is_of_cycles(file.standardised) || (file.data && kind == "cycles");
    if (by_kind && cycles_alone) out.cycles = file.standardised;
    else out.table = file.standardised;
    fs::path beside = file.path;
    beside.replace_filename(file.path.stem().string() + "_cycles.csv");
    if (!file.data && !cycles_alone && fs::exists(beside)) out.cycles = read_table(beside);
    out.points = file.data;
    return out;
}

std::vector<Curve> curves_of(const PlotRequest& request, const Files& files,
                             const std::string& kind) {
    std::vector<Curve> out;
    std::vector<std::string> paths;
    for (const PlottedFile& file : files) {
        Curve curve = curve_of(file, kind, request.x.empty());
        curve.label = label_of(file, files);
        if (file.data && !request.only.empty()) curve.label += " " + request.only;
        const bool first_data = file.data && out.size() == request.runs.size();
        curve.colour = first_data ? -1 : static_cast<int>(out.size());
        out.push_back(std::move(curve));
        paths.push_back(file.path.string());
    }
    tell_apart(out, paths);
    return out;
}

Picture picture_of(const std::string& kind, const std::string& title,
                   const std::vector<Curve>& curves) {
    return kind == "history" ? picture_of_histories(curves, title)
                             : picture_of_curves(kind, title, curves);
}

bool is_drawn(const Curve& curve, const std::string& kind) {
    const Picture alone = picture_of(kind, "", {curve});
    return std::any_of(alone.panels.begin(), alone.panels.end(), says_anything);
}

// Of a kind, and what of the files is not in it is said.
Picture picture_of_files(const PlotRequest& request, const Files& files) {
    for (const PlottedFile& file : files)
        if (file.data) say_unused(file, !request.only.empty());
    const std::string kind = request.kind.empty() ? common_kind(files) : request.kind;
    for (const PlottedFile& file : files)
        if (file.data) say_not_drawn(file, kind);
    const std::vector<Curve> curves = curves_of(request, files, kind);
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (!is_drawn(curves[i], kind)) missing.push_back(files[i].path.string());
    const auto cycled = [](const Curve& curve) { return curve.cycles.rows() > 0; };
    if (shows_cycles(kind) && std::none_of(curves.begin(), curves.end(), cycled))
        throw BadInput(
            fmt::format("a picture of {} needs cycles, as in RUN_cycles.csv, and none of "
                        "the files has any",
                        kind));
    if (missing.size() == files.size())
        throw BadInput(fmt::format("none of the files has columns for a picture of {}", kind));
    if (!missing.empty())
        say("nothing of {} is in this picture of {}\n", fmt::join(missing, ", "), kind);
    return picture_of(kind, request.title, curves);
}

// Of "p.svg" p and .svg: whoever names a picture means its stem.
std::pair<fs::path, std::string> stem_and_ending(fs::path out) {
    const std::string ending = out.extension().string();
    if (ending != ".svg" && ending != ".png" && ending != ".pdf") return {std::move(out), ""};
    return {out.replace_extension(), ending};
}

}  // namespace

ExitCode plot(const PlotRequest& request) {
    const std::vector<std::string>& kinds = plot_kinds();
    if (!request.kind.empty() && std::find(kinds.begin(), kinds.end(), request.kind) == kinds.end())
        throw BadInput(fmt::format("--kind: there is no kind \"{}\"{}", request.kind,
                                   element::suggestion(request.kind, kinds)));
    const Files files = read_all(request);
    for (const PlottedFile& file : files)
        if (file.data && !request.runs.empty()) say_mirrored(file, files.front());
    Picture picture = request.x.empty() ? picture_of_files(request, files)
                                        : picture_of_columns(request.x, request.y, request.title,
                                                             curves_of(request, files, ""));
    const auto [stem, ending] = stem_and_ending(request.out);
    picture.pdf = request.pdf || ending == ".pdf";
    Outputs outputs;
    for (const char* each : {".svg", ".png", ".pdf"})
        if (picture.pdf || each != std::string(".pdf"))
            outputs.add(stem.string() + each, "the picture");
    const auto lock = outputs.lock();
    const std::string problem = draw(stem, picture);
    if (!problem.empty()) {
        warn("grit: no picture: {}\n", problem);
        return failed_computation;
    }
    say("picture: {}.svg and .png{}\n", stem.string(), picture.pdf ? ", .pdf" : "");
    return ok;
}

}  // namespace cli
