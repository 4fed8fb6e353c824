// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx2
#include "adapters/mpm/kernel/cell_patches.hpp"
#include "adapters/mpm/kernel/gather.hpp"
#include "adapters/mpm/kernel/scatter.hpp"

namespace grit::mpm {
extern const Kernels avx2_kernels;
const Kernels avx2_kernels{
    avx2::scatter,           avx2::gather,        avx2::deform_by_mean,   avx2::add_mean_stresses,
    avx2::push_by_pressures, avx2::find_swelling, avx2::find_own_swelling};
}  // namespace grit::mpm
