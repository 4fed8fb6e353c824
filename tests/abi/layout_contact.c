/* SPDX-License-Identifier: BSD-3-Clause */
#include "layout.h"

VALUE(GRIT_CONTACT_A_RIGID, 1);
VALUE(GRIT_CONTACT_B_RIGID, 2);
VALUE(GRIT_CONTACT_FRICTIONAL, 1);
VALUE(GRIT_CONTACT_GEO, 0);
VALUE(GRIT_CONTACT_INACTIVE, 0);
VALUE(GRIT_CONTACT_MOST_BODIES, 8);
VALUE(GRIT_CONTACT_NONE_RIGID, 0);
VALUE(GRIT_CONTACT_OPEN, 1);
VALUE(GRIT_CONTACT_SLIP, 3);
VALUE(GRIT_CONTACT_STICK, 2);
VALUE(GRIT_CONTACT_SUMS_WORDS, 1200);

#if defined(__LP64__)

SIZE(grit_contact_options, 96);
PLACE(grit_contact_options, struct_size, 0);
PLACE(grit_contact_options, components, 8);
PLACE(grit_contact_options, law, 12);
PLACE(grit_contact_options, penalty_power, 16);
PLACE(grit_contact_options, friction_coefficient, 24);
PLACE(grit_contact_options, adhesion, 32);
PLACE(grit_contact_options, time_step, 40);
PLACE(grit_contact_options, mass_tolerance, 48);
PLACE(grit_contact_options, gap_tolerance, 56);
PLACE(grit_contact_options, rigid, 64);
PLACE(grit_contact_options, allow_zero_normal, 68);
PLACE(grit_contact_options, instruction_set, 72);
PLACE(grit_contact_options, validate_only, 76);
PLACE(grit_contact_options, relaxation_time, 80);
PLACE(grit_contact_options, contact_stiffness, 88);

SIZE(grit_contact_nodes, 400);
PLACE(grit_contact_nodes, struct_size, 0);
PLACE(grit_contact_nodes, index, 8);
PLACE(grit_contact_nodes, mass_a, 16);
PLACE(grit_contact_nodes, mass_b, 40);
PLACE(grit_contact_nodes, normal, 64);
PLACE(grit_contact_nodes, distance, 88);
PLACE(grit_contact_nodes, cell_size, 112);
PLACE(grit_contact_nodes, spacing, 136);
PLACE(grit_contact_nodes, gap, 160);
PLACE(grit_contact_nodes, contact_area, 184);
PLACE(grit_contact_nodes, velocity_a, 208);
PLACE(grit_contact_nodes, velocity_b, 232);
PLACE(grit_contact_nodes, acceleration_a, 256);
PLACE(grit_contact_nodes, acceleration_b, 280);
PLACE(grit_contact_nodes, previous_velocity_a, 304);
PLACE(grit_contact_nodes, previous_velocity_b, 328);
PLACE(grit_contact_nodes, position, 352);
PLACE(grit_contact_nodes, pore_impulse, 376);

SIZE(grit_contact_report, 128);
PLACE(grit_contact_report, status, 0);
PLACE(grit_contact_report, state, 4);
PLACE(grit_contact_report, penalty_factor, 8);
PLACE(grit_contact_report, impulse, 16);
PLACE(grit_contact_report, force, 40);
PLACE(grit_contact_report, trial_energy_normal, 64);
PLACE(grit_contact_report, trial_energy_tangential, 72);
PLACE(grit_contact_report, dissipation_normal, 80);
PLACE(grit_contact_report, dissipation_tangential, 88);
PLACE(grit_contact_report, reserved, 96);

SIZE(grit_contact_sums, 9600);
PLACE(grit_contact_sums, word, 0);

SIZE(grit_contact_totals, 224);
PLACE(grit_contact_totals, struct_size, 0);
PLACE(grit_contact_totals, impulse_on_a, 8);
PLACE(grit_contact_totals, impulse_on_b, 32);
PLACE(grit_contact_totals, force_on_a, 56);
PLACE(grit_contact_totals, force_on_b, 80);
PLACE(grit_contact_totals, moment_on_a, 104);
PLACE(grit_contact_totals, moment_on_b, 128);
PLACE(grit_contact_totals, trial_energy_normal, 152);
PLACE(grit_contact_totals, trial_energy_tangential, 160);
PLACE(grit_contact_totals, dissipation_normal, 168);
PLACE(grit_contact_totals, dissipation_tangential, 176);
PLACE(grit_contact_totals, inactive, 184);
PLACE(grit_contact_totals, open, 192);
PLACE(grit_contact_totals, stick, 200);
PLACE(grit_contact_totals, slip, 208);
PLACE(grit_contact_totals, failed, 216);

SIZE(grit_contact_pair, 192);
PLACE(grit_contact_pair, struct_size, 0);
PLACE(grit_contact_pair, a, 8);
PLACE(grit_contact_pair, b, 12);
PLACE(grit_contact_pair, options, 16);
PLACE(grit_contact_pair, normal, 24);
PLACE(grit_contact_pair, distance, 48);
PLACE(grit_contact_pair, cell_size, 72);
PLACE(grit_contact_pair, spacing, 96);
PLACE(grit_contact_pair, gap, 120);
PLACE(grit_contact_pair, contact_area, 144);
PLACE(grit_contact_pair, pore_impulse, 168);

SIZE(grit_contact_bodies, 104);
PLACE(grit_contact_bodies, struct_size, 0);
PLACE(grit_contact_bodies, components, 8);
PLACE(grit_contact_bodies, count, 12);
PLACE(grit_contact_bodies, index, 16);
PLACE(grit_contact_bodies, mass, 24);
PLACE(grit_contact_bodies, velocity, 32);
PLACE(grit_contact_bodies, acceleration, 40);
PLACE(grit_contact_bodies, previous_velocity, 48);
PLACE(grit_contact_bodies, position, 56);
PLACE(grit_contact_bodies, sweep_tolerance, 80);
PLACE(grit_contact_bodies, sweep_limit, 88);
PLACE(grit_contact_bodies, instruction_set, 92);
PLACE(grit_contact_bodies, validate_only, 96);
PLACE(grit_contact_bodies, reserved, 100);

#endif
