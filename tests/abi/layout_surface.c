/* SPDX-License-Identifier: BSD-3-Clause */
#include "layout.h"

#if defined(__LP64__)

SIZE(grit_surface_options, 64);
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

SIZE(grit_surface, 200);
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

SIZE(grit_surface_report, 56);
PLACE(grit_surface_report, area, 0);
PLACE(grit_surface_report, gap, 8);
PLACE(grit_surface_report, normal_force, 16);
PLACE(grit_surface_report, friction_force, 24);
PLACE(grit_surface_report, force, 32);

SIZE(grit_surface_totals, 136);
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

SIZE(grit_surface_domains, 88);
PLACE(grit_surface_domains, struct_size, 0);
PLACE(grit_surface_domains, n, 8);
PLACE(grit_surface_domains, index, 16);
PLACE(grit_surface_domains, position, 24);
PLACE(grit_surface_domains, side, 48);
PLACE(grit_surface_domains, tolerance, 80);

#endif
