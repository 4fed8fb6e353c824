// SPDX-License-Identifier: BSD-3-Clause
// The minima of the nodes: how every function on them reads its caller's struct.
#pragma once

#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "support/call_checks.hpp"

namespace grit {

inline grit_status check_body(int body, const char* name, grit_error* error) {
    GRIT_REQUIRE(body == GRIT_CONTACT_BODY_A || body == GRIT_CONTACT_BODY_B,
                 "%s must be 0 (A) or 1 (B), got %d", name, body);
    return GRIT_OK;
}

inline grit_status read_surfaces(const grit_contact_surfaces* caller, grit_contact_surfaces& ours,
                                 grit_error* error) {
    GRIT_CHECK(check_given(caller, "surfaces", error));
    GRIT_CHECK(read_struct(caller, ours, "grit_contact_surfaces", error));
    GRIT_CHECK(check_dimension(ours.components, error));
    GRIT_CHECK(check_reserved(ours.reserved, "grit_contact_surfaces.reserved", error));
    GRIT_CHECK(check_count(ours.nodes, "nodes", error));
    if (ours.nodes == 0) return GRIT_OK;  // an empty array may have no base pointer
    GRIT_CHECK(check_usable(ours.surface, 2, "surface", error));
    GRIT_CHECK(check_written(ours.surface, ours.nodes, "surface", "nodes", error));
    if (ours.centre.base)
        GRIT_CHECK(check_component_strides({ours.centre.component_stride}, "centre", error));
    return check_written(ours.centre, ours.nodes, "centre", "nodes", error);
}

}  // namespace grit
