// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/picture.hpp"

namespace cli {

// A line of a few thousand points that looks the same: points too close to see are left out, turns in x
// are kept; where that is not enough, of many loops every second, third, ... is left, the first and the
// last in any case.
Series thinned(Series line);

// Points far enough apart to leave a line visible between them.
Series spaced(const Series& points);

}  // namespace cli
