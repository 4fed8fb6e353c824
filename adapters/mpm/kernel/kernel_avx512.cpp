// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx512
#include "adapters/mpm/kernel/cell_patches.hpp"
#include "adapters/mpm/kernel/gather.hpp"
#include "adapters/mpm/kernel/scatter.hpp"

namespace grit::mpm {
extern const Kernels avx512_kernels;
const Kernels avx512_kernels{avx512::scatter,           avx512::gather,
                             avx512::deform_by_mean,    avx512::add_mean_stresses,
                             avx512::push_by_pressures, avx512::find_swelling,
                             avx512::find_own_swelling};
}  // namespace grit::mpm
