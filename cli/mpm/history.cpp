// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/history.hpp"

#include <iterator>
#include <utility>

#include <adapters/mpm/run/history.hpp>
#include <fmt/format.h>

#include "cli/mpm/geometry_words.hpp"
#include "cli/process/version.hpp"

namespace cli {
namespace {

using grit::mpm::HistoryColumn;

constexpr double kilonewton = 1e-3;  // of a newton

// A force or a moment, which is shown in kN.
bool is_force(const HistoryColumn& column) { return column.unit[0] == 'N'; }

std::span<const HistoryColumn> columns_of(const grit::mpm::Case& plan) {
    return grit::mpm::history_columns(plan.space.has_value());
}

}  // namespace

std::vector<Column> history_columns(const grit::mpm::Case& plan) {
    const GeometryWords& words = words_of(plan);
    const std::pair<std::string, const char*> forces[] = {
        {"tip_force", words.under}, {"shaft_force", words.side}, {"hammer_force", words.load}};
    std::vector<Column> out;
    for (const HistoryColumn& column : columns_of(plan)) {
        std::string name = column.name, unit = column.unit;
        if (is_force(column)) unit = fmt::format("k{}", unit);
        for (const auto& [of_pile, word] : forces)
            if (name == of_pile) name = word + std::string("_force");
        if (unit == "kN" || unit == "J" || unit == "kg") unit += words.per;
        out.push_back({name, unit, {}, {}});
    }
    for (int part = 1; part <= plan.history.profile.parts; ++part)
        for (const char* along : {"x", "y", "z"})
            out.push_back({fmt::format("profile_{}_{}", along, part), "kN", {}, {}});
    return out;
}

std::string history_table() {
    std::string out = "| `f_ID[...]` | column | unit |\n|---|---|---|\n";
    int number = 0;
    for (const HistoryColumn& column : grit::mpm::history_columns())
        out += fmt::format("| {} | `{}` | {} |\n", ++number, column.name,
                           *column.unit ? column.unit : "-");
    return out;
}

std::vector<double> history_values(const grit::mpm::Case& plan, const grit::mpm::HistoryRow& row) {
    std::vector<double> out;
    for (const HistoryColumn& column : columns_of(plan))
        out.push_back((is_force(column) ? kilonewton : 1.0) * column.value(row));
    for (const double force : row.profile) out.push_back(kilonewton * force);
    return out;
}

std::vector<std::string> history_comments(const grit::mpm::Runner& runner,
                                          const std::string& changes) {
    const grit::mpm::Case& plan = runner.description();
    const GeometryWords& words = words_of(plan);
    const std::string load =
        plan.tractions.empty() ? "" : fmt::format(" {}: tractions on it, downwards;", words.load);
    std::vector<std::string> out{made_by_grit("case " + plan.name, plan.title)};
    if (!changes.empty()) out.push_back(changes);
    const std::string more[] = {
        fmt::format("{} particles, driven body: {}{}", runner.particles(), plan.history.body,
                    runner.driven_mass() > 0.0
                        ? fmt::format(", {:.12g} kg{}", runner.driven_mass(), words.per)
                        : ", rigid"),
        fmt::format(
            "depth and velocity of the driven body, downwards; depth of its {} since the start",
            plan.history.depth_of == grit::mpm::DepthOf::lowest_point ? "lowest point"
                                                                      : "centre of mass"),
        fmt::format(
            "forces and energies {}; forces are means since the row before: of contacts on the "
            "driven body, upwards, {} where surfaces face along z, {} where {};{} "
            "base: reaction of the grid's bottom, upwards; damping: local damping on it, upwards{}",
            words.whole, words.under, words.side, words.sideways, load,
            plan.space ? "; contact: of all contacts on it, along x, y and z, and their moments "
                         "about the origin"
                       : ""),
        "stored_energy is the work that stresses took since the start, driven_stored_energy "
        "what the driven body holds now; external_work includes traction_work; losses count "
        "down from the "
        "work done; energy_residual = kinetic (less that of the start) + stored + contact + "
        "damping + viscosity + absorbed + transfer + pore water + drag + "
        "implicit pressure + carried by water - external - rigid, without half a step's work of "
        "the pore pressures "
        "of the end; "
        "transfer includes pic; "
        "residual_share: "
        "of the largest of them",
        "unbalanced_share: largest |m dv/dt| at a node / largest nodal force of its body; "
        "largest_gap: nan where no distance is measured; pore_water_work: that the compression "
        "of pore water took, drag_loss: that the grains took from water that flows, "
        "implicit_pressure_loss: that an implicit pressure took of waves, carried_by_water: "
        "kinetic "
        "energy of water that left pores, less of what came into them; pore "
        "pressures: nan where no body has water; water_mass: of water that flows, nan where none "
        "does",
        "how the run ended stands below the last row"};
    out.insert(out.end(), std::begin(more), std::end(more));
    if (const grit::mpm::ProfilePlan& profile = plan.history.profile; profile.parts > 0)
        out.insert(
            out.end() - 1,
            fmt::format("profile: of all contacts on the driven body, in {} parts of {:.12g} "
                        "m from z = {:.12g} m up",
                        profile.parts, profile.height(), profile.from));
    return out;
}

}  // namespace cli
