// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/plot_command.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/panels.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/table/foreign_columns.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

Curve curve_of(const fs::path& path, const std::string& only, bool points, int colour) {
    Curve out;
    out.label = path.stem().string() + (only.empty() ? "" : " " + only);
    out.table = standardised(read_table(path, only));
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
    std::vector<Curve> curves;
    for (const fs::path& run : request.runs)
        curves.push_back(curve_of(run, "", false, static_cast<int>(curves.size())));
    for (std::size_t i = 0; i < request.data.size(); ++i)
        curves.push_back(curve_of(request.data[i], request.only, true,
                                  i == 0 ? -1 : static_cast<int>(curves.size())));
    Picture picture = picture_of_curves(request.kind, request.title, curves);
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
