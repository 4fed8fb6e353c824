// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx512
#include "umat/batch/differentiated_points.hpp"
