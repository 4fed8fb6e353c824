// SPDX-License-Identifier: BSD-3-Clause
// PROPS (docs/umat.md): the material, the pore water, the initial void ratio.
#pragma once

#include <grit/classic_layout.h>

namespace grit::abaqus {

struct Material {
    grit_sand sand;
    grit_sand_water water;      // of PROPS(15), PROPS(18) and PROPS(19), without views
    double e_0;                 // see grit_classic_void_ratio
    grit_sand_options options;  // those of the library, with the tolerance of PROPS(17)
};

// Prepared, and kept for the next call of the thread: most hosts pass the same PROPS time and again.
// Compared to the last bit, for what lies at their address may change.
grit_status read_props(const double* props, int nprops, const Material*& out, grit_error& error);

// grit_classic_void_ratio, with words where it refuses.
grit_status initial_void_ratio(const Material& material, double p, double& void_ratio,
                               grit_error& error);

}  // namespace grit::abaqus
