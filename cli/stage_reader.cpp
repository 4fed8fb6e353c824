// SPDX-License-Identifier: BSD-3-Clause
#include "cli/stage_reader.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cli/laboratory_words.hpp"
#include "element/errors.hpp"

namespace cli {
namespace {

using element::Linear;
using element::Program;
using element::Step;

// Strain is straight within an increment and memory lives on the scale of R, about 1e-4: increments
// that follow a turn start with a fiftieth of it and grow.
constexpr double first_strain = 2e-6;
constexpr double first_stress_share = 1e-3;
constexpr int increments_by_default = 400, increments_per_cycle = 200;

struct Pace {
    std::optional<double> first_share;
    bool strain = true;  // the path is one of strain, otherwise of stress

    // path: length of the driven strain or stress
    double share(double path, int increments) const {
        if (first_share) return *first_share;
        const double fair = strain ? first_strain / std::abs(path) : first_stress_share;
        return fair * increments < 1.0 ? fair : 0.0;
    }
};

Program repeated(Program program, int times) {
    if (times == 1) return program;
    Step step;
    step.kind = element::Repetition{std::move(program), times};
    return {step};
}

// A quarter out, then back and forth about the beginning; increments are those of a cycle.
Program triangles(const Step& amplitude, double path, int cycles, int increments,
                  const Pace& pace) {
    const auto leg = [&](double factor, int count) {
        Step step = amplitude;
        std::get<Linear>(step.kind).change *= factor;
        step.increments = count;
        step.first_share = pace.share(factor * path, count);
        return step;
    };
    const int quarter = std::max(1, increments / 4), half = std::max(1, increments / 2);
    Program out = {leg(1.0, quarter)};
    const Program cycle = repeated({leg(-2.0, half), leg(2.0, half)}, cycles);
    out.insert(out.end(), cycle.begin(), cycle.end());
    return out;
}

Program sines(Step step, int cycles, int increments) {
    element::Circulating kind;
    kind.rows = std::get<Linear>(step.kind).rows;
    kind.amplitude = std::get<Linear>(step.kind).change;
    kind.cycles = cycles;
    step.kind = kind;
    step.increments = increments * cycles;
    return {step};
}

Pace read_pace(TomlTable& table, bool strain) {
    Pace pace;
    pace.strain = strain;
    pace.first_share = table.number_if("first_share");
    if (pace.first_share && !(*pace.first_share > 0.0 && *pace.first_share < 1.0))
        table.fail("first_share", fmt::format("{} must be in (0, 1), got {:g}",
                                              table.full("first_share"), *pace.first_share));
    return pace;
}

int read_increments(TomlTable& table, const char* key, int otherwise) {
    return table.integer_or(key, otherwise, 1, 10000000);
}

Program monotone(TomlTable& table, Step step, double path, bool strain) {
    step.increments = read_increments(table, "increments", increments_by_default);
    step.first_share = read_pace(table, strain).share(path, step.increments);
    return {step};
}

double nonzero(TomlTable& table, const std::string& key) {
    const double value = table.number(key);
    if (value == 0.0) table.fail(key, table.full(key) + " must not be 0");
    return value;
}

Program driven(TomlTable& table, const LaboratoryTest& test, bool& cyclic) {
    std::vector<std::string> keys;
    for (const Way& way : test.ways) {
        keys.push_back(way.key);
        keys.push_back(way.amplitude_key());
    }
    const std::string key = table.one_of(keys);
    for (const Way& way : test.ways) {
        if (key == way.key) {
            const double value = way.strain() ? nonzero(table, key) : table.number(key);
            Step step = way.step(way.sign * value);
            for (const int row : way.reached) std::get<Linear>(step.kind).absolute[row] = true;
            return monotone(table, step, value, way.strain());
        }
        if (key != way.amplitude_key()) continue;
        cyclic = true;
        const double amplitude = nonzero(table, key);
        const int cycles = table.integer_or("cycles", 1, 1, 10000000);
        const int increments = read_increments(table, "increments_per_cycle", increments_per_cycle);
        const Step step = way.step(way.sign * amplitude);
        if (table.has("wave") && table.choice("wave", {"triangle", "sine"}) == "sine")
            return sines(step, cycles, increments);
        return triangles(step, amplitude, cycles, increments, read_pace(table, way.strain()));
    }
    return {};
}

// Six components, each by strain or by stress.
Program components(TomlTable& table) {
    static const std::vector<std::string> names = {"11", "22", "33", "12", "13", "23"};
    std::optional<TomlTable> strain = table.table_if("strain");
    std::optional<TomlTable> stress = table.table_if("stress_change_kPa");
    element::Controls controls{};
    element::Vector6 change = element::Vector6::Zero();
    for (int i = 0; i < 6; ++i) {
        const std::string& name = names[static_cast<std::size_t>(i)];
        const std::optional<double> e = strain ? strain->number_if(name) : std::nullopt;
        const std::optional<double> s = stress ? stress->number_if(name) : std::nullopt;
        if (e.has_value() == s.has_value())
            table.fail("", fmt::format("component {} of {} must be given by strain or by "
                                       "stress_change_kPa, {}",
                                       name, table.full(""), e ? "not both" : "but is missing"));
        controls[static_cast<std::size_t>(i)] =
            e ? element::Control::strain : element::Control::stress;
        change[i] = e ? *e : *s;
    }
    if (strain) strain->finish();
    if (stress) stress->finish();
    Step step = element::component_control(controls, change);
    step.undrained = table.boolean_or("undrained", false);
    const double strained = strain ? std::max(change.cwiseAbs().maxCoeff(), 1e-12) : 1.0;
    return monotone(table, step, strained, strain.has_value());
}

Program true_triaxial(TomlTable& table) {
    const std::string key = table.one_of({"stress_kPa", "strain"});
    const std::vector<double> value = table.numbers(key, 3);
    const element::Vector6 change{{value[0], value[1], value[2], 0.0, 0.0, 0.0}};
    if (key == "strain") {
        if (change.isZero()) table.fail(key, table.full(key) + " must not be 0");
        return monotone(table, element::component_control({}, change), change.cwiseAbs().maxCoeff(),
                        true);
    }
    Step step = element::true_triaxial(change);
    for (std::size_t i = 0; i < 3; ++i) std::get<Linear>(step.kind).absolute[i] = true;
    return monotone(table, step, 1.0, false);
}

Program at_rest(TomlTable& table, const std::string& test) {
    const double duration = table.number_if("duration_s").value_or(0.0);
    Step step = test == "creep" ? element::creep(duration) : element::relaxation(duration);
    step.increments = read_increments(table, "increments", 1);
    return {step};
}

std::vector<std::string> test_names() {
    std::vector<std::string> names;
    for (const LaboratoryTest& test : laboratory_tests()) names.push_back(test.name);
    for (const char* name : {"true_triaxial", "components", "rest", "creep"})
        names.emplace_back(name);
    return names;
}

std::vector<element::Condition> read_until(TomlTable& table,
                                           const std::vector<std::string>& state_names) {
    std::vector<element::Condition> out;
    element::Record record;
    record.state.resize(state_names.size());
    for (const std::string& text : table.strings_or_none("until")) try {
            out.push_back(element::parse_condition(text));
            element::excess(out.back(), record, state_names);
        } catch (const element::BadCase& error) {
            table.fail("until", fmt::format("{}: {}", table.full("until"), error.what()));
        }
    return out;
}

// An exit condition ends one step. Cycles are many: there it is watched from outside.
void read_exit(TomlTable& table, CaseStage& stage, const std::vector<std::string>& state_names) {
    std::vector<element::Condition> until = read_until(table, state_names);
    const bool exactly = table.boolean_or("until_exactly", false);
    if (stage.cyclic) {
        if (exactly) table.fail("until_exactly", table.full("until_exactly") + ": not for cycles");
        stage.until = std::move(until);
        return;
    }
    for (Step& step : stage.program) step.exit = {until, exactly};
}

// To every step, those within repetitions included.
struct Commons {
    std::string name;
    int every = 1;
    std::optional<double> duration;

