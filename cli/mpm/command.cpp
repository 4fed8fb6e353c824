// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/command.hpp"

#include <filesystem>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include <adapters/mpm/case/case_words.hpp>
#include <fmt/format.h>

#include "cli/mpm/case_file.hpp"
#include "cli/mpm/fields.hpp"
#include "cli/mpm/history.hpp"
#include "cli/mpm/run.hpp"
#include "cli/mpm/space_fields.hpp"
#include "cli/mpm/to_lammps.hpp"
#include "cli/process/abnormal_end.hpp"
#include "cli/process/cannot_write.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/standard_streams.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

Outputs outputs_of(const MpmRequest& request, const MpmCaseFile& file,
                   const MpmRunOptions& options) {
    Outputs outputs;
    const std::string who = fmt::format("case {} ({})", file.plan.name, request.file.string());
    outputs.add(options.history, who);
    outputs.add(options.checkpoint, who);
    outputs.add(options.failure, who);
    if (!request.no_plot)
        for (const char* ending : {".svg", ".png"})
            outputs.add(options.fields.string() + ending, who);
    if (options.shown) outputs.add(options.fields.string() + ".pvd", who);
    outputs.spare(file.inputs);
    return outputs;
}

// A run that begins anew is none of the checkpoint's, and might never come to its own.
void put_aside(const std::filesystem::path& checkpoint, const Case& plan) {
    std::error_code none;
    if (!std::filesystem::exists(checkpoint, none)) return;
    std::filesystem::path old = checkpoint;
    old += ".old";
    std::error_code refused;
    std::filesystem::rename(checkpoint, old, refused);
    if (refused) cannot_write(old, refused.value());
    warn("grit: {}: an interrupted run of this case left a checkpoint, now {}; without --restart "
         "this "
         "run begins anew\n",
         plan.name, old.string());
}

// Frames, pictures and failures, by what their names have beside the case's.
bool is_shown_by_a_run(const std::string& rest) {
    static const std::regex frame("_[0-9]{6}_.*\\.vtu"), picture("_(.*)\\.(png|svg)");
    std::smatch match;
    if (std::regex_match(rest, match, picture)) {
        for (const bool axisymmetric : {true, false})
            for (const MpmField& field : mpm_fields(axisymmetric))
                if (match[1] == field.name) return true;
        return false;
    }
    return rest == ".svg" || rest == ".png" || rest == ".pvd" || rest == "_failure.toml" ||
           std::regex_match(rest, frame);
}

// A picture of another case, whose name ends as a field's, is not of this one's.
bool is_of_a_run(const MpmRunOptions& options, const std::filesystem::path& file) {
    const std::string stem = options.history.stem().string(), name = file.string();
    if (!name.starts_with(stem) || !is_shown_by_a_run(name.substr(stem.size()))) return false;
    std::error_code none;
    return file.stem() == stem ||
           !std::filesystem::exists(options.history.parent_path() / (file.stem() += ".csv"), none);
}

// What an older run of this name has left would stand beside this one's results as if it were theirs; what a killed one
// has begun, nobody completes.
void remove_results(const MpmRunOptions& options, bool begun_alone) {
    const std::filesystem::path folder = options.history.parent_path();
    std::error_code none;
    std::vector<std::filesystem::path> old;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder.empty() ? "." : folder, none)) {
        const std::filesystem::path name = entry.path().filename();
        if (is_of_a_run(options, element::name_when_complete(name)) ||
            (!begun_alone && is_of_a_run(options, name)))
            old.push_back(entry.path());
    }
    for (const std::filesystem::path& file : old) std::filesystem::remove(file, none);
}

Runner prepare(const MpmRequest& request, const MpmCaseFile& file) {
    try {
        Runner runner(file.plan);
        if (file.fields) runner.check_interval("fields.interval_s", file.fields->interval);
        return runner;
    } catch (const std::invalid_argument& error) {
        throw BadInput(fmt::format("{}: {}", request.file.string(), error.what()));
    }
}

template <class Simulation> void tell_sweeps(const Simulation& simulation, const Case& plan) {
    for (std::size_t i = 0; i < simulation.surface_contact_count(); ++i) {
        const auto& pair = simulation.surface_contact(i);
        const Sweeps& of = pair.sweeps();
        if (of.calls > 0)
            say("{}: surface contact of {} and {}: {:.1f} sweeps a step; {} steps ended at {}\n",
                plan.name, plan.bodies[pair.law().a].name, plan.bodies[pair.law().b].name,
                static_cast<double>(of.all) / static_cast<double>(of.calls), of.unfinished,
                pair.law().options.sweep_limit);
    }
}

