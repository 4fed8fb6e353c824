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

GRIT_INLINE double sum_of(const RowOfPatch& x) {
    return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
}

// The nodes of a row that cells beside each other reach: the first of the next cell is the second of this one. In registers, for
// what one cell stores another one reads, half a row farther on.
struct MovingRow {
    RowOfPatch sum{};
    double* at;

    GRIT_INLINE explicit MovingRow(double* from) : at(from) {}
    GRIT_INLINE void leave_node() {
        at[0] += sum[0];
        at[1] += sum[1];
        at += 2;
        sum = RowOfPatch{sum[2], sum[3], sum[4], sum[5], sum[6], sum[7], 0.0, 0.0};
    }
};

void push_by_pressures(const PatchCall& call, const double* pressure, double* nodes) {
    const double magic = call.rounding.magic;
    for (std::size_t c = 0; c < call.count;) {
        double* const from = nodes + 2 * call.cells[c].first;
        const std::size_t row = 2 * call.row;
        MovingRow rows[] = {MovingRow(from), MovingRow(from + row), MovingRow(from + 2 * row),
                            MovingRow(from + 3 * row)};
        bool goes_on = true;
        for (; goes_on; ++c) {
            const double* force = call.patches[call.cells[c].patch].force;
            for (MovingRow& to : rows) {
                const RowOfPatch share = pressure[c] * load_row(force);
                to.sum += (share + magic) - magic;
                to.leave_node();
                force += 8;
            }
            goes_on = c + 1 < call.count && call.cells[c + 1].first == call.cells[c].first + 1;
        }
        for (MovingRow& to : rows)
            for (int k = 0; k < 3; ++k) to.leave_node();
    }
}

void find_swelling(const PatchCall& call, const double* nodes, double* swelling) {
    for (std::size_t c = 0; c < call.count; ++c) {
        const double* force = call.patches[call.cells[c].patch].force;
        const double* at = nodes + 2 * call.cells[c].first;
        RowOfPatch sum{};
        for (int j = 0; j < 4; ++j, force += 8, at += 2 * call.row)
            sum += load_row(force) * load_row(at);
        swelling[c] = sum_of(sum);
    }
}

void find_own_swelling(const PatchCall& call, const NodeAnswer* nodes, double* swelling) {
    static_assert(sizeof(NodeAnswer) == 3 * sizeof(double));
    for (std::size_t c = 0; c < call.count; ++c) {
        const double* force = call.patches[call.cells[c].patch].force;
        const NodeAnswer* at = nodes + call.cells[c].first;
        RowOfPatch sum{};
        for (int j = 0; j < 4; ++j, force += 8, at += call.row) {
            const RowOfPatch f = load_row(force);
            // Of rr, rz, zz of four nodes, twelve numbers, the first eight and those from the fifth on.
            const RowOfPatch low = load_row(&at->rr), high = load_row(&at[1].rz);
            const RowOfPatch along = __builtin_shufflevector(low, high, 0, 2, 3, 5, 6, 12, 13, 15);
            const RowOfPatch across = __builtin_shufflevector(low, high, 1, 1, 4, 4, 7, 7, 14, 14);
            const RowOfPatch other = __builtin_shufflevector(f, f, 1, 0, 3, 2, 5, 4, 7, 6);
            sum += f * (along * f + across * other);
        }
        swelling[c] = sum_of(sum);
    }
}

GRIT_KERNEL_END
