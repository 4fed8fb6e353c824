// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/incremental_driver_command.hpp"

#include <fmt/format.h>

#include "cli/plot/panels.hpp"
#include "cli/plot/picture_maker.hpp"
#include "cli/process/abnormal_end.hpp"
#include "cli/process/progress.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/table/columns.hpp"
#include "element/incremental_driver/run.hpp"

namespace cli {
namespace {

// What a picture may need of a row.
class PlottedRows {
  public:
    PlottedRows() : columns(nullptr, {}) {
        for (std::size_t i = 0; i < columns.names().size(); ++i) {
            const std::string& name = columns.names()[i].name;
            if (name.find("strain") == std::string::npos &&
                name.find("stress") == std::string::npos && name != "p" &&
                name != "axial_deviator" && name != "void_ratio" && name != "pore_pressure" &&
                name != "mobilised_friction" && name != "gamma_12")
                continue;
            kept.push_back(i);
            table.columns.push_back(columns.names()[i]);
        }
    }

    void add(const element::Record& record) {
        const std::vector<double> row = columns.row(record, {});
        for (std::size_t i = 0; i < kept.size(); ++i)
            table.columns[i].values.push_back(row[kept[i]]);
    }

    Table table;

  private:
    Columns columns;
    std::vector<std::size_t> kept;
};

// False if the picture could not be written.
bool draw(const IncrementalDriverRequest& request, const incremental_driver::Report& report,
          const Table& rows) {
    std::filesystem::path stem = report.output;
    if (stem.extension() == ".svg" || stem.extension() == ".png") return true;  // that is the data
    stem.replace_extension();
    const Curve curve{"computed", rows, {}, false, 0};
    PictureMaker maker(stem.parent_path(), request.quiet);
    maker.draw(stem.filename().string(),
               picture_of_curves(picture_of_path(rows), stem.filename().string(), {curve}));
    return !maker.failed();
}

}  // namespace

ExitCode run_incremental_driver(const IncrementalDriverRequest& request) {
    Progress progress(request.folder.string());
    PlottedRows rows;
    element::Listeners listeners;
    listeners.increment = [&](const element::Progress& now) {
        progress(now.increment, now.increments);
        RunGuard::done(now.record->step, now.record->increment);
        return !RunGuard::interrupted();
    };
    if (!request.no_plot)
        listeners.record = [&](const element::Record& record) { rows.add(record); };
    incremental_driver::Report report;
    try {
        const RunGuard guard(request.folder.string() + ": " +
                             (request.umat.empty() ? "Grit" : "the UMAT " + request.umat.string()));
        report = incremental_driver::run({request.folder, request.out, request.umat}, listeners);
    } catch (const incremental_driver::BadInput& error) {
        throw BadInput(error.what());
    }
    progress.finish();
    if (!request.quiet)
        say("data:    {}\n{} increments, {} rows, {:.3f} s\n", report.output.string(),
            report.increments, report.rows, progress.seconds());
    if (!request.quiet)
        for (const std::string& exit : report.exits) say("exit:    {}\n", exit);
    flush_words();
    if (!report.failure.empty()) warn("grit: stopped early at {}\n", report.failure);
    const bool drawn = request.no_plot || draw(request, report, rows.table);
    return report.failure.empty() && drawn ? ok : failed_computation;
}

}  // namespace cli