// What the steps since the program began cost, and the elements that contact takes.
void tell_cost(Runner& runner) {
    const Seconds spent = runner.subject().seconds();
    const double total = spent.total();
    if (!(total > 0.0)) return;
    const double done = static_cast<double>(spent.steps) * static_cast<double>(runner.particles());
    const auto share = [total](double part) { return 100.0 * part / total; };
    say("{}: {:.3g} particle-steps/s; scatter {:.0f} %, nodes {:.0f} %, contact {:.0f} %, "
        "material {:.0f} %, rest of gather {:.0f} %\n",
        runner.description().name, done / total, share(spent.scatter), share(spent.nodes),
        share(spent.contact), share(spent.material), share(spent.gather - spent.material));
    if (runner.space()) return tell_sweeps(*runner.space(), runner.description());
    const Simulation& simulation = runner.simulation();
    tell_sweeps(simulation, runner.description());
    for (std::size_t i = 0; i < simulation.penalty_contact_count(); ++i) {
        const PenaltyPair& pair = simulation.penalty_contact(i);
        say("{}: {} and {} vertices of penalty lines\n", runner.description().name,
            pair.vertices(0).size() / 2, pair.vertices(1).size() / 2);
    }
    const Water& water = simulation.pore_water();
    for (std::size_t i = 0; i < simulation.bodies(); ++i)
        if (water.is_implicit(i))
            say("{}: {}: pore pressure by {:.1f} iterations a step; what bears did not settle {} "
                "times\n",
                runner.description().name, runner.description().bodies[i].name,
                static_cast<double>(water.iterations(i)) / static_cast<double>(spent.steps),
                water.unsettled(i));
}

ExitCode convert(const MpmRequest& request, const Case& plan) {
    const auto refuse = [&request](const char* why) {
        throw BadInput(fmt::format("{}: {}", request.file.string(), why));
    };
    try {
        write_lammps_files(plan, request.to_lammps);
    } catch (const std::invalid_argument& error) {
        refuse(error.what());
    } catch (const BadInput& refused) {
        refuse(refused.what());
    }
    if (!request.quiet)
        say("{}: grit-lmp -in {}.in in {}\n", plan.name, plan.name, request.to_lammps.string());
    return ok;
}

}  // namespace

const std::map<std::string, std::string (*)()>& printed_tables() {
    static const std::map<std::string, std::string (*)()> all{{"cases", &keys_of_cases},
                                                              {"fix", &keys_of_fix},
                                                              {"fields", &mpm_field_table},
                                                              {"space_fields", &space_field_table},
                                                              {"history", &history_table}};
    return all;
}

ExitCode run_mpm(const MpmRequest& request) {
    if (!request.keys.empty()) {
        say("{}", printed_tables().at(request.keys)());
        return ok;
    }
    MpmCaseFile file = read_mpm_case(request.file, request.sand, request.settings);
    const Case& plan = file.plan;
    if (!request.to_lammps.empty()) return convert(request, plan);
    if (request.threads) file.plan.settings.threads = *request.threads;
    if (const std::string word = word_of_unused_threads(plan.settings.threads);
        !word.empty() && !request.quiet)
        warn("grit: {}: {}\n", plan.name, word);
    std::vector<std::string> others;
    if (!request.sand.empty()) others.push_back(fmt::format("--sand {}", request.sand.string()));
    const MpmRunOptions options{request.out / (plan.name + ".csv"),
                                request.out / (plan.name + ".checkpoint"),
                                request.out / plan.name,
                                request.out / (plan.name + "_failure.toml"),
                                file.fields,
                                request.checkpoint_minutes,
                                request.restart,
                                request.quiet,
                                request.field_svg,
                                words_of(request.settings, others),
                                file.given};
    const Outputs outputs = outputs_of(request, file, options);
    Runner runner = prepare(request, file);
    const auto lock = outputs.lock();
    if (!request.restart) put_aside(options.checkpoint, plan);
    remove_results(options, request.restart);
    const RunGuard guard(plan.name + ": Grit");
    MpmRun run(options, runner);
    const std::string failure = run.go();
    if (!failure.empty()) warn("grit: {}: {}\n", plan.name, failure);
    const bool drawn = request.no_plot || run.draw();
    const ExitCode ended = failure.empty() && drawn ? ok : failed_computation;
    if (request.quiet) return ended;
    say("{}: {} particles, {} steps, t = {:.4g} s, {:.1f} s of computing -> {}\n", plan.name,
        runner.particles(), runner.subject().steps(), runner.subject().time(), run.seconds(),
        options.history.string());
    tell_cost(runner);
    return ended;
}

}  // namespace cli
