// SPDX-License-Identifier: BSD-3-Clause
// A node's record and half of one are a vector each, read and added to where they lie.
#pragma once

#include "support/lanes.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

using Vec2 = grit::GRIT_TARGET::VectorTypes<2>::RealInPlace;
using Vec4 = grit::GRIT_TARGET::VectorTypes<4>::RealInPlace;
using Vec8 = grit::GRIT_TARGET::VectorTypes<8>::RealInPlace;

GRIT_KERNEL_END
