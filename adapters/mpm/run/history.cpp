// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/run/history.hpp"

namespace grit::mpm {
namespace {

constexpr HistoryColumn columns[] = {
    {"stage", "", [](const HistoryRow& r) { return static_cast<double>(r.stage); }},
    {"step", "", [](const HistoryRow& r) { return static_cast<double>(r.step); }},
    {"t", "s", [](const HistoryRow& r) { return r.t; }},
    {"blow", "", [](const HistoryRow& r) { return static_cast<double>(r.blow); }},
    {"depth", "m", [](const HistoryRow& r) { return r.depth; }},
    {"velocity", "m/s", [](const HistoryRow& r) { return r.velocity; }},
    {"tip_force", "N", [](const HistoryRow& r) { return r.tip_force; }},
    {"shaft_force", "N", [](const HistoryRow& r) { return r.shaft_force; }},
    {"hammer_force", "N", [](const HistoryRow& r) { return r.hammer_force; }},
    {"base_force", "N", [](const HistoryRow& r) { return r.base_force; }},
    {"kinetic_energy", "J", [](const HistoryRow& r) { return r.energy.kinetic; }},
    {"stored_energy", "J", [](const HistoryRow& r) { return r.energy.stored - r.energy.stored_0; }},
    {"driven_stored_energy", "J", [](const HistoryRow& r) { return r.driven_stored; }},
    {"external_work", "J", [](const HistoryRow& r) { return r.energy.external_work; }},
    {"traction_work", "J", [](const HistoryRow& r) { return r.energy.traction_work; }},
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
    {"damping_force", "N", [](const HistoryRow& r) { return r.damping_force; }},
    {"pore_water_work", "J", [](const HistoryRow& r) { return r.energy.pore_water; }},
    {"drag_loss", "J", [](const HistoryRow& r) { return r.energy.drag; }},
    {"least_pore_pressure", "Pa", [](const HistoryRow& r) { return r.least_pore_pressure; }},
    {"largest_pore_pressure", "Pa", [](const HistoryRow& r) { return r.largest_pore_pressure; }},
    {"implicit_pressure_loss", "J", [](const HistoryRow& r) { return r.energy.implicit; }},
    {"water_mass", "kg", [](const HistoryRow& r) { return r.water_mass; }},
    {"carried_by_water", "J", [](const HistoryRow& r) { return r.energy.carried; }},
    {"contact_force_x", "N", [](const HistoryRow& r) { return r.contact[0]; }},
    {"contact_force_y", "N", [](const HistoryRow& r) { return r.contact[1]; }},
    {"contact_force_z", "N", [](const HistoryRow& r) { return r.contact[2]; }},
    {"contact_moment_x", "N m", [](const HistoryRow& r) { return r.contact[3]; }},
    {"contact_moment_y", "N m", [](const HistoryRow& r) { return r.contact[4]; }},
    {"contact_moment_z", "N m", [](const HistoryRow& r) { return r.contact[5]; }},
};
constexpr std::size_t in_space_alone = 6;  // the last ones

}  // namespace

std::span<const HistoryColumn> history_columns(bool in_space) {
    return std::span(columns).first(std::size(columns) - (in_space ? 0 : in_space_alone));
}

}  // namespace grit::mpm
