// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx2
#include "contact/nodal/many_correction.hpp"
#include "contact/nodal/pair_correction.hpp"
#include "contact/normals/regression.hpp"
