// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/plot/picture.hpp"

namespace cli {

// A line of far fewer points that looks the same: points that others draw the line through are left
// out, and where that is not enough, stretches that lie on others. Both lines pass each other's points
// within less than 1/300 of the picture along each axis.
Series thinned(const Series& line, bool log_x = false);

// Points far enough apart to leave a line visible between them.
Series spaced(const Series& points, bool log_x = false);

}  // namespace cli
