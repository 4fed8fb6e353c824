// SPDX-License-Identifier: BSD-3-Clause
// PROPS(17), the tolerance of the stress: what is refused, what is the default, what is delivered.
#include <grit/sand.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "support/umat_call.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Percents of strain: with less, the default is as good as any other.
constexpr double increments[][6] = {{-1e-2, 2e-3, 3e-3, 4e-3, -3e-3, 2e-3},
                                    {0, -1e-2, 6e-3, 0, 5e-3, 0},
                                    {3e-3, 3e-3, -9e-3, 1e-2, 0, 0},
                                    {-5e-3, -5e-3, -5e-3, 0, 0, 8e-3}};

UmatCall loaded(const double (&d)[6] = increments[0]) {
    UmatCall call = UmatCall::hochstetten();
    for (int c = 0; c < 3; ++c) call.statev[c] = -3e-5;
    call.set_dstran(d[0], d[1], d[2], d[3], d[4], d[5]);
    return call;
}

UmatCall answer_to(UmatCall call) {
    call.run();
    EXPECT_EQ(call.pnewdt, 1.0);
    EXPECT_TRUE(call.in_bounds());
    return call;
}

UmatCall answer(double tolerance, const double (&d)[6] = increments[0]) {
    UmatCall call = loaded(d);
    call.set_tolerance(tolerance);
    return answer_to(call);
}

std::string refusal_of(double tolerance) {
    UmatCall call = loaded();
    call.set_tolerance(tolerance);
    const UmatCall before = call;
    std::string said = call.complaint();
    EXPECT_GT(call.pnewdt, 0.0);
    EXPECT_LT(call.pnewdt, 1.0);
    EXPECT_TRUE(call.same_results(before));
    EXPECT_EQ(call.energy[0], before.energy[0]);
    return said;
}

TEST(UmatTolerance, IsRefusedOutOfItsRangeByNumberValueAndLimits) {
    const struct {
        double tolerance;
        const char* got;
    } bad[] = {{nan, "nan"},      {infinity, "inf"},    {-infinity, "-inf"},
               {-3e-3, "-0.003"}, {1e-13, "1e-13"},     {0.2, "0.2"},
               {293.0, "293"},    {-1e-300, "-1e-300"}, {5e-324, "4.94066e-324"}};
    for (const auto& x : bad)
        EXPECT_EQ(
            refusal_of(x.tolerance),
            std::string("Grit UMAT: element 12, point 3: PROPS(17) (tolerance) must be 0 or in "
                        "[1e-12, 0.1], got ") +
                x.got + "\n");
}

TEST(UmatTolerance, TakesBothEndsOfItsRangeAndNothingNextToThem) {
    for (const double end : {1e-12, 0.1}) {
        UmatCall call = UmatCall::hochstetten();
        call.set_dstran(-1e-4, 0, 0);
        call.set_tolerance(end);
        EXPECT_TRUE(answer_to(call).finite()) << end;
        EXPECT_NE(refusal_of(std::nextafter(end, end < 1e-6 ? 0.0 : 1.0)), "") << end;
    }
}

TEST(UmatTolerance, IsTheDefaultWhereThereIsNoneOrZero) {
    for (const auto& d : increments) {
        const UmatCall without = answer_to(loaded(d));
        for (const double same : {0.0, -0.0, GRIT_SAND_DEFAULT_TOLERANCE})
            EXPECT_TRUE(answer(same, d).same_results(without)) << same;
        EXPECT_FALSE(answer(0.9 * GRIT_SAND_DEFAULT_TOLERANCE, d).same_results(without));
    }
}

// The memory of a host goes on behind PROPS, with whatever is there.
TEST(UmatTolerance, IsReadWithinNpropsAndAlone) {
    UmatCall sixteen = loaded();
    sixteen.props[16] = 1e-6;
    EXPECT_TRUE(answer_to(sixteen).same_results(answer_to(loaded())));
    UmatCall more = loaded();
    more.set_water(0.0, 0.0, 0.0);
    more.set_tolerance(1e-6);
    more.nprops = 24;  // the others are canaries
    EXPECT_TRUE(answer_to(more).same_results(answer(1e-6)));
}

double norm(const Guarded<6>& a, const Guarded<6>* b = nullptr) {
    double sum = 0.0;
    for (int c = 0; c < 6; ++c) {
        const double x = b ? a[c] - (*b)[c] : a[c];
        sum += (c < 3 ? 1.0 : 2.0) * x * x;
    }
    return std::sqrt(sum);
}

// What was asked holds for what is delivered, and who asks for more gets more.
TEST(UmatTolerance, BoundsTheErrorOfTheStress) {
    for (const auto& d : increments) {
        const UmatCall exact = answer(1e-10, d);
        const double scale = std::max(norm(loaded().stress), norm(exact.stress));
        const auto error = [&](const UmatCall& call) {
            return norm(call.stress, &exact.stress) / scale;
        };
        const UmatCall usual = answer_to(loaded(d));
        EXPECT_GT(error(usual), 1e-7) << "or there is nothing to gain";
        EXPECT_LT(error(usual), GRIT_SAND_DEFAULT_TOLERANCE);
        for (const double tolerance : {1e-6, 1e-8}) {
            const UmatCall call = answer(tolerance, d);
            EXPECT_LT(error(call), tolerance);
            EXPECT_LT(error(call), 0.5 * error(usual)) << tolerance;
            EXPECT_GT(call.statev[9], usual.statev[9]) << "evaluations";
        }
        EXPECT_LT(error(answer(0.1, d)), 0.1);
        EXPECT_LT(answer(0.1, d).statev[9], usual.statev[9]) << "evaluations";
    }
}

}  // namespace
