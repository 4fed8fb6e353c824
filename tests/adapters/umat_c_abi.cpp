// SPDX-License-Identifier: BSD-3-Clause
// The UMAT adds nothing to the library and takes nothing away: the same bits.
#include <grit/grit.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/umat_call.hpp"

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

grit_sand hochstetten_sand(bool igs) {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    p.critical_friction_angle = 33.0 * degree;
    p.granulate_hardness = 1e6;
    p.stiffness_exponent = 0.25;
    p.densest_void_ratio = 0.55;
    p.critical_void_ratio = 0.95;
    p.loosest_void_ratio = 1.05;
    p.pyknotropy_exponent = 0.25;
    p.stiffness_void_exponent = 1.5;
    if (igs) {
        p.reversal_stiffness = 5.0;
        p.transverse_stiffness = 2.0;
        p.elastic_strain_radius = 1e-4;
        p.evolution_exponent = 0.5;
        p.stiffness_interpolation_exponent = 6.0;
    }
    grit_sand sand;
    EXPECT_EQ(grit_sand_prepare(&p, &sand, nullptr), GRIT_OK);
    return sand;
}

struct LibraryPoint {
    double stress[6] = {-100, -100, -100, 0, 0, 0};
    double state[GRIT_SAND_STATE_SIZE] = {0, 0, 0, 0, 0, 0, 10.70 - 10.0, 0};
    double tangent[36] = {};
    double substep = 0.0;
    grit_sand_report report{};

    void update(const grit_sand& sand, const double* strain) {
        grit_sand_options options;
        grit_sand_options_init(&options, sizeof options);
        options.tangent = GRIT_TANGENT_CONSISTENT;
        grit_sand_points q{};
        q.struct_size = sizeof q;
        q.strain_increment = grit_view_of(strain, 6, 1);
        q.stress = grit_mutable_view_of(stress, 6, 1);
        q.state = grit_mutable_view_of(state, GRIT_SAND_STATE_SIZE, 1);
        q.tangent = grit_mutable_matrix_view_of(tangent, 36, 1, 6);  // Fortran's order
        q.substep = grit_mutable_view_of(&substep, 1, 1);
        ASSERT_EQ(grit_sand_update(&sand, &options, 1, &q, &report, nullptr), GRIT_OK);
    }
};

void expect_same(const UmatCall& umat, const LibraryPoint& library) {
    for (int c = 0; c < 6; ++c) EXPECT_EQ(umat.stress[c], library.stress[c]) << c;
    for (int c = 0; c < 6; ++c) EXPECT_EQ(umat.statev[c], library.state[c]) << c;
    EXPECT_EQ(umat.statev[6], library.state[GRIT_SAND_VOID_RATIO]);
    EXPECT_EQ(umat.statev[9], library.report.evaluations);
    EXPECT_EQ(umat.statev[12], library.substep);
    EXPECT_EQ(umat.statev[13], library.state[GRIT_SAND_SEPARATION]);
    for (int i = 0; i < 36; ++i) EXPECT_EQ(umat.ddsdde[i], library.tangent[i]) << i;
}

// Compression, shear in all planes, reversal, and opening until the point separates.
constexpr double path[][6] = {{-1e-3, 2e-4, 1e-4, 3e-4, -2e-4, 5e-4},
                              {-1e-6, 0, 0, 2e-6, 0, 0},
                              {1e-4, 0, 0, 0, -1e-4, 0},
                              {0, 0, 0, 0, 0, 0},
                              {2e-2, 1e-2, 1e-2, 0, 0, 1e-3},
                              {-3e-2, -2e-2, -2e-2, 0, 0, 0}};

TEST(UmatAgainstCAbi, GivesTheSameBitsAlongAPath) {
    const grit_sand sand = hochstetten_sand(true);
    UmatCall umat = UmatCall::hochstetten();
    LibraryPoint library;
    for (const auto& d : path) {
        umat.set_dstran(d[0], d[1], d[2], d[3], d[4], d[5]);
        umat.run();
        ASSERT_EQ(umat.pnewdt, 1.0);
        library.update(sand, d);
        expect_same(umat, library);
        EXPECT_TRUE(umat.in_bounds());
    }
}

TEST(UmatAgainstCAbi, SwitchesIntergranularStrainOffBySmallM_R) {
    const grit_sand sand = hochstetten_sand(false);
    UmatCall umat = UmatCall::hochstetten();
    umat.props[9] = 0.5;
    for (int i = 10; i < 14; ++i) umat.props[i] = 0.0;  // not looked at
    LibraryPoint library;
    for (const auto& d : path) {
        umat.set_dstran(d[0], d[1], d[2], d[3], d[4], d[5]);
        umat.run();
        ASSERT_EQ(umat.pnewdt, 1.0);
        library.update(sand, d);
        expect_same(umat, library);
        EXPECT_EQ(umat.statev[11], 0.0) << "rho";
    }
}

TEST(UmatAgainstCAbi, ReportsPressureMobilisedAngleAndRho) {
    const grit_sand sand = hochstetten_sand(true);
    UmatCall umat = UmatCall::hochstetten();
    LibraryPoint library;
    umat.set_dstran(-1e-3, 2e-4, 1e-4, 3e-4, -2e-4, 5e-4);
    umat.run();
    library.update(sand, umat.dstran.data());
    grit_sand_invariants expected{};
    expected.struct_size = sizeof expected;
    grit_sand_invariants_of(&sand, library.stress, library.state, &expected);
    EXPECT_EQ(umat.statev[8], expected.p);
    EXPECT_DOUBLE_EQ(umat.statev[10], expected.mobilised_friction_angle / degree);
    EXPECT_EQ(umat.statev[11], expected.rho);
    EXPECT_GT(umat.statev[10], 1.0);
    EXPECT_GT(umat.statev[11], 0.9);
}

void expect_block_of(const UmatCall& full, const UmatCall& part) {
    for (int r = 0; r < part.ntens; ++r) {
        EXPECT_EQ(part.stress[r], full.stress[r]);
        for (int c = 0; c < part.ntens; ++c) EXPECT_EQ(part.tangent(r, c), full.tangent(r, c));
    }
    EXPECT_EQ(part.statev, full.statev);
    EXPECT_TRUE(part.in_bounds());
}

TEST(UmatAgainstCAbi, GivesFourAndThreeComponentsTheBitsOfSix) {
    for (const int n : {4, 3}) {
        UmatCall full = UmatCall::hochstetten();
        UmatCall part = full;
        part.use_components(n);
        for (int i = 0; i < 20; ++i) {
            const double sign = i < 10 ? 1.0 : -0.3;
            full.set_dstran(-2e-4 * sign, 5e-5, 1e-5 * sign, n == 4 ? 3e-4 * sign : 0.0);
            part.set_dstran(-2e-4 * sign, 5e-5, 1e-5 * sign, 3e-4 * sign);
            full.run();
            part.run();
            ASSERT_EQ(part.pnewdt, 1.0);
            expect_block_of(full, part);
        }
    }
}

TEST(UmatAgainstCAbi, LeavesBitsAloneInAZeroIncrement) {
    UmatCall call = UmatCall::hochstetten();
    call.set_dstran(-1e-3, 2e-4, 1e-4, 3e-4, -2e-4, 5e-4);
    call.run();
    const UmatCall before = call;
    call.set_dstran(0, 0, 0);
    call.run();
    EXPECT_EQ(call.stress, before.stress);
    for (const int i : {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13})
        EXPECT_EQ(call.statev[i], before.statev[i]) << i;
}

}  // namespace
