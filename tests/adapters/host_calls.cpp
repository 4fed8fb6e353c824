// SPDX-License-Identifier: BSD-3-Clause
// How two hosts call a UMAT, replayed: the arguments they leave null or unset, the states they start
// from, what they repeat, and how they learn of a failure. A third: opensees.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/library.hpp"
#include "support/umat_call.hpp"

extern "C" {
// Kratos and MOOSE call without the hidden length of CMNAME.
typedef void (*UmatWithoutLength)(double*, double*, double*, double*, double*, double*, double*,
                                  double*, double*, double*, const double*, const double*,
                                  const double*, const double*, const double*, const double*,
                                  const double*, const double*, const char*, const int*, const int*,
                                  const int*, const int*, const double*, const int*, const double*,
                                  const double*, double*, const double*, const double*,
                                  const double*, const int*, const int*, const int*, const int*,
                                  const int*, const int*);
}

namespace {

using Six = std::array<double, 6>;

const std::vector<double> props = {33.0, 0.0, 1e6, 0.25, 0.55, 0.95, 1.05, 0.25,
                                   1.5,  5.0, 2.0, 1e-4, 0.5,  6.0,  0.0,  10.70};

UmatWithoutLength function(const char* name, const char* library = GRIT_UMAT_LIBRARY) {
    return reinterpret_cast<UmatWithoutLength>(symbol_of(library, name));
}

constexpr Six k0 = {-100, -50, -50, 0, 0, 0};

// 11 22 33 12 13 23 in 11 22 33 12 23 13, and back.
Six exchanged(const Six& x) { return {x[0], x[1], x[2], x[3], x[5], x[4]}; }

// Kratos: a small-strain law in the order 11 22 33 12 23 13 that keeps what was finalised, and goes back to it before every call. It
// calls once for the stress and once more for the matrix in each iteration.
struct Kratos {
    Six finalised_stress{}, stress{}, finalised_strain{}, matrix[6] = {};
    std::vector<double> finalised = std::vector<double>(14, 0.0), statev;
    bool is_fortran;
    UmatWithoutLength umat;

    explicit Kratos(bool fortran, const char* library = GRIT_UMATK_LIBRARY)
        : is_fortran(fortran), umat(function(fortran ? "umat_" : "umat", library)) {}

    void call(const Six& strain) {
        const int ndi = 3, nshr = 3, ntens = 6, nstatv = 14, nprops = 16, element = 0, point = 0,
                  step = 1, iteration = 1;
        const double time = 0.0, delta_time = 0.1;
        double sse = std::numeric_limits<double>::quiet_NaN(), spd = sse, scd = sse;  // never set
        const char name = '\xcd';                                                     // nor this
        Six delta;
        for (std::size_t c = 0; c < 6; ++c) delta[c] = strain[c] - finalised_strain[c];
        stress = finalised_stress;
        statev = finalised;
        umat(stress.data(), statev.data(), matrix[0].data(), &sse, &spd, &scd, nullptr, nullptr,
             nullptr, nullptr, finalised_strain.data(), delta.data(), &time, &delta_time, nullptr,
             nullptr, nullptr, nullptr, &name, &ndi, &nshr, &ntens, &nstatv, props.data(), &nprops,
             nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &element, &point, nullptr,
             nullptr, &step, &iteration);
    }
    // As CopyConstitutiveMatrix reads it.
    double D(std::size_t i, std::size_t j) const {
        return is_fortran ? matrix[j][i] : matrix[i][j];
    }
    void finalise(const Six& strain) {
        finalised_stress = stress;
        finalised = statev;
        finalised_strain = strain;
    }
};

TEST(HostCalls, OfKratosGiveWhatTheUsualCallsGiveInItsOrder) {
    const std::vector<Six> increments = {{-2e-4, 5e-5, 0, 1e-4, 3e-5, -7e-5},
                                         {1e-4, 0, 1e-5, -3e-5, 0, 2e-5}};
    const UmatCall expected = UmatCall::after(k0, increments);
    constexpr std::size_t order[6] = {0, 1, 2, 3, 5, 4};
    for (const bool fortran : {true, false}) {
        Kratos kratos(fortran);
        kratos.call({});  // at zero stress, zero STATEV
        for (std::size_t c = 0; c < 6; ++c) {
            EXPECT_EQ(kratos.stress[c], 0.0);
            EXPECT_GT(kratos.matrix[c][c], 0.0);
        }
        kratos.finalised_stress = k0;  // then the initial stress arrives
        Six strain{};
        for (const Six& increment : increments) {
            const Six d = exchanged(increment);
            Six end = strain, off = strain;
            for (std::size_t c = 0; c < 6; ++c) {
                end[c] += d[c];
                off[c] += 1.7 * d[c];
            }
            for (const Six& iteration : {off, end}) {
                kratos.call(iteration);
                kratos.call(iteration);
            }
            kratos.finalise(end);
            strain = end;
        }
        for (int c = 0; c < 6; ++c) {
            const std::size_t at = order[c];
            EXPECT_NEAR(kratos.stress[at], expected.stress[c], 1e-9) << c;
            for (int r = 0; r < 6; ++r)
                EXPECT_NEAR(kratos.D(order[r], at), expected.tangent(r, c), 1e-4);
            EXPECT_NEAR(kratos.statev[static_cast<std::size_t>(c)], expected.statev[c], 1e-12);
        }
        EXPECT_NEAR(kratos.statev[6], expected.statev[6], 1e-14);
    }
}

// The same through the library of another order is another material: 13 and 23 change places.
TEST(HostCalls, OfKratosNeedTheLibraryOfItsOrderInSpaceAndNotInThePlane) {
    for (const bool plane : {true, false}) {
        const Six d = {-2e-4, 5e-5, 0, 1e-4, plane ? 0.0 : 3e-5, plane ? 0.0 : -7e-5};
        Kratos own(true), other(true, GRIT_UMAT_LIBRARY);
        for (Kratos* kratos : {&own, &other}) {
            kratos->finalised_stress = k0;
            kratos->call(d);
        }
        EXPECT_EQ(own.stress[0] == other.stress[0], plane);
    }
}

// Kratos has no PNEWDT: a failure is a line on stderr and an answer that has not moved.
TEST(HostCalls, OfKratosAreToldOfAFailureOnStderr) {
    unload(GRIT_UMATK_LIBRARY);
    Kratos kratos(true);
    kratos.finalised_stress = k0;
    testing::internal::CaptureStderr();
    kratos.call({-0.9, 0, 0, 0, 0, 0});
    EXPECT_NE(testing::internal::GetCapturedStderr().find("element 0, point 0"), std::string::npos);
    EXPECT_EQ(kratos.stress, k0);
}

// MOOSE: STATEV all zero, the old values handed over in every residual, PNEWDT at the largest double,
// by which it multiplies its time step, -1 for layers, 80 blanks; SSE is not set before a call, and DDSDDE is
// read by rows.
struct Moose {
    Six old_stress{}, stress{};
    std::vector<double> old_statev = std::vector<double>(14, 0.0), statev;
    std::vector<double> jacobian = std::vector<double>(36, 0.0);
    double pnewdt = 0.0, elastic = 0.0;

