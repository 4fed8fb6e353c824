// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx512
#include "contact/many_bodies.hpp"
#include "contact/nodal_correction.hpp"
#include "contact/regression.hpp"
