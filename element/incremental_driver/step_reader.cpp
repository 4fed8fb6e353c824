// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/step_reader.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "element/check.hpp"
#include "element/errors.hpp"
#include "element/incremental_driver/loads.hpp"
#include "element/nearest.hpp"
#include "element/schedule.hpp"
#include "element/simulate.hpp"

namespace incremental_driver {
namespace {

using element::Control;
using element::Controls;
using element::Variables;

constexpr Control E = Control::strain, S = Control::stress;
constexpr int nothing = -1;

// Steps in the words of the laboratory: one variable is driven, the others keep stress or strain.
struct ShortForm {
    const char* name;
    Variables variables;
    Controls controls;
    int driven;  // its change follows on a line; nothing: no such line
};

const ShortForm short_forms[] = {
    {"*OedometricE1", Variables::cartesian, {E, E, E, E, E, E}, 0},
    {"*OedometricS1", Variables::cartesian, {S, E, E, E, E, E}, 0},
    {"*TriaxialE1", Variables::cartesian, {E, S, S, E, E, E}, 0},
    {"*TriaxialS1", Variables::cartesian, {S, S, S, E, E, E}, 0},
    {"*TriaxialUEq", Variables::roscoe, {E, E, E, E, E, E}, 1},
    {"*TriaxialUq", Variables::roscoe, {E, S, E, E, E, E}, 1},
    {"*PureRelaxation", Variables::cartesian, {E, E, E, E, E, E}, nothing},
    {"*PureCreep", Variables::cartesian, {S, S, S, S, S, S}, nothing},
    {"*UndrainedCreep", Variables::roscoe, {E, S, S, S, S, S}, nothing},
};

struct LongForm {
    const char* name;
    element::Kind (*read)(Lines&);
};

const LongForm long_forms[] = {
    {"*LinearLoad", read_linear},
    {"*CirculatingLoad", read_circulating},
    {"*DeformationGradient", read_deformation_gradient},
    {"*ObeyRestrictions", read_restrictions},
    {"*PerturbationsS", read_stress_perturbations},
    {"*PerturbationsE", read_strain_perturbations},
    {"*RandomWalk", read_random_walk},
};

element::Kind read_short_form(Lines& lines, const ShortForm& form) {
    element::Linear out;
    out.rows = mixed_control(form.controls, form.variables);
    if (form.driven != nothing) {
        const std::string what = std::string("the change of ") + form.name;
        out.change[form.driven] = Fields(lines, lines.next(what)).single(what);
    }
    return out;
}

[[noreturn]] void fail_unknown(const Lines& lines, const Keyword& keyword) {
    std::vector<std::string> known{"*ImportFile", "*Repetition", "*End"};
    for (const ShortForm& form : short_forms) known.emplace_back(form.name);
    for (const LongForm& form : long_forms) known.emplace_back(form.name);
    lines.fail(keyword.line,
               "unknown step \"" + keyword.name + "\"" + element::suggestion(keyword.name, known));
}

// What the library says of the step, said of this line.
void check(const Lines& lines, const Keyword& keyword, const element::Step& step) {
    try {
        element::check_step(step);
    } catch (const element::BadCase& error) {
        lines.fail(keyword.line, step.name + ": " + error.what());
    }
}

}  // namespace

element::Step read_step(Lines& lines, const Keyword& keyword, StepContext& context) {
    const auto named = [&](const auto& form) { return form.name == keyword.name; };
    const auto* short_form = std::find_if(std::begin(short_forms), std::end(short_forms), named);
    const auto* long_form = std::find_if(std::begin(long_forms), std::end(long_forms), named);
    const bool is_short = short_form != std::end(short_forms);
    const bool is_import = keyword.name == "*ImportFile";
    if (!is_short && !is_import && long_form == std::end(long_forms)) fail_unknown(lines, keyword);
    const Commons commons = read_commons(lines, keyword.name);
    element::Step step;
    step.name = keyword.name;
    step.increments = commons.increments;
    step.duration = commons.duration;
    step.temperature_change = commons.temperature_change;
    // incrementalDriver always makes maxiter iterations; here they end where the rows are met.
    step.iteration_limit = std::max(commons.iterations, element::Settings{}.iteration_limit);
    step.every = commons.every;
    step.record_first = true;
    step.record_end = false;
    if (is_import) context.inputs.push_back(read_import(lines, keyword, context.folder, step));
    else step.kind = is_short ? read_short_form(lines, *short_form) : long_form->read(lines);
    if (!keyword.condition.empty())
        step.exit.any_of = {read_condition(lines, keyword, context.vocabulary)};
    check(lines, keyword, step);
    return step;
}

}  // namespace incremental_driver
