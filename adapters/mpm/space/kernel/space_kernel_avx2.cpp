// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx2
#include "adapters/mpm/space/kernel/gather.hpp"
#include "adapters/mpm/space/kernel/scatter.hpp"

namespace grit::mpm::space {
extern const Kernels avx2_kernels;
const Kernels avx2_kernels{avx2::scatter, avx2::gather, avx2::deform_by_mean,
                           avx2::add_mean_stresses};
}  // namespace grit::mpm::space
