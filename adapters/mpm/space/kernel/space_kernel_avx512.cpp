// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET avx512
#include "adapters/mpm/space/kernel/gather.hpp"
#include "adapters/mpm/space/kernel/scatter.hpp"

namespace grit::mpm::space {
extern const Kernels avx512_kernels;
const Kernels avx512_kernels{avx512::scatter, avx512::gather, avx512::deform_by_mean,
                             avx512::add_mean_stresses};
}  // namespace grit::mpm::space
