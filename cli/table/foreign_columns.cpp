// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/foreign_columns.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/table/columns.hpp"
#include "cli/table/laboratory_unit.hpp"

namespace cli {
namespace {

struct Name {
    const char* theirs;
    const char* ours;
    const char* unit;
    double factor;
};

constexpr Name foreign_names[] = {
    {"eps11", "strain_11", "-", 1.0},
    {"eps22", "strain_22", "-", 1.0},
    {"eps33", "strain_33", "-", 1.0},
    {"gam12", "gamma_12", "-", 1.0},
    {"gam13", "gamma_13", "-", 1.0},
    {"gam23", "gamma_23", "-", 1.0},
    {"s11", "stress_11", "kPa", 1.0},
    {"s22", "stress_22", "kPa", 1.0},
    {"s33", "stress_33", "kPa", 1.0},
    {"s12", "stress_12", "kPa", 1.0},
    {"s13", "stress_13", "kPa", 1.0},
    {"s23", "stress_23", "kPa", 1.0},
    {"e", "void_ratio", "-", 1.0},
    {"time(1)", "time", "s", 1.0},
    {"stran(1)", "strain_11", "-", 1.0},
    {"stran(2)", "strain_22", "-", 1.0},
    {"stran(3)", "strain_33", "-", 1.0},
    {"stran(4)", "gamma_12", "-", 1.0},
    {"stran(5)", "gamma_13", "-", 1.0},
    {"stran(6)", "gamma_23", "-", 1.0},
    {"stress(1)", "stress_11", "kPa", 1.0},
    {"stress(2)", "stress_22", "kPa", 1.0},
    {"stress(3)", "stress_33", "kPa", 1.0},
    {"stress(4)", "stress_12", "kPa", 1.0},
    {"stress(5)", "stress_13", "kPa", 1.0},
    {"stress(6)", "stress_23", "kPa", 1.0},
    {"eps_a_percent", "axial_strain", "-", -0.01},
    {"eps_v_percent", "volumetric_strain", "-", -0.01},
    {"q_kPa", "axial_deviator", "kPa", 1.0},
    {"p_kPa", "p", "kPa", 1.0},
    {"sigma_a_kPa", "stress_11", "kPa", -1.0},
    {"sigma_r_kPa", "stress_22", "kPa", -1.0},
    // Of cycles, as they are.
    {"gamma_amplitude", "gamma_amplitude", "-", 1.0},
    {"G/G_0", "G/G_0", "-", 1.0},
    {"damping", "damping", "-", 1.0},
    {"u/p0", "u/p0", "-", 1.0},
};

// Sum of factors times columns; nothing where one of them is missing or the name is taken.
void combine(Table& table, const char* name, const char* unit,
             std::initializer_list<std::pair<const char*, double>> terms) {
    if (std::any_of(table.columns.begin(), table.columns.end(),
                    [&](const Column& column) { return column.name == name; }))
        return;
    Column out{name, unit, std::vector<double>(table.rows(), 0.0), {}};
    for (const auto& [term, factor] : terms) {
        const std::vector<double>* values = table.find(term);
        if (!values) return;
        for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] += factor * (*values)[i];
    }
    table.columns.push_back(std::move(out));
}

const Name* find_name(const std::string& theirs) {
    for (const Name& each : foreign_names)
        if (theirs == each.theirs) return &each;
    return nullptr;
}

bool of_laboratories(const Name& name) {
    return std::string(name.theirs).ends_with("_kPa") ||
           std::string(name.theirs).ends_with("_percent");
}

// To Grit's name and unit. A unit in the header has more to say than one in the name.
void standardise(Column& column, const std::string& file) {
    const char* unit = unit_of_column(column.name);
    if (!unit || !*unit) return;  // not understood, or a number of things
    const Name* name = find_name(column.name);
    // Everybody's word, in whatever unit.
    if (column.name == "time" && column.unit.empty()) return;
    double factor = name ? name->factor : 1.0;
    if (!column.unit.empty()) {
        const LaboratoryUnit* said = laboratory_unit(column.unit, unit);
        if (!said && column.problem.empty())
            column.problem =
                fmt::format("{}{}column {}: its unit [{}] is not known here; known: {}", file,
                            file.empty() ? "" : ": ", column.name, column.unit,
                            fmt::join(laboratory_units(unit), ", "));
        if (said) factor = std::copysign(said->size, factor);
    }
    if (name) column.name = name->ours;
    column.unit = unit;
    if (factor != 1.0)
        for (double& value : column.values) value *= factor;
}

}  // namespace

Table standardised(Table table) {
    for (Column& column : table.columns) standardise(column, table.file);
    // Simple shear has no other strain worth naming than gamma_12.
    const std::vector<double>* gamma = table.find("gamma_12");
    const bool shear = gamma && std::any_of(gamma->begin(), gamma->end(),
                                            [](double x) { return std::abs(x) > 1e-9; });
    combine(table, "axial_strain", "-", {{"strain_11", 1.0}});
    combine(table, "volumetric_strain", "-",
            {{"strain_11", 1.0}, {"strain_22", 1.0}, {"strain_33", 1.0}});
    combine(table, "p", "kPa",
            {{"stress_11", -1.0 / 3.0}, {"stress_22", -1.0 / 3.0}, {"stress_33", -1.0 / 3.0}});
    combine(table, "axial_deviator", "kPa",
            {{"stress_11", -1.0}, {"stress_22", 0.5}, {"stress_33", 0.5}});
    if (shear) {
        combine(table, "shear_strain", "-", {{"gamma_12", 1.0}});
        combine(table, "shear_stress", "kPa", {{"stress_12", 1.0}});
    } else {
        combine(table, "shear_strain", "-",
                {{"strain_11", 1.0}, {"strain_22", -0.5}, {"strain_33", -0.5}});
        combine(table, "shear_stress", "kPa", {{"axial_deviator", -0.5}});
    }
    return table;
}

std::vector<std::string> foreign_column_names() {
    std::vector<std::string> out;
    for (const Name& name : foreign_names) out.emplace_back(name.theirs);
    return out;
}

std::vector<std::string> laboratory_column_names() {
    std::vector<std::string> out;
    for (const Name& name : foreign_names)
        if (of_laboratories(name)) out.emplace_back(name.theirs);
    return out;
}

std::string standard_column_name(const std::string& name) {
    const Name* found = find_name(name);
    return found ? found->ours : name;
}

const char* unit_of_column(const std::string& name) {
    const Name* found = find_name(name);
    return found ? found->unit : unit_of_standard_column(name);
}

}  // namespace cli
