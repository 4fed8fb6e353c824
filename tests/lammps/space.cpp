// SPDX-License-Identifier: BSD-3-Clause
// Cases in space: bodies that go from brick to brick, load, meet and turn, with the bits of the driver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <adapters/mpm/space/kernel/particles.hpp>

#include "support/both_hosts.hpp"
#include "support/brick.hpp"

namespace {

namespace c = grit::mpm::space::column;

constexpr long all = 1000000;

double lowest(const Told& told, int column) {
    double least = INFINITY;
    for (const auto& [id, row] : told.points)
        least = std::min(least, row[static_cast<std::size_t>(column)]);
    return least;
}

// From the first sub-domain into the last one, across all borders, on the way all eight have some of it.
TEST(LammpsSpace, HasTheBitsOfTheDriverHoweverTheGridIsCut) {
    const BothHosts hosts(brick_case("4, 3.5, 3.5", "2.4"));
    const Told driver = hosts.in_driver(all);
    ASSERT_GT(driver.rows.size(), 50u);
    EXPECT_GT(lowest(driver, c::x), 11.0);
    EXPECT_GT(lowest(driver, c::y), 9.0);
    EXPECT_GT(lowest(driver, c::z), 9.0);
    for (const auto& bricks : {std::array{1, 1, 1}, std::array{2, 1, 1}, std::array{1, 2, 1},
                               std::array{1, 1, 2}, std::array{2, 2, 1}, std::array{2, 2, 2}})
        EXPECT_EQ(first_difference(driver, hosts.in_lammps(bricks)), "")
            << bricks[0] << ' ' << bricks[1] << ' ' << bricks[2];
}

}  // namespace
