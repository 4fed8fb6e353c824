// SPDX-License-Identifier: BSD-3-Clause
// How processes cut an axis.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include <adapters/lammps/slice.hpp>

namespace {

using grit::lammps::Slice;
using grit::lammps::slices;
using grit::mpm::Axis;
using grit::mpm::AxisView;

Axis graded() {
    std::vector<double> nodes{0.0};
    for (double length = 1.0; nodes.size() < 41; length *= 1.1)
        nodes.push_back(nodes.back() + length);
    return Axis(nodes);
}

const std::vector<double> cuts{0.0, 21.5, 90.0, graded()[40]};

TEST(LammpsSlices, HoldAllNodesThatTheirParticlesReach) {
    const Axis axis = graded();
    const AxisView view = axis.view();
    const double slack = axis.shortest();
    const std::vector<Slice> all = slices(axis, cuts, slack);
    ASSERT_EQ(all.size(), 3u);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const double x : {std::max(cuts[i] - slack, 0.0), cuts[i], cuts[i + 1],
                               std::min(cuts[i + 1] + slack, cuts[3])}) {
            const int cell = view.cell_of(x);
            EXPECT_LE(all[i].first_cell, cell);
            EXPECT_GE(all[i].last_cell, cell);
            EXPECT_LE(all[i].first_node, std::max(cell - 1, 0));
            EXPECT_GE(all[i].last_node, std::min(cell + 2, axis.cells()));
        }
}

// Contact at a node asks for the cell behind it, at the last one too.
TEST(LammpsSlices, SeeTheLimitsOfTheWholeAxisAtAllTheirNodes) {
    const Axis axis = graded();
    for (const Slice& slice : slices(axis, cuts, axis.shortest())) {
        const Axis part = axis.part(slice.first_node, slice.axis_last);
        const auto limit = [](const AxisView& of, int node) {
            return of.limit[std::min(node, of.cells - 1)];
        };
        for (int node = slice.first_node; node <= slice.last_node; ++node)
            EXPECT_EQ(limit(part.view(), node - slice.first_node), limit(axis.view(), node));
    }
}

TEST(LammpsSlices, ShareANodeBetweenTwoAtMost) {
    const Axis axis = Axis::uniform(0.0, 24.0, 24);
    const std::vector<Slice> all = slices(axis, {0.0, 8.5, 14.5, 24.0}, 1.0);
    EXPECT_GT(all[2].first_node, all[0].last_node);
    EXPECT_THROW(slices(axis, {0.0, 8.5, 13.5, 24.0}, 1.0), std::invalid_argument);
}

}  // namespace
