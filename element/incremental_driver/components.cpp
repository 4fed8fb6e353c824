// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/components.hpp"

#include "element/text.hpp"

namespace incremental_driver {

element::Variables read_variables(Lines& lines) {
    const std::string what = "*Cartesian, *Roscoe, *RoscoeIsomorph or *Rendulic";
    const Line& line = lines.next(what);
    const std::string name = Fields(lines, line).word().value_or("");
    if (name == "*Cartesian") return element::Variables::cartesian;
    if (name == "*Roscoe") return element::Variables::roscoe;
    if (name == "*RoscoeIsomorph") return element::Variables::roscoe_isomorph;
    if (name == "*Rendulic") return element::Variables::rendulic;
    lines.fail(line.number, "expected " + what + ", got \"" + name + "\"");
}

Fields component_line(Lines& lines, int i) {
    return {lines, lines.next(element::text("component %d of 6", i + 1))};
}

element::Control read_control(Fields& fields) {
    return fields.whole("ifstress (1 stress, 0 strain)", 0, 1) == 1 ? element::Control::stress
                                                                    : element::Control::strain;
}

}  // namespace incremental_driver
