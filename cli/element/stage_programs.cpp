// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/stage_programs.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cli/element/laboratory_words.hpp"
#include "element/schedule.hpp"

namespace cli {

using element::Linear;
using element::Program;
using element::Step;

namespace {

// Strain is straight within an increment and memory lives on the scale of R, about 1e-4: increments
// that follow a turn start with a fiftieth of it and grow.
constexpr double first_strain = 2e-6;
constexpr double first_stress_share = 1e-3;
constexpr int increments_by_default = 400, increments_per_cycle = 200;

struct Pace {
    std::optional<double> first_share;
    bool strain = true;  // the path is one of strain, otherwise of stress
    double duration = 0.0;

    // path: length of the driven strain or stress
    double share(double path, int increments) const {
        if (first_share) return *first_share;
        const double fair = strain ? first_strain / std::abs(path) : first_stress_share;
        return fair * increments < 1.0 ? fair : 0.0;
    }
};

// A quarter out, then back and forth about the beginning; increments are those of a cycle. A half takes
// twice the time of the quarter.
Program triangles(const Step& amplitude, double path, int cycles, int increments,
                  const Pace& pace) {
    const double quarter_time = pace.duration / (1.0 + 4.0 * cycles);
    const auto leg = [&](double factor, int count) {
        Step step = amplitude;
        std::get<Linear>(step.kind).change *= factor;
        step.increments = count;
        step.first_share = pace.share(factor * path, count);
        step.duration = std::abs(factor) * quarter_time;
        return step;
    };
    const int quarter = std::max(1, increments / 4), half = std::max(1, increments / 2);
    Program out = {leg(1.0, quarter)};
    const Program cycle = repeated({leg(-2.0, half), leg(2.0, half)}, cycles);
    out.insert(out.end(), cycle.begin(), cycle.end());
    return out;
}

Program sines(Step step, int cycles, int increments, const Pace& pace) {
    element::Circulating kind;
    kind.rows = std::get<Linear>(step.kind).rows;
    kind.amplitude = std::get<Linear>(step.kind).change;
    kind.cycles = cycles;
    step.kind = kind;
    step.increments = increments * cycles;
    step.duration = pace.duration;
    return {step};
}

// increments: of the shortest stretch that the share is one of.
Pace read_pace(TomlTable& table, bool strain, int increments) {
    Pace pace;
    pace.strain = strain;
    if (table.has("duration_s")) pace.duration = table.positive_or("duration_s", 1.0);
    pace.first_share = table.number_if("first_share");
    if (pace.first_share && !(*pace.first_share > 0.0 && *pace.first_share * increments <= 1.0))
        table.fail("first_share",
                   fmt::format("{} must be in (0, 1/{}], for {} increments, got {:g}",
                               table.full("first_share"), increments, increments,
                               *pace.first_share));
    return pace;
}

int read_increments(TomlTable& table, const char* key, int otherwise) {
    return table.integer_or(key, otherwise, 1, element::increment_limit);
}

Program monotone(TomlTable& table, Step step, double path, bool strain) {
    step.increments = read_increments(table, "increments", increments_by_default);
    const Pace pace = read_pace(table, strain, step.increments);
    step.first_share = pace.share(path, step.increments);
    step.duration = pace.duration;
    return {step};
}

void check_strain(const TomlTable& table, const std::string& key, double value) {
    if (!(std::abs(value) <= 1.0))
        table.fail(
            key, fmt::format("{} must be in [-1, 1], got {:g}: percent?", table.full(key), value));
}

// A stress that the soil is to reach: effective, or total.
void check_pressing(const TomlTable& table, const std::string& key, double value, double sign) {
    if (!(sign * value <= 0.0))
        table.fail(key,
                   fmt::format("{} would pull: got {:g}, {}", table.full(key), value,
                               sign > 0.0 ? "compression is negative" : "a pressure is positive"));
}

double nonzero(TomlTable& table, const std::string& key) {
    const double value = table.number(key);
    if (value == 0.0) table.fail(key, table.full(key) + " must not be 0");
    return value;
}

StageProgram driven(TomlTable& table, const LaboratoryTest& test) {
    StageProgram out;
    out.shear = test.shear;
    std::vector<std::string> keys;
    for (const Way& way : test.ways) {
        keys.push_back(way.key);
        keys.push_back(way.amplitude_key());
    }
    const std::string key = table.one_of(keys);
    for (const Way& way : test.ways) {
        if (key != way.key && key != way.amplitude_key()) continue;
        out.cyclic = key != way.key;
        const double value = way.strain() || out.cyclic ? nonzero(table, key) : table.number(key);
        if (way.strain()) check_strain(table, key, value);
        else if (!out.cyclic && !test.shear) check_pressing(table, key, value, way.sign);
        Step step = way.step(way.sign * value);
        if (!out.cyclic) {
            for (const int row : way.reached) std::get<Linear>(step.kind).absolute[row] = true;
            out.steps = monotone(table, step, value, way.strain());
            continue;
        }
        const int cycles = table.integer_or("cycles", 1, 1, element::increment_limit);
        const int increments = read_increments(table, "increments_per_cycle", increments_per_cycle);
        const bool sine = table.has("wave") && table.choice("wave", {"triangle", "sine"}) == "sine";
        const Pace pace = read_pace(table, way.strain(), sine ? 1 : std::max(1, increments / 2));
        if (sine && pace.first_share)
            table.fail("first_share", table.full("first_share") + ": not for a sine");
        if (static_cast<double>(increments) * cycles > element::increment_limit && sine)
            table.fail("cycles", fmt::format("{}: a sine has at most {} increments, got {:g}",
                                             table.full("cycles"), element::increment_limit,
                                             static_cast<double>(increments) * cycles));
        out.steps = sine ? sines(step, cycles, increments, pace)
                         : triangles(step, value, cycles, increments, pace);
    }
    return out;
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
        change[i] = e ? e.value_or(0.0) : s.value_or(0.0);
        if (e) check_strain(*strain, name, change[i]);
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
    for (const double each : value) {
        if (key == "strain") check_strain(table, key, each);
        else check_pressing(table, key, each, 1.0);
    }
    if (key == "strain") {
        if (change.isZero()) table.fail(key, table.full(key) + " must not be 0");
        return monotone(table, element::component_control({}, change), change.cwiseAbs().maxCoeff(),
                        true);
    }
    Step step = element::true_triaxial(change);
    for (std::size_t i = 0; i < 3; ++i) std::get<Linear>(step.kind).absolute[i] = true;
    return monotone(table, step, 1.0, false);
}

// Nothing but time and water moves.
Program at_rest(TomlTable& table, const std::string& test) {
    const bool drains = test == "drain";
    Step step = drains            ? element::drainage()
                : test == "creep" ? element::creep(0.0)
                                  : element::relaxation(0.0);
    step.increments = read_increments(table, "increments", drains ? increments_by_default : 1);
    const Pace pace = read_pace(table, false, step.increments);
    step.duration = pace.duration;
    if (drains) step.first_share = pace.share(1.0, step.increments);
    return {step};
}

}  // namespace

Program repeated(Program program, int times) {
    if (times == 1) return program;
    Step step;
    step.kind = element::Repetition{std::move(program), times};
    return {step};
}

const std::vector<std::string>& test_names() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> names;
        for (const LaboratoryTest& test : laboratory_tests()) names.push_back(test.name);
        for (const char* name : {"true_triaxial", "components", "rest", "creep", "drain"})
            names.emplace_back(name);
        return names;
    }();
    return all;
}

StageProgram read_test(TomlTable& table, const std::string& test) {
    for (const LaboratoryTest& known : laboratory_tests())
        if (known.name == test) return driven(table, known);
    if (test == "true_triaxial") return {true_triaxial(table)};
    if (test == "components") return {components(table)};
    return {at_rest(table, test)};
}

}  // namespace cli
