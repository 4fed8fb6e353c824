// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm_command.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "cli/abnormal_end.hpp"
#include "cli/mpm_case_file.hpp"
#include "cli/mpm_history.hpp"
#include "cli/mpm_progress.hpp"
#include "cli/outputs.hpp"
#include "cli/table_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;
using namespace grit::mpm;

fs::path history_of(const MpmRequest& request, const Case& plan) {
    return request.out / (plan.name + ".csv");
}

void check_outputs(const MpmRequest& request, const MpmCaseFile& file) {
    Outputs outputs;
    outputs.add(history_of(request, file.plan),
                fmt::format("case {} ({})", file.plan.name, request.file.string()));
    outputs.spare(file.inputs);
}

Runner prepare(const MpmRequest& request, Case plan) {
    try {
        return Runner(std::move(plan));
    } catch (const std::invalid_argument& error) {
        throw BadInput(fmt::format("{}: {}", request.file.string(), error.what()));
    }
}

std::string how_ended(const Runner& runner, int stage) {
    constexpr const char* words[] = {"not at all", "its time", "its depth", "its blows", "rest"};
    return fmt::format("stage {} ended by {}",
                       runner.description().stages.at(static_cast<std::size_t>(stage)).name,
                       words[static_cast<int>(runner.ended())]);
}

class Run {
  public:
    Run(const MpmRequest& wanted, Runner& work)
        : request(wanted), runner(work), progress(wanted.quiet),
          history(history_of(wanted, work.description()), history_comments(work),
                  history_columns()) {}

    // Why it stopped early; empty: it did not.
    std::string go() {
        std::string failure;
        try {
            row();
            while (!runner.finished() && failure.empty()) {
                step();
                if (RunGuard::interrupted()) failure = "interrupted" + here();
            }
        } catch (const std::runtime_error& error) {
            failure = error.what() + here();
        }
        progress.finish();
        if (!failure.empty()) history.comment("STOPPED EARLY: " + failure);
        history.complete();
        return failure;
    }

    double seconds() const { return progress.seconds(); }

  private:
    std::string here() {
        const Simulation& simulation = runner.simulation();
        return fmt::format(" (after step {}, t = {:.6g} s)", simulation.steps(), simulation.time());
    }
    void row() { history.row(history_values(runner.row())); }
    void step() {
        const int stage = runner.state().stage;
        runner.step();
        RunGuard::done(stage + 1, static_cast<int>(runner.simulation().steps()));
        if (runner.row_is_due()) row();
        if (runner.state().stage != stage) {
            const std::string text = how_ended(runner, stage) + here();
            ends.push_back(text);
            progress.finish();
            if (!request.quiet) fmt::print(stderr, "{}: {}\n", runner.description().name, text);
        }
        if (progress(runner)) history.flush();
        if (runner.finished())
            for (const std::string& text : ends) history.comment(text);
    }

    const MpmRequest& request;
    Runner& runner;
    MpmProgress progress;
    TableFile history;
    std::vector<std::string> ends;
};

}  // namespace

ExitCode run_mpm(const MpmRequest& request) {
    MpmCaseFile file = read_mpm_case(request.file);
    if (request.threads) file.plan.settings.threads = *request.threads;
    check_outputs(request, file);
    Runner runner = prepare(request, file.plan);
    make_output_folder(request.out);
    const RunGuard guard(file.plan.name + ": Grit");
    Run run(request, runner);
    const std::string failure = run.go();
    if (!failure.empty()) fmt::print(stderr, "grit: {}: {}\n", file.plan.name, failure);
    if (!request.quiet)
        fmt::print("{}: {} particles, {} steps, {:.4g} s of {:.4g} s -> {}\n", file.plan.name,
                   runner.particles(), runner.simulation().steps(), runner.simulation().time(),
                   run.seconds(), history_of(request, file.plan).string());
    return failure.empty() ? ok : failed_computation;
}

}  // namespace cli
