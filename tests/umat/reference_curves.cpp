// SPDX-License-Identifier: BSD-3-Clause
// Exact responses to piecewise linear strain paths (long double, Dormand-Prince at 1e-13), row by
// row.
#include "../larger.hpp"
#include "support/tables/csv.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

enum Column { strain = 1, stress = 7, void_ratio = 13, memory = 14 };

struct Worst {
    double stress = 0.0, h = 0.0, e = 0.0;
};

Worst worst_along(const std::string& file, double tolerance) {
    const Sand sand = sand_named("lausitz");
    const auto rows =
        grit::csv::read_numbers(GRIT_DATA "/reference/strain_driven_" + file + ".csv").rows;
    EXPECT_GE(rows.size(), 200u);
    State x{stress_from(&rows[0][stress]), strain_from(&rows[0][memory]), rows[0][void_ratio]};
    Worst worst;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const Vec dE = strain_from(&rows[i][strain]) - strain_from(&rows[i - 1][strain]);
        x = updated(sand, x, dE, options_with(tolerance));
        const Vec T = stress_from(&rows[i][stress]);
        worst.stress = larger(worst.stress, (x.T - T).norm() / T.norm());
        worst.h = larger(worst.h, (x.h - strain_from(&rows[i][memory])).norm() / 1e-4);
        worst.e = larger(worst.e, std::fabs(x.e - rows[i][void_ratio]));
    }
    return worst;
}

void expect_curve(const std::string& file) {
    const Worst standard = worst_along(file, options_with().tolerance);
    EXPECT_LE(standard.stress, 1e-4);
    EXPECT_LE(standard.h, 1e-4);
    EXPECT_LE(standard.e, 1e-11);
    const Worst tight = worst_along(file, 1e-12);
    EXPECT_LE(tight.stress, 1e-6);
    EXPECT_LE(tight.h, 1e-6);
    EXPECT_LE(tight.e, 1e-11);
}

TEST(ReferenceCurve, IsotropicCompressionFromNoMemory) { expect_curve("a_iso_lausitz_dzero"); }
TEST(ReferenceCurve, DrainedTriaxialCompression) { expect_curve("c_txd_lausitz_p100_e0.55"); }
TEST(ReferenceCurve, UndrainedCycles) { expect_curve("e_cycu_lausitz_a1e-03"); }
TEST(ReferenceCurve, PathInAllSixComponents) { expect_curve("g_3d_lausitz"); }

}  // namespace
