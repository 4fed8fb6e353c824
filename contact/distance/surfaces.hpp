// SPDX-License-Identifier: BSD-3-Clause
// The minima of the nodes: how every function on them reads its caller's struct.
#pragma once

#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "contact/geometry_call.hpp"
#include "support/versioned.hpp"
#include "support/views.hpp"

namespace grit {

inline grit_status read_surfaces(const grit_contact_surfaces* caller, grit_contact_surfaces& ours,
                                 grit_error* error) {
    GRIT_REQUIRE(caller, "surfaces is null");
    GRIT_REQUIRE(read_versioned(caller, ours),
                 "grit_contact_surfaces.struct_size %zu is not understood: set it to sizeof",
                 caller->struct_size);
    GRIT_REQUIRE(ours.components == 2 || ours.components == 3, "components must be 2 or 3, got %d",
                 ours.components);
    GRIT_REQUIRE(ours.reserved == 0, "grit_contact_surfaces.reserved must be 0, got %d",
                 ours.reserved);
    GRIT_REQUIRE(ours.nodes >= 0, "nodes must be >= 0, got %td", ours.nodes);
    if (ours.nodes == 0) return GRIT_OK;  // an empty array may have no base pointer
    if (const grit_status s = check_usable(ours.surface, 2, "surface", error)) return s;
    if (const grit_status s = check_written(ours.surface, ours.nodes, "surface", "nodes", error))
        return s;
    GRIT_REQUIRE(!ours.centre.base || ours.centre.component_stride != 0,
                 "component_stride of centre must not be 0");
    return check_written(ours.centre, ours.nodes, "centre", "nodes", error);
}

}  // namespace grit
