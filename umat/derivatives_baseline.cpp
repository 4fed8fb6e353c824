// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET baseline
#include "umat/batch/differentiated_points.hpp"
