// SPDX-License-Identifier: BSD-3-Clause
// (H10): the model is evaluated at T - p_t I, T is what is stored.
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

constexpr double p_t = 25.0;  // kPa

Sand shifted(const Sand& sand) {
    grit_sand_parameters p = sand.p;
    p.pressure_shift = p_t;
    return prepared(sand.name, p);
}

State moved(State x, double by) {
    x.T += by * identity();
    return x;
}

TEST(PressureShift, RatesAreThoseOfTheShiftedStress) {
    for (const Sand& sand : four_sands()) {
        Random random(201);
        for (int i = 0; i < 20; ++i) {
            const State x = random_state(sand, random);
            const Vec D = random.direction();
            const Rate plain = rate(sand, x, D);
            const Rate with = rate(shifted(sand), moved(x, p_t), D);
            EXPECT_LT((with.T - plain.T).norm(), 1e-12 * plain.T.norm());
        }
    }
}

TEST(PressureShift, UpdatesAreThoseOfTheShiftedStress) {
    for (const Sand& sand : four_sands()) {
        Random random(202);
        for (int i = 0; i < 20; ++i) {
            const State x = random_state(sand, random, 100.0, 500.0);
            const Vec dE = random.log_uniform(1e-6, 1e-3) * random.direction();
            const auto options = options_with(1e-9);
            const State plain = updated(sand, x, dE, options);
            const State with = updated(shifted(sand), moved(x, p_t), dE, options);
            EXPECT_LT((moved(plain, p_t).T - with.T).norm(), 1e-8 * plain.T.norm());
        }
    }
}

}  // namespace
