// SPDX-License-Identifier: BSD-3-Clause
// Names of the columns of particles, for files and error messages.
#pragma once

#include <string>
#include <vector>

#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

// As many as the particles of a body of this material, and with this water, have; null: rigid, without it.
std::vector<std::string> column_names(const Material* material, const PoreWater* water = nullptr);

// Besides: the pore pressure as it bears, and total stresses [Pa].
inline constexpr const char* pore_fields[] = {"pore_pressure", "total_rr", "total_zz", "total_tt"};

}  // namespace grit::mpm