    void call(const Six& dstran, double dtime) {
        const int ndi = 3, nshr = 3, ntens = 6, nstatv = 14, nprops = 16, none = -1, one = 1;
        const double time[2] = {0.0, 0.0}, celent = 1.0, coords[3] = {}, temperature = 0.0;
        double plastic = 0.0, creep = 0.0, rpl = 0.0, drpldt = 0.0, ddsddt[6], drplde[6];
        std::vector<double> predef;
        char name[80];
        std::fill(std::begin(name), std::end(name), ' ');
        stress = old_stress;
        statev = old_statev;
        std::fill(jacobian.begin(), jacobian.end(), 0.0);
        pnewdt = std::numeric_limits<double>::max();
        const Six stran{};
        function("umat_", GRIT_UMATM_LIBRARY)(
            stress.data(), statev.data(), jacobian.data(), &elastic, &plastic, &creep, &rpl, ddsddt,
            drplde, &drpldt, stran.data(), dstran.data(), time, &dtime, &temperature, &temperature,
            predef.data(), predef.data(), name, &ndi, &nshr, &ntens, &nstatv, props.data(), &nprops,
            coords, identity, &pnewdt, &celent, identity, identity, &one, &one, &none, &none, &one,
            &one);
    }
    double jacobian_mult(std::size_t i, std::size_t j) const { return jacobian[6 * i + j]; }
    void advance() {
        old_stress = stress;
        old_statev = statev;
    }
};

TEST(HostCalls, OfMooseStartFromZeroAndKeepTheirLargePnewdt) {
    const std::vector<Six> increments = {{-2e-4, 5e-5, 0, 1e-4, 3e-5, -7e-5},
                                         {1e-4, 0, 1e-5, -3e-5, 0, 2e-5}};
    const UmatCall expected = UmatCall::after(k0, increments);
    Moose moose;
    moose.call({}, 0.0);  // the first residual: no strain, no time, no stress, no state
    EXPECT_EQ(moose.pnewdt, std::numeric_limits<double>::max());
    for (int c = 0; c < 6; ++c) EXPECT_GT(moose.jacobian[static_cast<std::size_t>(7 * c)], 0.0);
    EXPECT_EQ(moose.statev[6], 10.70 - 10.0) << "from PROPS(16)";
    moose.old_stress = k0;
    for (const Six& d : increments) {
        for (int residual = 0; residual < 3; ++residual) moose.call(d, 0.1);
        EXPECT_EQ(moose.pnewdt, std::numeric_limits<double>::max());
        moose.advance();
    }
    for (int c = 0; c < 6; ++c)
        EXPECT_EQ(moose.stress[static_cast<std::size_t>(c)], expected.stress[c]) << c;
    double skew = 0.0;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            EXPECT_EQ(moose.jacobian_mult(static_cast<std::size_t>(i), static_cast<std::size_t>(j)),
                      expected.tangent(i, j));
            skew = std::max(skew, std::abs(expected.tangent(i, j) - expected.tangent(j, i)));
        }
    EXPECT_GT(skew, 0.0);  // or nobody would notice
    EXPECT_TRUE(std::isfinite(moose.elastic));
}

TEST(HostCalls, OfMooseAreToldHowMuchShorterTheStepMustBe) {
    Moose moose;
    moose.old_stress = k0;
    moose.call({-0.5, 0, 0, 0, 0, 0}, 1.0);
    EXPECT_GT(moose.pnewdt, 0.0);
    EXPECT_LT(moose.pnewdt, 1.0);
    EXPECT_EQ(moose.stress, k0);
}

}  // namespace
