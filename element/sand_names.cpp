// SPDX-License-Identifier: BSD-3-Clause
#include "element/sand_names.hpp"

#include <grit/grit.h>

namespace element {

std::vector<std::string> sand_names() {
    std::vector<std::string> names;
    for (int i = 0; i < grit_sand_record_count(); ++i)
        names.emplace_back(grit_sand_record_at(i)->name);
    return names;
}

}  // namespace element
