// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/plot_options.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/contents.hpp"
#include "cli/plot/plot_command.hpp"

namespace cli {

void add_plot_command(CLI::App& app, Command& asked) {
    CLI::App* picture = app.add_subcommand("plot", "Draw results and laboratory data together");
    const auto request = std::make_shared<PlotRequest>();
    picture->add_option("RUN", request->runs, "CSV files of results, drawn as lines");
    CLI::Option* data =
        picture->add_option("--data", request->data, "CSV files of laboratories, drawn as points");
    picture
        ->add_option(
            "--column", request->columns,
            "What a column of the data is, as in q_kPa=Deviator; names see docs/element-tests.md")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false)
        ->needs(data);
    picture->add_option("--only", request->only, "Rows of the data with this first cell")
        ->needs(data);
    // Its list for help, completion and manual; plot() words what is none of it.
    picture
        ->add_option("--kind", request->kind,
                     "Kind of picture, see docs/element-tests.md [as the files say]")
        ->type_name(fmt::format("{{{}}}", fmt::join(plot_kinds(), ",")));
    CLI::Option* x = picture->add_option("--x", request->x, "Column, instead of a kind: with --y");
    CLI::Option* y =
        picture->add_option("--y", request->y, "Columns over it, a panel for each: tip_force,depth")
            ->delimiter(',')
            ->take_all()
            ->expected(1)
            ->allow_extra_args(false)
            ->needs(x);
    x->needs(y);
    picture->add_option("--title", request->title, "Above the picture");
    picture->add_option("--out", request->out,
                        "Stem of the files .svg and .png [plot]; .pdf at its end: --pdf");
    picture->add_flag("--pdf", request->pdf, "Also .pdf, for papers");
    picture->callback([&asked, request] {
        if (request->runs.empty() && request->data.empty())
            throw CLI::RequiredError("RUN or --data");
        asked = [request] { return plot(*request); };
    });
}

}  // namespace cli
