/* SPDX-License-Identifier: BSD-3-Clause */
#include "layout.h"

VALUE(GRIT_CONTACT_BODY_A, 0);
VALUE(GRIT_CONTACT_BODY_B, 1);
VALUE(GRIT_CONTACT_FIXED_1, 1);
VALUE(GRIT_CONTACT_FIXED_2, 2);
VALUE(GRIT_CONTACT_FIXED_3, 4);
VALUE(GRIT_CONTACT_NORMAL_OF_A, 0);
VALUE(GRIT_CONTACT_NORMAL_OF_B, 1);
VALUE(GRIT_CONTACT_NORMAL_AVERAGE, 2);
VALUE(GRIT_CONTACT_NORMAL_GIVEN, 3);
VALUE(GRIT_CONTACT_SUPPORT, 0);
VALUE(GRIT_CONTACT_EDGE, 1);
VALUE(GRIT_CONTACT_NEAREST_CENTRE, 2);

#if defined(__LP64__)

SIZE(grit_contact_normal_counts, 32);
PLACE(grit_contact_normal_counts, struct_size, 0);
PLACE(grit_contact_normal_counts, defined, 8);
PLACE(grit_contact_normal_counts, undefined, 16);
PLACE(grit_contact_normal_counts, failed, 24);

SIZE(grit_contact_gradients, 176);
PLACE(grit_contact_gradients, struct_size, 0);
PLACE(grit_contact_gradients, components, 8);
PLACE(grit_contact_gradients, source, 12);
PLACE(grit_contact_gradients, index, 16);
PLACE(grit_contact_gradients, gradient_a, 24);
PLACE(grit_contact_gradients, gradient_b, 48);
PLACE(grit_contact_gradients, given, 72);
PLACE(grit_contact_gradients, scale, 96);
PLACE(grit_contact_gradients, threshold, 120);
PLACE(grit_contact_gradients, fixed, 128);
PLACE(grit_contact_gradients, fixed_stride, 136);
PLACE(grit_contact_gradients, status, 144);
PLACE(grit_contact_gradients, normal, 152);

SIZE(grit_contact_clouds, 184);
PLACE(grit_contact_clouds, struct_size, 0);
PLACE(grit_contact_clouds, components, 8);
PLACE(grit_contact_clouds, instruction_set, 12);
PLACE(grit_contact_clouds, index, 16);
PLACE(grit_contact_clouds, offset, 24);
PLACE(grit_contact_clouds, particle, 32);
PLACE(grit_contact_clouds, particles, 40);
PLACE(grit_contact_clouds, position, 48);
PLACE(grit_contact_clouds, body, 72);
PLACE(grit_contact_clouds, body_stride, 80);
PLACE(grit_contact_clouds, weight, 88);
PLACE(grit_contact_clouds, length, 112);
PLACE(grit_contact_clouds, ridge, 120);
PLACE(grit_contact_clouds, iteration_limit, 128);
PLACE(grit_contact_clouds, reserved, 132);
PLACE(grit_contact_clouds, fixed, 136);
PLACE(grit_contact_clouds, fixed_stride, 144);
PLACE(grit_contact_clouds, status, 152);
PLACE(grit_contact_clouds, normal, 160);

SIZE(grit_contact_surfaces, 120);
PLACE(grit_contact_surfaces, struct_size, 0);
PLACE(grit_contact_surfaces, components, 8);
PLACE(grit_contact_surfaces, reserved, 12);
PLACE(grit_contact_surfaces, nodes, 16);
PLACE(grit_contact_surfaces, position, 24);
PLACE(grit_contact_surfaces, normal, 48);
PLACE(grit_contact_surfaces, surface, 72);
PLACE(grit_contact_surfaces, centre, 96);

SIZE(grit_contact_domains, 104);
PLACE(grit_contact_domains, struct_size, 0);
PLACE(grit_contact_domains, body, 8);
PLACE(grit_contact_domains, sides, 12);
PLACE(grit_contact_domains, index, 16);
PLACE(grit_contact_domains, offset, 24);
PLACE(grit_contact_domains, nodes_each, 32);
PLACE(grit_contact_domains, node, 40);
PLACE(grit_contact_domains, position, 48);
PLACE(grit_contact_domains, side, 72);

SIZE(grit_contact_distances, 72);
PLACE(grit_contact_distances, struct_size, 0);
PLACE(grit_contact_distances, stiffer, 8);
PLACE(grit_contact_distances, measure, 12);
PLACE(grit_contact_distances, index, 16);
PLACE(grit_contact_distances, distance, 24);
PLACE(grit_contact_distances, gap, 48);

#endif
