// SPDX-License-Identifier: BSD-3-Clause
// Which exponents the kernels raise by multiplications and square roots.
#include <gtest/gtest.h>

#include "support/sands.hpp"
#include "umat/model/material.hpp"

namespace {

TEST(Exponent, IsCountedInQuartersWhereItIsAMultipleOfThem) {
    grit_sand_parameters p = tests::parameters_of("hochstetten");
    for (int quarters = 2; quarters <= 16; ++quarters)
        for (const double off : {0.0, 1e-3}) {
            p.stiffness_interpolation_exponent = 0.25 * quarters + off;
            const tests::Sand sand = tests::prepared("sand", p);
            const grit::Exponent chi = grit::material_of(sand.prepared).chi_power;
            EXPECT_EQ(chi.value, 0.25 * quarters + off);
            EXPECT_EQ(chi.quarters, off > 0.0 ? -1 : quarters);
        }
}

}  // namespace
