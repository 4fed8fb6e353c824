/* SPDX-License-Identifier: BSD-3-Clause */
#include "layout.h"

VALUE(GRIT_PENALTY_TANGENTIAL_TRACTION, 0);
VALUE(GRIT_PENALTY_NORMAL_TRACTION, 1);
VALUE(GRIT_PENALTY_HISTORY_SIZE, 2);
VALUE(GRIT_PENALTY_OPEN, 0);
VALUE(GRIT_PENALTY_STICK, 1);
VALUE(GRIT_PENALTY_SLIP, 2);

#if defined(__LP64__)

SIZE(grit_penalty_options, 56);
PLACE(grit_penalty_options, struct_size, 0);
PLACE(grit_penalty_options, axisymmetric, 8);
PLACE(grit_penalty_options, validate_only, 12);
PLACE(grit_penalty_options, normal_stiffness, 16);
PLACE(grit_penalty_options, tangential_stiffness, 24);
PLACE(grit_penalty_options, friction_coefficient, 32);
PLACE(grit_penalty_options, depth_max, 40);
PLACE(grit_penalty_options, time_step, 48);

SIZE(grit_penalty_report, 80);
PLACE(grit_penalty_report, state, 0);
PLACE(grit_penalty_report, reserved, 4);
PLACE(grit_penalty_report, segment, 8);
PLACE(grit_penalty_report, place, 16);
PLACE(grit_penalty_report, gap, 24);
PLACE(grit_penalty_report, normal, 32);
PLACE(grit_penalty_report, area, 48);
PLACE(grit_penalty_report, normal_traction, 56);
PLACE(grit_penalty_report, tangential_traction, 64);
PLACE(grit_penalty_report, slip_rate, 72);

SIZE(grit_penalty_surface, 152);
PLACE(grit_penalty_surface, struct_size, 0);
PLACE(grit_penalty_surface, closed, 8);
PLACE(grit_penalty_surface, reserved, 12);
PLACE(grit_penalty_surface, count, 16);
PLACE(grit_penalty_surface, position, 24);
PLACE(grit_penalty_surface, velocity, 48);
PLACE(grit_penalty_surface, history, 72);
PLACE(grit_penalty_surface, force, 96);
PLACE(grit_penalty_surface, stiffness, 120);
PLACE(grit_penalty_surface, reports, 144);

SIZE(grit_penalty_totals, 136);
PLACE(grit_penalty_totals, struct_size, 0);
PLACE(grit_penalty_totals, force_on_a, 8);
PLACE(grit_penalty_totals, force_on_b, 24);
PLACE(grit_penalty_totals, moment_on_a, 40);
PLACE(grit_penalty_totals, moment_on_b, 48);
PLACE(grit_penalty_totals, contact_area, 56);
PLACE(grit_penalty_totals, normal_force, 64);
PLACE(grit_penalty_totals, energy_normal, 72);
PLACE(grit_penalty_totals, energy_tangential, 80);
PLACE(grit_penalty_totals, dissipation, 88);
PLACE(grit_penalty_totals, largest_penetration, 96);
PLACE(grit_penalty_totals, contacts_a, 104);
PLACE(grit_penalty_totals, contacts_b, 112);
PLACE(grit_penalty_totals, slips, 120);
PLACE(grit_penalty_totals, tests, 128);

SIZE(grit_penalty_remeshing, 168);
PLACE(grit_penalty_remeshing, struct_size, 0);
PLACE(grit_penalty_remeshing, closed, 8);
PLACE(grit_penalty_remeshing, reserved, 12);
PLACE(grit_penalty_remeshing, longest, 16);
PLACE(grit_penalty_remeshing, shortest, 24);
PLACE(grit_penalty_remeshing, tolerance, 32);
PLACE(grit_penalty_remeshing, count, 40);
PLACE(grit_penalty_remeshing, position, 48);
PLACE(grit_penalty_remeshing, history, 72);
PLACE(grit_penalty_remeshing, capacity, 96);
PLACE(grit_penalty_remeshing, new_position, 104);
PLACE(grit_penalty_remeshing, new_history, 128);
PLACE(grit_penalty_remeshing, parents, 152);
PLACE(grit_penalty_remeshing, weight, 160);

#endif
