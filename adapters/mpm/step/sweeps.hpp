// SPDX-License-Identifier: BSD-3-Clause
// How much the pressures of a surface contact took, since the program began.
#pragma once

#include <grit/contact_surface.h>

namespace grit::mpm {

struct Sweeps {
    long calls = 0, all = 0;
    long unfinished = 0;  // calls that ended at their limit of sweeps: approaches are left

    void count(const grit_surface_options& options, const grit_surface_totals& totals) {
        ++calls;
        all += totals.sweeps;
        unfinished += totals.sweeps >= options.sweep_limit ? 1 : 0;
    }
};

}  // namespace grit::mpm
