// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/stage_reader.hpp"

#include <fmt/format.h>

#include "cli/element/stage_programs.hpp"
#include "element/check.hpp"
#include "element/errors.hpp"
#include "element/schedule.hpp"

namespace cli {
namespace {

using element::Program;
using element::Step;

// To every step, those within repetitions included.
void set_commons(Program& program, const std::string& name, int every) {
    for (Step& step : program) {
        step.name = name;
        step.every = every;
        if (auto* repetition = std::get_if<element::Repetition>(&step.kind))
            set_commons(repetition->steps, name, every);
    }
}

void check_steps(const TomlTable& table, const Program& program) {
    for (const Step& step : program) try {
            if (const auto* repetition = std::get_if<element::Repetition>(&step.kind))
                check_steps(table, repetition->steps);
            else element::check_step(step);
        } catch (const element::BadCase& error) {
            table.fail("", fmt::format("{}: {}", table.full(""), error.what()));
        }
}

// An undrained stage leaves a pore pressure behind. Under stress control it would stay in the sample for
// good; where strain or stress is held, the valve stays as it was.
void watch_the_water(const TomlTable& table, CaseStage& stage, StageContext& context) {
    if (stage.test == "creep") stage.program.front().undrained = context.pore_pressure;
    for (const Step& step : stage.program) {
        const auto after = element::pore_pressure_after(step, context.pore_pressure);
        if (!after)
            table.fail("test",
                       fmt::format("{}: \"{}\" begins with the pore pressure of an undrained "
                                   "stage: let it out by a stage with test = \"drain\" before",
                                   table.full("test"), stage.test));
        context.pore_pressure = *after;
    }
}

CaseStage read_single(TomlTable& table, StageContext& context) {
    CaseStage out;
    out.test = table.choice("test", test_names());
    StageProgram read = read_test(table, out.test);
    out.program = std::move(read.steps);
    out.shear = read.shear;
    out.cyclic = read.cyclic;
    set_commons(out.program, out.test,
                table.integer_or("record_every", 1, 1, element::increment_limit));
    check_steps(table, out.program);
    watch_the_water(table, out, context);
    return out;
}

CaseStage read_group(TomlTable& table, StageContext& context) {
    CaseStage out;
    const int rounds = table.has("repeat") ? 2 : 1;  // the second one begins as the first one ends
    for (int round = 0; round < rounds; ++round) {
        out = {};
        for (TomlTable& inner : table.tables_if("stage")) {
            const CaseStage stage = read_stage(std::move(inner), context);
            if (stage.zero_strain)
                table.fail("stage",
                           table.full("stage") + ": zero_strain belongs to the outer stage");
            out.test = stage.test;
            out.shear = stage.shear;
            out.program.insert(out.program.end(), stage.program.begin(), stage.program.end());
            out.until.insert(out.until.end(), stage.until.begin(), stage.until.end());
        }
    }
    out.cyclic = true;
    return out;
}

// Ends the stage, all repetitions of it, whichever step is going on.
void read_until(TomlTable& table, CaseStage& stage, const Columns& columns) {
    element::Exit exit;
    const element::Vocabulary words = columns.words(stage.shear);
    for (const std::string& text : table.strings_or_none("until")) try {
            exit.any_of.push_back(element::parse_condition(text, words));
            stage.until.push_back(text);
        } catch (const element::BadCase& error) {
            table.fail("until", fmt::format("{}: {}", table.full("until"), error.what()));
        }
    exit.exactly = table.boolean_or("until_exactly", false);
    if (exit.any_of.empty()) return;
    if (stage.program.size() > 1) {
        Step all;
        all.kind = element::Repetition{std::move(stage.program), 1};
        stage.program = {all};
    }
    stage.program.front().exit = std::move(exit);
}

}  // namespace

CaseStage read_stage(TomlTable table, StageContext& context) {
    CaseStage out = table.has("stage") ? read_group(table, context) : read_single(table, context);
    const int times = table.integer_or("repeat", 1, 1, element::increment_limit);
    out.program = repeated(std::move(out.program), times);
    out.zero_strain = table.boolean_or("zero_strain", false);
    read_until(table, out, context.columns);
    table.finish();
    return out;
}

}  // namespace cli
