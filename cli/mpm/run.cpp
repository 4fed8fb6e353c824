// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/run.hpp"

#include <stdexcept>

#include <adapters/mpm/run/history.hpp>
#include <fmt/format.h>

#include "cli/mpm/checkpoint.hpp"
#include "cli/mpm/geometry_words.hpp"
#include "cli/mpm/history.hpp"
#include "cli/mpm/pictures.hpp"
#include "cli/mpm/replay_case.hpp"
#include "cli/mpm/space_fields.hpp"
#include "cli/plot/history_panels.hpp"
#include "cli/plot/picture_maker.hpp"
#include "cli/process/abnormal_end.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/process/standard_streams.hpp"
#include "element/atomic_file.hpp"

namespace cli {

using namespace grit::mpm;

namespace {

std::unique_ptr<ShownFields> shown_by(Runner& runner) {
    if (runner.space()) return std::make_unique<SpaceFields>(*runner.space());
    return std::make_unique<MpmFields>(runner.simulation());
}

}  // namespace

MpmRun::MpmRun(const MpmRunOptions& wanted, Runner& work)
    : options(wanted), runner(work), progress(wanted.quiet), fields(shown_by(work)),
      saved(Clock::now()) {
    if (options.shown) field_files.emplace(options.fields, options.shown->variables, *fields);
    if (options.restart) resume();
    const std::vector<Column> columns_now = history_columns(runner.description());
    history.emplace(options.history, history_comments(runner, options.changes), columns_now);
    const std::size_t columns = columns_now.size();
    for (auto row = done.history.begin(); row != done.history.end();) {
        const auto end = row + static_cast<std::ptrdiff_t>(columns);
        history->row({row, end});
        row = end;
    }
}

void MpmRun::resume() {
    try {
        const MpmCheckpoint checkpoint(options.checkpoint);
        done = saved_run_of(checkpoint.runner(), runner.description().stages.size(),
                            history_columns(runner.description()).size());
        runner.resume(done.state);
        checkpoint.restore(runner.subject());
        compare_cases(done.given, options.given);
        runner.take_steps();
        if (field_files) field_files->resume(done.frames);
    } catch (const std::runtime_error& error) {
        throw BadInput(error.what());
    }
}

std::string MpmRun::go() {
    const std::string failure = compute();
    progress.finish();
    complete_history(failure);
    // What it was kept for is done.
    std::error_code nobody_needs_it;
    if (failure.empty()) std::filesystem::remove(options.checkpoint, nobody_needs_it);
    return failure;
}

std::filesystem::path MpmRun::incomplete() const {
    std::filesystem::path out = options.history;
    return out += ".incomplete";
}

// Where the disk does not take all of it, what is there is worth a name of its own.
void MpmRun::complete_history(const std::string& failure) {
    try {
        for (const std::string& text : done.ends) history->comment(text);
        if (!failure.empty()) history->comment("STOPPED EARLY: " + failure);
        history->complete_on_disk();  // the checkpoint goes next
        std::error_code there_is_none;
        std::filesystem::remove(incomplete(), there_is_none);
    } catch (const element::CannotWrite& error) {
        const std::filesystem::path part = incomplete();
        const std::string rows =
            history->keep_rows(part) ? "; its rows so far are in " + part.string() : std::string();
        throw element::CannotWrite((failure.empty() ? "" : failure + "; ") + error.what() + rows);
    }
}

// Whatever goes wrong here, the history so far is worth keeping.
std::string MpmRun::compute() {
    try {
        // At the start, or what a disk did not take of a step before.
        if (runner.row_is_due()) {
            done.frame_is_open = field_files.has_value();
            row();
        }
        if (done.frame_is_open) frame();
        while (!runner.finished()) {
            if (RunGuard::interrupted()) {
                const std::string problem = save();
                return "interrupted" + here() + (problem.empty() ? "" : "; " + problem);
            }
            step();
        }
    } catch (const MaterialFailure& error) {
        return error.what() + replay(error);
    } catch (const element::CannotWrite& error) {
        // The run itself is whole.
        const std::string problem = save();
        return error.what() + here() + (problem.empty() ? "" : "; " + problem);
    } catch (const std::exception& error) {
        return error.what() + here();
    }
    return {};
}

std::string MpmRun::replay(const MaterialFailure& error) {
    try {
        if (runner.space()) write_replay_case(options.failure, error, *runner.space());
        else write_replay_case(options.failure, error, runner.simulation());
    } catch (const std::exception& problem) {
        return fmt::format("; its replay case could not be written: {}", problem.what());
    }
    return fmt::format("; to be replayed by grit element {}", options.failure.string());
}

bool MpmRun::draw() {
    const Case& plan = runner.description();
    Table table{cli::history_columns(plan)};
    const std::size_t width = table.columns.size();
    for (std::size_t i = 0; i < done.history.size(); ++i)
        table.columns[i % width].values.push_back(done.history[i]);
    PictureMaker maker(options.fields.parent_path(), options.quiet);
    maker.draw(options.fields.filename().string(), picture_of_histories({{"", table}}, plan.title));
    const auto* drawn = dynamic_cast<const MpmFields*>(fields.get());
    if (!options.shown || !drawn) return !maker.failed();  // fields in space are for ParaView alone
    for (const MpmField& field : options.shown->variables) {
        FieldPicture picture{field,
                             fmt::format("{}, t = {:.4g} s", plan.title, runner.subject().time()),
                             {0.0, 0.0, 0.0, 0.0},
                             plan.settings.axisymmetric,
                             words_of(plan).across};
        picture.files.svg = options.field_svg;
        const std::filesystem::path stem = options.fields.string() + "_" + field.name;
        std::string problem;
        bool broken = maker.failed();
        try {
            problem = draw_field(stem, picture, *drawn);
        } catch (const element::CannotWrite& error) {
            problem = error.what();
            broken = true;
        }
        if (problem.empty()) continue;
        warn("grit: no picture: {}\n", problem);
        return !broken;
    }
    if (!options.quiet && !options.shown->variables.empty())
        say("pictures of fields: {}_*.png{}\n", options.fields.string(),
            options.field_svg ? " and .svg" : "");
    return !maker.failed();
}

std::string MpmRun::here() {
    const Subject& simulation = runner.subject();
    return fmt::format(" (after step {}, t = {:.6g} s)", simulation.steps(), simulation.time());
}

// It is part of the state before the disk has it: asked again, the runner would have no means of a step.
void MpmRun::row() {
    const std::vector<double> values = history_values(runner.description(), runner.row());
    done.history.insert(done.history.end(), values.begin(), values.end());
    history->row(values);
}

void MpmRun::frame() {
    field_files->write();
    done.frames = field_files->times();
    if (options.shown->interval > 0.0)
        done.next_frame = next_multiple(options.shown->interval, runner.subject().time());
    done.frame_is_open = false;
}

void MpmRun::step() {
    const int stage = runner.state().stage;
    runner.step();
    RunGuard::done(stage + 1, static_cast<int>(runner.subject().steps()));
    const bool ended = runner.state().stage != stage;
    const bool frame_due = options.shown && options.shown->interval > 0.0 &&
                           runner.subject().time() >= done.next_frame;
    done.frame_is_open = field_files && (ended || frame_due);
    if (ended) stage_ended(stage);
    if (runner.row_is_due()) row();
    if (done.frame_is_open) frame();
    if (progress(runner)) history->flush();
    const std::chrono::duration<double, std::ratio<60>> since = Clock::now() - saved;
    if (options.checkpoint_minutes > 0.0 && since.count() >= options.checkpoint_minutes)
        if (const std::string problem = save(); !problem.empty()) {
            progress.finish();
            warn("grit: {}: {}\n", runner.description().name, problem);
        }
}

void MpmRun::stage_ended(int stage) {
    constexpr const char* words[] = {"nothing", "its time", "its depth", "its blows", "rest"};
    const Case& plan = runner.description();
    done.ends.push_back(fmt::format("stage {} ended by {}{}",
                                    plan.stages.at(static_cast<std::size_t>(stage)).name,
                                    words[static_cast<int>(runner.ended())], here()));
    progress.finish();
    if (!options.quiet) warn("{}: {}\n", plan.name, done.ends.back());
}

std::string MpmRun::save() {
    saved = Clock::now();  // after a failure too: the next one is due as late
    try {
        done.state = runner.state();
        done.given = options.given;
        write_mpm_checkpoint(options.checkpoint, runner.subject(), bytes_of(done));
    } catch (const std::exception& error) {
        return fmt::format("the checkpoint could not be written: {}", error.what());
    }
    return {};
}

}  // namespace cli
