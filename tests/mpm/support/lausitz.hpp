// SPDX-License-Identifier: BSD-3-Clause
// Lausitz sand of the catalogue, in Pa.
#pragma once

#include <adapters/mpm/kernel/sand.hpp>

#include "../../catalogue.hpp"
#include "support/box.hpp"

namespace mpm_test {

inline grit_sand lausitz() { return catalogue_sand("lausitz", 1000.0); }
inline grit_sand_options sand_options() { return options_with_tolerance(1e-3); }

}  // namespace mpm_test
