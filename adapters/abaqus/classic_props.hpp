// SPDX-License-Identifier: BSD-3-Clause
// PROPS in the classic layout (docs/umat.md): the material, the pore water, the initial void ratio.
#pragma once

#include <grit/classic_layout.h>

namespace grit::abaqus {

struct ClassicProps {
    grit_sand_parameters parameters;  // initialised; without intergranular strain if m_R <= 0.5
    double K_w;                       // [stress] of the mixture (W1); 0: drained
    double e_0;                       // see grit_classic_void_ratio
};

grit_status read_props(const double* props, ClassicProps& out, grit_error& error);

// grit_classic_void_ratio, with words where it refuses.
grit_status initial_void_ratio(const grit_sand& sand, double e_0, double p, double& void_ratio,
                               grit_error& error);

}  // namespace grit::abaqus
