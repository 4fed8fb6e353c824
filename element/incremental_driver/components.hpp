// SPDX-License-Identifier: BSD-3-Clause
// The line that names the variables, and the six lines "ifstress ..." behind it.
#pragma once

#include "element/control.hpp"
#include "element/incremental_driver/lines.hpp"

namespace incremental_driver {

// *Cartesian, *Roscoe, *RoscoeIsomorph or *Rendulic. Throws BadInput.
element::Variables read_variables(Lines& lines);

// Line of component i = 0 ... 5, to be read on.
Fields component_line(Lines& lines, int i);

// ifstress: 1 stress, 0 strain.
element::Control read_control(Fields& fields);

}  // namespace incremental_driver
