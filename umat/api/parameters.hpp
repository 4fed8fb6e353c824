// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <grit/sand.h>

#include "umat/model/material.hpp"

namespace grit {

// Validate parameters of this version and derive the constants of (H4), (H8).
grit_status prepare(const grit_sand_parameters& parameters, Material& material, grit_error* error);

}  // namespace grit
