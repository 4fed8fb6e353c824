// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/compact_flow.hpp"

#include <algorithm>
#include <cmath>

namespace grit::mpm {

namespace {

// A quarter of it, which is the pressure itself where that changes sign from cell to cell.
double second_difference(double before, double here, double behind) {
    return 0.25 * (2.0 * here - before - behind);
}

}  // namespace

CompactFlow::CompactFlow(const GridView& grid, Exchange& processes, bool in_fixed_point)
    : row(static_cast<std::size_t>(grid.nodes_r())), exchange(processes),
      fixed_point(in_fixed_point),
      at_cells((row + 1) + row * (static_cast<std::size_t>(grid.z.cells) + 1)),
      mixed(at_cells.size()), around(mixed.size() - (row + 1)), given(around.size() + 2 * row),
      second(given.size()), compliance_of_five(given.size()), fourth(given.size()),
      least_of_three(given.size()), least_of_five(given.size()), most_of_three(given.size()),
      alternating(given.size()), leaves(given.size()) {}

void CompactFlow::begin(const std::vector<Cell>& now, const std::vector<CompactAnswer>& answers) {
    cells = now;
    std::fill(around.begin(), around.end(), Vector2{});
    for (const Cell& cell : cells)
        if (cell.counted)
            for (const std::size_t node : {std::size_t{0}, std::size_t{1}, row, row + 1}) {
                around[cell.first + node][0] += 1.0;
                around[cell.first + node][1] += cell.bears ? 1.0 : 0.0;
            }
    exchange.sum_nodes(around.data(), static_cast<std::ptrdiff_t>(around.size()));
    // Of a checkerboard of 1 Pa the mixed differences are 4 Pa, of which each of four nodes takes a share.
    for (std::vector<double>* of_nodes : {&to_change, &to_pressure, &to_root})
        of_nodes->resize(answers.size());
    for (std::size_t node = 0; node < answers.size(); ++node) {
        const double to_change_of_four = around[node][0] == 4.0 ? answers[node].to_change : 0.0;
        to_change[node] = to_change_of_four / 16.0;
        to_root[node] = std::sqrt(to_change_of_four) / 16.0;
        to_pressure[node] = around[node][1] == 4.0 ? answers[node].to_pressure / 16.0 : 0.0;
    }
}

// A cell's four nodes have it at the sides + - - + of their differences. Beside a row's last cell, and before its first
// one, is a node without a cell.
void CompactFlow::add(const std::vector<double>& answer, const double* x, double* out) {
    Rounding rounding;
    if (fixed_point) {
        double largest = 0.0;
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (cells[c].counted) largest = std::max(largest, std::fabs(x[c]));
        exchange.max(&largest, 1);
        rounding = Rounding::of_sums(largest, 3);  // a node has four cells
    }
    std::fill(at_cells.begin(), at_cells.end(), 0.0);
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].counted) first_cell()[cells[c].first] = rounding(x[c]);
    const double* here = first_cell();
    const double *left = here - 1, *below = at_cells.data() + 1, *below_left = at_cells.data();
    const std::size_t nodes = answer.size();
    for (std::size_t node = 0; node < nodes; ++node)
        mixed[node] = ((below_left[node] - below[node]) - left[node]) + here[node];
    exchange.sum_nodes(mixed.data(), static_cast<std::ptrdiff_t>(nodes), 1);
    for (std::size_t node = 0; node < nodes; ++node) mixed[node] *= answer[node];
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const double* at = mixed.data() + cells[c].first;
        out[c] += (at[0] - at[1]) - (at[row] - at[row + 1]);
    }
}

// What the process that counts a cell has of it goes to all that have its first node; differences of counted cells need
// that of the next cell beyond a cut. A row's last node is not the first of a cell here, and must not be beside
// the next row's first cell, though others may have a cell there.
template <class Of> void CompactFlow::share(std::vector<Of>& of_cells) {
    static_assert(sizeof(Of) % sizeof(double) == 0);
    exchange.sum_nodes(reinterpret_cast<double*>(of_cells.data() + row),
                       static_cast<std::ptrdiff_t>(around.size()), sizeof(Of) / sizeof(double));
    for (std::size_t last = 2 * row - 1; last < row + around.size(); last += row)
        of_cells[last] = {};
}

