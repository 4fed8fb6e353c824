// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm_history.hpp"

#include <fmt/format.h>

#include "cli/version.hpp"

namespace cli {
namespace {

using grit::mpm::HistoryRow;

struct HistoryColumn {
    const char* name;
    const char* unit;
    double (*value)(const HistoryRow&);
};

constexpr double kilo = 1e-3;

constexpr HistoryColumn columns[] = {
    {"stage", "", [](const HistoryRow& r) { return static_cast<double>(r.stage); }},
    {"step", "", [](const HistoryRow& r) { return static_cast<double>(r.step); }},
    {"t", "s", [](const HistoryRow& r) { return r.t; }},
    {"blow", "", [](const HistoryRow& r) { return static_cast<double>(r.blow); }},
    {"depth", "m", [](const HistoryRow& r) { return r.depth; }},
    {"velocity", "m/s", [](const HistoryRow& r) { return r.velocity; }},
    {"tip_force", "kN", [](const HistoryRow& r) { return kilo * r.tip_force; }},
    {"shaft_force", "kN", [](const HistoryRow& r) { return kilo * r.shaft_force; }},
    {"hammer_force", "kN", [](const HistoryRow& r) { return kilo * r.hammer_force; }},
    {"base_force", "kN", [](const HistoryRow& r) { return kilo * r.base_force; }},
    {"kinetic_energy", "J", [](const HistoryRow& r) { return r.energy.kinetic; }},
    {"stored_energy", "J", [](const HistoryRow& r) { return r.energy.stored - r.energy.stored_0; }},
    {"external_work", "J", [](const HistoryRow& r) { return r.energy.external_work; }},
    {"rigid_work", "J", [](const HistoryRow& r) { return r.energy.rigid_work; }},
    {"contact_loss", "J", [](const HistoryRow& r) { return r.energy.contact; }},
    {"damping_loss", "J", [](const HistoryRow& r) { return r.energy.damping; }},
    {"viscosity_loss", "J", [](const HistoryRow& r) { return r.energy.viscosity; }},
    {"absorbed", "J", [](const HistoryRow& r) { return r.energy.absorbed; }},
    {"transfer_loss", "J", [](const HistoryRow& r) { return r.energy.transfer; }},
    {"pic_loss", "J", [](const HistoryRow& r) { return r.energy.pic; }},
    {"energy_residual", "J", [](const HistoryRow& r) { return r.energy.residual(); }},
    {"residual_share", "-", [](const HistoryRow& r) { return r.residual_share; }},
    {"dt", "s", [](const HistoryRow& r) { return r.dt; }},
    {"largest_gap", "m", [](const HistoryRow& r) { return r.largest_gap; }},
    {"unbalanced_share", "-", [](const HistoryRow& r) { return r.unbalanced_share; }},
};

}  // namespace

std::vector<Column> history_columns() {
    std::vector<Column> out;
    for (const HistoryColumn& column : columns) out.push_back({column.name, column.unit, {}, {}});
    return out;
}

std::vector<double> history_values(const HistoryRow& row) {
    std::vector<double> out;
    for (const HistoryColumn& column : columns) out.push_back(column.value(row));
    return out;
}

std::vector<std::string> history_comments(const grit::mpm::Runner& runner) {
    const grit::mpm::Case& plan = runner.description();
    const char* whole =
        plan.settings.axisymmetric ? "of the whole bodies (2 pi radians)" : "per metre";
    return {
        fmt::format("Grit {}, case {}: {}", version(), plan.name, plan.title),
        fmt::format("{} particles, driven body: {}", runner.particles(), plan.history.body),
        fmt::format(
            "depth and velocity of the driven body, downwards; depth of its {} since the start",
            plan.history.depth_of == grit::mpm::DepthOf::lowest_point ? "lowest point"
                                                                      : "centre of mass"),
        fmt::format(
            "forces and energies {}; forces are means since the row before: of contacts on the "
            "driven body, upwards, tip where surfaces face along z, shaft where along r; "
            "hammer: tractions on it, downwards; base: reaction of the grid's bottom, upwards",
            whole),
        "stored_energy is the work that stresses took since the start; losses count down from the "
        "work done; energy_residual = kinetic (less that of the start) + stored + contact + "
        "damping + viscosity + absorbed + transfer - external - rigid; transfer includes pic; "
        "residual_share: "
        "of the largest of them",
        "unbalanced_share: largest |m dv/dt| at a node / largest nodal force of its body; "
        "largest_gap: nan where no distance is measured",
        "how the run ended stands below the last row"};
}

}  // namespace cli
