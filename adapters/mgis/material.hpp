// SPDX-License-Identifier: BSD-3-Clause
// The material properties of a behaviour: PROPS of the classic layout, by name.
#pragma once

#include <grit/sand_water.h>

#include "adapters/mgis/parameters.hpp"

namespace grit::mgis {

struct Material {
    grit_sand sand;
    double elastic_factor;  // m_R, 1 without intergranular strain: the elastic operator is m_R L
    grit_sand_water water;  // of WaterStiffness and the parameters, without views
    double e_0;             // see grit_classic_void_ratio
};

grit_status read_material(const double* properties, const Parameters& set, Material& out,
                          grit_error& error);

// Where void_ratio says that the host has not set it, the one that e_0 gives at the pressure p.
grit_status complete_void_ratio(const Material& material, double p, double& void_ratio,
                                grit_error& error);

}  // namespace grit::mgis
