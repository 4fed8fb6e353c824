// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET baseline
#include "adapters/mpm/space/kernel/gather.hpp"
#include "adapters/mpm/space/kernel/scatter.hpp"

namespace grit::mpm::space {
extern const Kernels baseline_kernels;
const Kernels baseline_kernels{baseline::scatter, baseline::gather, baseline::deform_by_mean,
                               baseline::add_mean_stresses};
}  // namespace grit::mpm::space
