// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/column_names.hpp"

namespace grit::mpm {

std::vector<std::string> column_names(const Material* material,
                                      const std::optional<PoreWater>& water) {
    std::vector<std::string> out(std::begin(column::names), std::end(column::names));
    if (material)
        for (const char* name : material->own_column_names()) out.emplace_back(name);
    if (water)
        for (const char* name : water->column_names()) out.emplace_back(name);
    return out;
}

}  // namespace grit::mpm
