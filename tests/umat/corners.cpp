// SPDX-License-Identifier: BSD-3-Clause
// Where the rate has a corner or an infinite slope: at the hydrostatic axis (F of (H5)), at the densest (f_d of (H7)) and
// at the loosest void ratio. A call that passes there adds no more to the error than its share of the tolerance: docs/adr/0009.
#include "../larger.hpp"
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

constexpr double tolerances[] = {1e-3, GRIT_SAND_DEFAULT_TOLERANCE, 1e-5};

struct Call {
    State start;
    Vec dE;
};

// The error over what the call may add: the tolerance times the share of the stress that it changes, or of a turn of h.
double error_in_shares(const Sand& sand, const Call& call, double tolerance, bool off) {
    grit_sand_options options = options_with(1e-11);
    options.intergranular_off = off;
    options.evaluation_limit = 1000000;
    const Vec exact = updated(sand, call.start, call.dE, options).T;
    options.tolerance = tolerance;
    const Vec T = updated(sand, call.start, call.dE, options).T;
    const double size = std::fmax(exact.norm(), call.start.T.norm());
    const double change = (exact - call.start.T).norm() / size;
    const double length = call.dE.norm();
    const double turning = off ? 0.0 : 0.1 * std::fmin(length / sand.p.elastic_strain_radius, 2.0);
    const double share = std::fmin(larger(larger(change, 3.0 * length), turning), 1.0);
    return (T - exact).norm() / size / (share * tolerance);
}

template <class Draw> void expect_shares_kept(double smallest, double largest, Draw draw) {
    for (const Sand& sand : four_sands())
        for (const bool off : {false, true}) {
            SCOPED_TRACE(testing::Message() << sand.name << (off ? ", h off" : ""));
            Random random(171);
            double worst = 0.0;
            for (int i = 0; i < 400; ++i) {
                const double size = random.log_uniform(smallest, largest);
                const Call call = draw(sand, random, size, off);
                worst = larger(worst, error_in_shares(sand, call, tolerances[i % 3], off));
            }
            EXPECT_LE(worst, 2.0);
        }
}

// Begins a random part of its way before the axis.
TEST(Corners, AtTheHydrostaticAxisArePassedWithinTheShareOfACall) {
    expect_shares_kept(1e-6, 1e-3, [](const Sand& sand, Random& random, double size, bool off) {
        const Vec D = deviator(random.direction()).normalized();
        Call call{{}, size * D};
        call.start.T = -100.0 * identity();
        call.start.e = void_ratio_at(sand, 100.0, random.uniform(0.2, 1.0));
        call.start.h = random.uniform() * sand.p.elastic_strain_radius * D;
        grit_sand_options options = options_with(1e-9);
        options.intergranular_off = off;
        const Vec way = deviator(updated(sand, call.start, call.dE, options).T);
        call.start.T = call.start.T - random.uniform() * way;
        return call;
    });
}

// Begins beside a limit of the void ratio at its pressure: off it by up to so much, looser in such a share of the calls.
template <class VoidRatio>
Call beside(VoidRatio limit_and, double most, double looser, const Sand& sand, Random& random,
            double size) {
    Call call{random_state(sand, random, 50.0, 500.0), size * random.direction()};
    const double p = -call.start.T.dot(identity()) / 3.0;
    const double off = random.log_uniform(1e-7, most) * (random.uniform() < looser ? 1.0 : -1.0);
    call.start.e = limit_and(p, off);
    return call;
}

TEST(Corners, AtTheDensestVoidRatioArePassedWithinTheShareOfACall) {
    expect_shares_kept(1e-5, 1e-3, [](const Sand& sand, Random& random, double size, bool) {
        const auto e_d_and = [&](double p, double off) { return void_ratio_at(sand, p, off); };
        return beside(e_d_and, 1e-2, 0.7, sand, random, size);
    });
}

TEST(Corners, AtTheLoosestVoidRatioArePassedWithinTheShareOfACall) {
    expect_shares_kept(1e-5, 1e-3, [](const Sand& sand, Random& random, double size, bool) {
        const auto e_i_and = [&](double p, double off) { return void_ratios(sand, p).e_i + off; };
        return beside(e_i_and, 1e-3, 0.5, sand, random, size);
    });
}

}  // namespace
