// SPDX-License-Identifier: BSD-3-Clause
// What pressures of cells do to nodes, and what velocities of nodes do to the volumes of cells: one the transpose of the other.
#pragma once

#include "adapters/mpm/kernel/pore_water.hpp"
#include "adapters/mpm/kernel/record_lanes.hpp"

GRIT_KERNEL_BEGIN_OF(mpm)

// Four nodes of a row, r and z of each.
using RowOfPatch = Vec8;
GRIT_INLINE RowOfPatch load_row(const double* from) {
    RowOfPatch row;
    __builtin_memcpy(&row, from, sizeof row);
    return row;
}

void push_by_pressures(const PatchCall& call, const double* pressure, double* nodes) {
    for (std::size_t c = 0; c < call.count; ++c) {
        const double* force = call.patches[call.cells[c].patch].force;
        double* at = nodes + 2 * call.cells[c].first;
        for (int j = 0; j < 4; ++j, force += 8, at += 2 * call.row) {
            const RowOfPatch share = pressure[c] * load_row(force);
            const RowOfPatch sum =
                load_row(at) + ((share + call.rounding.magic) - call.rounding.magic);
            __builtin_memcpy(at, &sum, sizeof sum);
        }
    }
}

void find_swelling(const PatchCall& call, const double* nodes, double* swelling) {
    for (std::size_t c = 0; c < call.count; ++c) {
        const double* force = call.patches[call.cells[c].patch].force;
        const double* at = nodes + 2 * call.cells[c].first;
        RowOfPatch sum{};
        for (int j = 0; j < 4; ++j, force += 8, at += 2 * call.row)
            sum += load_row(force) * load_row(at);
        swelling[c] =
            ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
    }
}

GRIT_KERNEL_END
