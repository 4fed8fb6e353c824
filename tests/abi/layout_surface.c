/* SPDX-License-Identifier: BSD-3-Clause */
#include "layout.h"

#if defined(__LP64__)

SIZE(grit_surface_options, 88);
PLACE(grit_surface_options, struct_size, 0);
PLACE(grit_surface_options, components, 8);
PLACE(grit_surface_options, axisymmetric, 12);
PLACE(grit_surface_options, validate_only, 16);
PLACE(grit_surface_options, sweep_limit, 20);
PLACE(grit_surface_options, sweep_tolerance, 24);
PLACE(grit_surface_options, friction_coefficient, 32);
PLACE(grit_surface_options, time_step, 40);
PLACE(grit_surface_options, spacing, 48);
PLACE(grit_surface_options, reach, 56);
PLACE(grit_surface_options, end_spacings, 64);
PLACE(grit_surface_options, contact_stiffness, 72);
PLACE(grit_surface_options, relaxation_time, 80);

SIZE(grit_surface, 304);
PLACE(grit_surface, struct_size, 0);
PLACE(grit_surface, rigid, 8);
PLACE(grit_surface, nodes_each, 12);
PLACE(grit_surface, vertices, 16);
PLACE(grit_surface, facets, 24);
PLACE(grit_surface, position, 32);
PLACE(grit_surface, facet, 56);
PLACE(grit_surface, node, 64);
PLACE(grit_surface, weight, 72);
PLACE(grit_surface, nodes, 80);
PLACE(grit_surface, mass, 88);
PLACE(grit_surface, fixed, 112);
PLACE(grit_surface, velocity, 120);
PLACE(grit_surface, previous_velocity, 144);
PLACE(grit_surface, vertex_velocity, 168);
PLACE(grit_surface, spacing, 192);
PLACE(grit_surface, pores, 200);
PLACE(grit_surface, water_fixed, 224);
PLACE(grit_surface, seepage, 232);
PLACE(grit_surface, previous_seepage, 256);
PLACE(grit_surface, pore_pressure, 280);
PLACE(grit_surface, body, 288);
PLACE(grit_surface, number, 296);

SIZE(grit_surface_pair, 40);
PLACE(grit_surface_pair, options, 0);
PLACE(grit_surface_pair, a, 8);
PLACE(grit_surface_pair, b, 16);
PLACE(grit_surface_pair, reports, 24);
PLACE(grit_surface_pair, totals, 32);

SIZE(grit_surface_report, 56);
PLACE(grit_surface_report, area, 0);
PLACE(grit_surface_report, gap, 8);
PLACE(grit_surface_report, normal_force, 16);
PLACE(grit_surface_report, friction_force, 24);
PLACE(grit_surface_report, force, 32);

SIZE(grit_surface_row, 88);
PLACE(grit_surface_row, first_term, 0);
PLACE(grit_surface_row, terms, 8);
PLACE(grit_surface_row, bound, 16);
PLACE(grit_surface_row, rigid, 24);
PLACE(grit_surface_row, impulse, 48);
PLACE(grit_surface_row, water_impulse, 72);

SIZE(grit_surface_term, 88);
PLACE(grit_surface_term, node, 0);
PLACE(grit_surface_term, of_b, 8);
PLACE(grit_surface_term, direction, 16);

SIZE(grit_surface_totals, 160);
PLACE(grit_surface_totals, struct_size, 0);
PLACE(grit_surface_totals, impulse_on_a, 8);
PLACE(grit_surface_totals, impulse_on_b, 32);
PLACE(grit_surface_totals, normal_impulse, 56);
PLACE(grit_surface_totals, area, 64);
PLACE(grit_surface_totals, dissipation_normal, 72);
PLACE(grit_surface_totals, dissipation_tangential, 80);
PLACE(grit_surface_totals, smallest_gap, 88);
PLACE(grit_surface_totals, largest_approach, 96);
PLACE(grit_surface_totals, residual, 104);
PLACE(grit_surface_totals, points, 112);
PLACE(grit_surface_totals, pressures, 120);
PLACE(grit_surface_totals, sweeps, 128);
PLACE(grit_surface_totals, row, 136);
PLACE(grit_surface_totals, term, 144);
PLACE(grit_surface_totals, rows, 152);

SIZE(grit_surface_domains, 88);
PLACE(grit_surface_domains, struct_size, 0);
PLACE(grit_surface_domains, n, 8);
PLACE(grit_surface_domains, index, 16);
PLACE(grit_surface_domains, position, 24);
PLACE(grit_surface_domains, side, 48);
PLACE(grit_surface_domains, tolerance, 80);

#endif
