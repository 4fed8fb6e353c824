// SPDX-License-Identifier: BSD-3-Clause
// Names of the columns of particles, for files and error messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

// As many as the particles of a body of this material, and with this water, have; null: rigid; none: dry.
std::vector<std::string> column_names(const Material* material,
                                      const std::optional<PoreWater>& water = {});

// Besides: the pore pressure as it bears, and total stresses [Pa].
inline constexpr const char* pore_fields[] = {"pore_pressure", "total_rr", "total_zz", "total_tt"};

}  // namespace grit::mpm
