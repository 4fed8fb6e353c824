// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx2
#include "umat/batch/differentiated_points.hpp"
