// SPDX-License-Identifier: BSD-3-Clause
#include "cli/sand/parameter_units.hpp"

namespace cli {

Unit unit_of(const grit_sand_parameter_info& info) {
    const std::string unit = info.unit;
    if (unit == "rad") return {"deg", degree};
    if (unit == "stress") return {"kPa", 1.0};
    return {unit, 1.0};
}

std::string parameter_key(const grit_sand_parameter_info& info) {
    const std::string unit = unit_of(info).name;
    return unit == "-" ? info.name : std::string(info.name) + "_" + unit;
}

}  // namespace cli