// find(cell, k, step): along r and z, of the cell at that place, its neighbours a step from it.
template <class Find> void CompactFlow::find_along(const Find& find) {
    for (const Cell& cell : cells) {
        if (!cell.counted) continue;
        find(row + cell.first, 0, 1);
        find(row + cell.first, 1, row);
    }
}

// Fourth differences B p of five cells in a row, 1, -4, 6, -4, 1 over 16, or of five of them in a row that change sign the least, by the
// least compliance of the five cells, and B of that.
void CompactFlow::add_of_alternating(const double* p, double* out) {
    constexpr double most = 0.9;  // of what alternates along a direction
    part.assign(cells.size(), 0.0);
    add(to_root, p, part.data());
    add(to_root, part.data(), out);

    std::fill(given.begin(), given.end(), Given{});
    std::fill(second.begin(), second.end(), Second{});
    for (std::vector<Vector2>* of_cells :
         {&fourth, &least_of_three, &least_of_five, &most_of_three, &alternating, &leaves})
        std::fill(of_cells->begin(), of_cells->end(), Vector2{});
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].counted)
            given[row + cells[c].first] = {p[c], cells[c].compliance,
                                           cells[c].cavitates ? 1.0 : 0.0};
    share(given);
    find_along([this](std::size_t at, std::size_t k, std::size_t step) {
        const Given &before = given[at - step], &here = given[at], &behind = given[at + step];
        Second& of = second[at];
        of.difference[k] = second_difference(before.pressure, here.pressure, behind.pressure);
        of.least_compliance[k] = std::min({before.compliance, here.compliance, behind.compliance});
        of.cavitates[k] = std::max({before.cavitates, here.cavitates, behind.cavitates});
    });
    share(second);
    find_along([this](std::size_t at, std::size_t k, std::size_t step) {
        const Second &before = second[at - step], &here = second[at], &behind = second[at + step];
        compliance_of_five[at][k] = std::min(
            {before.least_compliance[k], here.least_compliance[k], behind.least_compliance[k]});
        if (compliance_of_five[at][k] > 0.0)
            fourth[at][k] =
                second_difference(before.difference[k], here.difference[k], behind.difference[k]);
    });
    share(fourth);
    find_along([this](std::size_t at, std::size_t k, std::size_t step) {
        const double before = fourth[at - step][k], here = fourth[at][k],
                     behind = fourth[at + step][k];
        least_of_three[at][k] =
            before * here < 0.0 && here * behind < 0.0
                ? std::min({std::fabs(before), std::fabs(here), std::fabs(behind)})
                : 0.0;
    });
    share(least_of_three);
    find_along([this](std::size_t at, std::size_t k, std::size_t step) {
        least_of_five[at][k] = std::min(least_of_three[at - step][k], least_of_three[at + step][k]);
    });
    share(least_of_five);
    find_along([this](std::size_t at, std::size_t k, std::size_t step) {
        most_of_three[at][k] = std::max(
            {least_of_five[at - step][k], least_of_five[at][k], least_of_five[at + step][k]});
    });
    share(most_of_three);
    find_along([this](std::size_t at, std::size_t k, std::size_t step) {
        const bool cavitates =
            second[at - step].cavitates[k] + second[at + step].cavitates[k] > 0.0;
        const double most_of_five =
                         std::max(most_of_three[at - step][k], most_of_three[at + step][k]),
                     here = fourth[at][k];
        alternating[at][k] = most * compliance_of_five[at][k] *
                             (cavitates ? here : std::copysign(most_of_five, here));
    });
    share(alternating);
    find_along([this](std::size_t at, std::size_t k, std::size_t step) {
        leaves[at][k] = second_difference(alternating[at - step][k], alternating[at][k],
                                          alternating[at + step][k]);
    });
    share(leaves);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Vector2* at = leaves.data() + row + cells[c].first;
        out[c] += second_difference((at - 1)[0][0], at[0][0], at[1][0]) +
                  second_difference((at - row)[0][1], at[0][1], at[row][1]);
    }
}

}  // namespace grit::mpm