    void apply(Program& program) const {
        for (Step& step : program) {
            step.name = name;
            step.every = every;
            if (duration) step.duration = *duration;
            if (auto* repetition = std::get_if<element::Repetition>(&step.kind))
                apply(repetition->steps);
        }
    }
};

CaseStage read_group(TomlTable& table, const std::vector<std::string>& state_names) {
    CaseStage out;
    for (TomlTable& inner : table.tables_if("stage")) {
        const CaseStage stage = read_stage(std::move(inner), state_names);
        if (stage.zero_strain)
            table.fail("stage", table.full("stage") + ": zero_strain belongs to the outer stage");
        out.test = stage.test;
        out.shear = stage.shear;
        out.cyclic = true;
        out.program.insert(out.program.end(), stage.program.begin(), stage.program.end());
    }
    return out;
}

}  // namespace

CaseStage read_stage(TomlTable table, const std::vector<std::string>& state_names) {
    CaseStage out;
    if (table.has("stage")) {
        out = read_group(table, state_names);
    } else {
        out.test = table.choice("test", test_names());
        for (const LaboratoryTest& test : laboratory_tests()) {
            if (test.name != out.test) continue;
            out.shear = test.shear;
            out.program = driven(table, test, out.cyclic);
        }
        if (out.test == "true_triaxial") out.program = true_triaxial(table);
        if (out.test == "components") out.program = components(table);
        if (out.test == "rest" || out.test == "creep") out.program = at_rest(table, out.test);
        read_exit(table, out, state_names);
        Commons commons{out.test, table.integer_or("record_every", 1, 1, 10000000), {}};
        if (table.has("duration_s")) commons.duration = table.positive_or("duration_s", 1.0);
        commons.apply(out.program);
    }
    out.program = repeated(std::move(out.program), table.integer_or("repeat", 1, 1, 10000000));
    out.zero_strain = table.boolean_or("zero_strain", false);
    table.finish();
    return out;
}

}  // namespace cli
