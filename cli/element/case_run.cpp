// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/case_run.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "cli/element/run_writer.hpp"
#include "cli/process/abnormal_end.hpp"
#include "cli/process/progress.hpp"
#include "element/simulate.hpp"

namespace cli {
namespace {

bool ended_by(const std::vector<std::string>& exits, const std::string& condition) {
    return std::any_of(exits.begin(), exits.end(),
                       [&](const std::string& exit) { return exit.ends_with(": " + condition); });
}

// Stage after stage on one sample.
class Run {
  public:
    // writer and progress: null where nobody wants to know.
    Run(const CaseFile& case_file, bool residuals, RunWriter* w, Progress* p)
        : file(case_file), writer(w), progress(p) {
        sample.point = file.point;
        settings = file.settings;
        settings.keep_residuals = residuals;
        for (const CaseStage& stage : file.stages) all += element::count_increments(stage.program);
    }

    void go(CaseResult& result) {
        int number = 0;
        for (const CaseStage& stage : file.stages) {
            run_stage(++number, stage, result);
            if (!result.failure.empty()) return;
        }
    }

  private:
    void run_stage(int number, const CaseStage& stage, CaseResult& result) {
        if (stage.zero_strain) sample.strain.setZero();
        settings.record_start = number == 1 || stage.zero_strain;
        if (writer) writer->begin_stage(number, stage);
        const element::History history =
            element::simulate(*file.law, sample, stage.program, settings, listeners(result));
        if (writer) writer->end_stage();
        const std::string here = fmt::format("stage {}, ", number);
        for (const std::string& exit : history.exits) result.exits.push_back(here + exit);
        if (history.failure)
            result.failure =
                here + (RunGuard::interrupted() ? "interrupted: " : "") + history.failure->message;
        else
            for (const std::string& condition : stage.until)
                if (!ended_by(history.exits, condition)) result.never.push_back(here + condition);
        before += element::count_increments(stage.program);
    }

    element::Listeners listeners(CaseResult& result) {
        element::Listeners out;
        out.record = [this](const element::Record& record) {
            if (writer) writer->record(record);
        };
        out.increment = [this, &result](const element::Progress& now) {
            ++result.increments;
            if (writer) writer->increment(*now.record);
            if (progress) (*progress)(before + now.increment, all);
            RunGuard::done(now.record->step, now.record->increment);
            return !RunGuard::interrupted();
        };
        return out;
    }

    const CaseFile& file;
    RunWriter* writer;
    Progress* progress;
    element::Sample sample;
    element::Settings settings;
    long before = 0, all = 0;  // increments
};

double cpu_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Processor time: what else the machine does is not the case's.
double fastest_of_five(const CaseFile& file) {
    double best = INFINITY;
    for (int i = 0; i < 5; ++i) {
        const double start = cpu_milliseconds();
        CaseResult nobody_looks_at;
        Run(file, false, nullptr, nullptr).go(nobody_looks_at);
        best = std::min(best, cpu_milliseconds() - start);
    }
    return best;
}

}  // namespace

CaseResult run_case(const CaseFile& file, const CaseOutput& output) {
    CaseResult out;
    const RunGuard guard(file.name + ": " +
                         (file.umat ? "the UMAT " + file.umat->library.string() : "Grit"));
    RunWriter writer(file, output, out);
    Progress progress(file.name);
    Run(file, output.residuals, &writer, &progress).go(out);
    progress.finish();
    out.seconds = progress.seconds();
    writer.complete();
    if (file.limits.milliseconds && out.failure.empty()) out.milliseconds = fastest_of_five(file);
    return out;
}

}  // namespace cli
