// SPDX-License-Identifier: BSD-3-Clause
#include "contact/nodal/call_checks.hpp"

#include <cmath>

#include "support/call_checks.hpp"
#include "support/instruction_set.hpp"

namespace grit {
grit_contact_options default_contact_options() {
    grit_contact_options options{};
    options.struct_size = sizeof options;
    options.components = 3;
    options.penalty_power = GRIT_CONTACT_DEFAULT_PENALTY_POWER;
    options.mass_tolerance = 1e-10;
    return options;
}

grit_status read_given_options(const grit_contact_options* caller, grit_contact_options& ours,
                               grit_error* error) {
    ours = default_contact_options();
    if (!caller) return GRIT_OK;
    return read_struct(caller, ours, "grit_contact_options", error,
                       "call grit_contact_options_init first");
}

grit_status read_options(const grit_contact_options* caller, grit_contact_options& ours,
                         grit_error* error) {
    GRIT_CHECK(read_given_options(caller, ours, error));
    return check_contact_options(ours, error);
}

namespace {

// (C9)
grit_status check_in_time(const grit_contact_options& o, grit_error* error) {
    GRIT_REQUIRE(o.relaxation_time == 0.0 ||
                     (o.relaxation_time >= 1e-100 && o.relaxation_time <= 1e100),
                 "relaxation_time must be in [1e-100, 1e100] [time], or 0 for the step, got %g",
                 o.relaxation_time);
    GRIT_REQUIRE(o.contact_stiffness >= 0.0 && o.contact_stiffness <= 1e100,
                 "contact_stiffness must be in [0, 1e100] [stress/length], got %g",
                 o.contact_stiffness);
    if (o.relaxation_time == 0.0 && o.contact_stiffness == 0.0) return GRIT_OK;
    const struct {
        const char* name;
        double value;
    } given[] = {{"relaxation_time", o.relaxation_time},
                 {"contact_stiffness", o.contact_stiffness}};
    for (const auto& [name, value] : given) {
        if (value == 0.0) continue;
        GRIT_REQUIRE(o.law == GRIT_CONTACT_GEO, "%s %g belongs to GRIT_CONTACT_GEO, got law %d",
                     name, value, o.law);
        GRIT_REQUIRE(o.time_step > 0.0, "%s %g needs time_step > 0 [time], got %g", name, value,
                     o.time_step);
    }
    return GRIT_OK;
}

}  // namespace

grit_status check_contact_options(const grit_contact_options& o, grit_error* error) {
    GRIT_CHECK(check_dimension(o.components, error));
    GRIT_REQUIRE(o.law == GRIT_CONTACT_GEO || o.law == GRIT_CONTACT_FRICTIONAL,
                 "law must be GRIT_CONTACT_GEO or GRIT_CONTACT_FRICTIONAL, got %d", o.law);
    GRIT_REQUIRE(o.penalty_power > 0.0 && o.penalty_power <= 1e6,
                 "penalty_power must be in (0, 1e6] [-], got %g", o.penalty_power);
    GRIT_REQUIRE(o.friction_coefficient >= 0.0 && o.friction_coefficient <= 1e100,
                 "friction_coefficient must be in [0, 1e100] [-], got %g", o.friction_coefficient);
    GRIT_REQUIRE(o.adhesion >= 0.0 && o.adhesion <= 1e100,
                 "adhesion must be in [0, 1e100] [stress], got %g", o.adhesion);
    GRIT_REQUIRE(o.time_step == 0.0 || (o.time_step >= 1e-100 && o.time_step <= 1e100),
                 "time_step must be in [1e-100, 1e100] [time], or 0 for none, got %g", o.time_step);
    GRIT_REQUIRE(o.adhesion == 0.0 || o.time_step > 0.0,
                 "adhesion %g needs time_step > 0 [time], got %g", o.adhesion, o.time_step);
    GRIT_REQUIRE(o.mass_tolerance >= 0.0 && o.mass_tolerance < 0.5,
                 "mass_tolerance must be in [0, 0.5) [-], got %g", o.mass_tolerance);
    GRIT_REQUIRE(std::fabs(o.gap_tolerance) <= 1e100, "gap_tolerance must be finite, got %g",
                 o.gap_tolerance);
    GRIT_REQUIRE(o.rigid >= GRIT_CONTACT_NONE_RIGID && o.rigid <= GRIT_CONTACT_B_RIGID,
                 "rigid must be GRIT_CONTACT_NONE_RIGID, _A_RIGID or _B_RIGID, got %d", o.rigid);
    GRIT_CHECK(check_switch(o.allow_zero_normal, "allow_zero_normal", error));
    GRIT_CHECK(check_switch(o.validate_only, "validate_only", error));
    GRIT_CHECK(check_in_time(o, error));
    return check_instruction_set(o.instruction_set, error);
}

grit_status check_nodes(const grit_contact_nodes& q, const grit_contact_options& o,
                        std::ptrdiff_t n, grit_error* error) {
    const bool geo = o.law == GRIT_CONTACT_GEO;
    const struct {
        const char* name;
        bool needed;
        const grit_view& view;
        int components;
    } inputs[] = {
        {"mass_a", true, q.mass_a, 1},
        {"mass_b", true, q.mass_b, 1},
        {"normal", true, q.normal, o.components},
        {"distance", geo, q.distance, 1},
        {"contact_area", o.adhesion > 0.0 || o.contact_stiffness > 0.0, q.contact_area, 1},
        {"spacing", false, q.spacing, o.components},
        {"previous_velocity_a", false, q.previous_velocity_a, o.components},
        {"previous_velocity_b", false, q.previous_velocity_b, o.components},
        {"position", false, q.position, o.components},
        {"pore_impulse", false, q.pore_impulse, 1}};
    for (const auto& input : inputs) {
        if (input.needed) GRIT_CHECK(check_base(input.view, input.name, error));
        if (input.view.base)
            GRIT_CHECK(check_components(input.view, input.components, input.name, error));
    }
    if (o.contact_stiffness > 0.0) GRIT_CHECK(check_base(q.gap, "gap", error));
    GRIT_REQUIRE(!geo || q.cell_size.base || q.spacing.base,
                 "Geo-contact needs cell_size or spacing: neither has a base pointer");
    const struct {
        const char* name;
        bool needed, written;
        const grit_mutable_view& view;
    } outputs[] = {{"velocity_a", true, o.rigid != GRIT_CONTACT_A_RIGID, q.velocity_a},
                   {"velocity_b", true, o.rigid != GRIT_CONTACT_B_RIGID, q.velocity_b},
                   {"acceleration_a", false, o.rigid != GRIT_CONTACT_A_RIGID, q.acceleration_a},
                   {"acceleration_b", false, o.rigid != GRIT_CONTACT_B_RIGID, q.acceleration_b}};
    for (const auto& output : outputs) {
        if (output.needed) GRIT_CHECK(check_base(output.view, output.name, error));
        if (!output.view.base) continue;
        GRIT_REQUIRE(output.needed || o.time_step > 0.0,
                     "%s is to be corrected: needs time_step > 0 [time], got %g", output.name,
                     o.time_step);
        GRIT_CHECK(check_components(output.view, o.components, output.name, error));
        if (output.written)
            GRIT_CHECK(check_apart(output.view, o.components, n, output.name, "nodes", error));
    }
    return GRIT_OK;
}

}  // namespace grit
