// SPDX-License-Identifier: BSD-3-Clause
#define GRIT_TARGET baseline
#include "adapters/mpm/kernel/cell_patches.hpp"
#include "adapters/mpm/kernel/gather.hpp"
#include "adapters/mpm/kernel/scatter.hpp"

namespace grit::mpm {
extern const Kernels baseline_kernels;
const Kernels baseline_kernels{baseline::scatter,           baseline::gather,
                               baseline::deform_by_mean,    baseline::add_mean_stresses,
                               baseline::push_by_pressures, baseline::find_swelling,
                               baseline::find_own_swelling};
}  // namespace grit::mpm
