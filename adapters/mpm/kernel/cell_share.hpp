// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "adapters/mpm/kernel/call.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Of a sum in CellIntegers. Rounded towards zero; what is no number stays out.
GRIT_INLINE std::int64_t cell_share(double x) {
    return x > -1.0 && x < 1.0 ? static_cast<std::int64_t>(x * CellIntegers::scale) : 0;
}

GRIT_KERNEL_END
