// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/column_names.hpp"

namespace grit::mpm {

std::vector<std::string> column_names(const Material* material) {
    std::vector<std::string> out{"r",    "z",    "v_r",  "v_z", "F_rr", "F_rz", "F_zr",
                                 "F_zz", "F_tt", "l_r",  "l_z", "mass", "V0",   "S_rr",
                                 "S_zz", "S_tt", "S_rz", "b_r", "b_z",  "q"};
    if (material)
        for (const char* name : material->own_column_names()) out.emplace_back(name);
    return out;
}

}  // namespace grit::mpm
