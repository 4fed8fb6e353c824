// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/replay_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <grit/sand_operators.h>

#include "support/sand_box.hpp"
#include "support/workplace.hpp"

namespace {

using namespace cli_test;
namespace mpm = grit::mpm;
namespace c = grit::mpm::column;

grit_sand_options strict() {
    grit_sand_options out = options_with_tolerance(1e-8);
    out.evaluation_limit = 3000;
    return out;
}

// Of shear, with a rotation by 0.01 and memory of another direction; sign: along it or back.
mpm::SandUpdate update_of(double size) {
    mpm::SandUpdate out{{-100e3, -200e3, -110e3, 30e3, 0, 0}, {}, {}, {}};
    const grit_sand sand = catalogue_sand("lausitz", 1000.0);
    const double direction[6] = {0.5, -1.0, 0.5, 0.7, 0.0, 0.0};
    grit_sand_mobilise(&sand, direction, 0.8, out.state);
    out.state[GRIT_SAND_VOID_RATIO] = 0.62;
    const double strain[4] = {0.3, -1.0, 0.1, 0.5};
    for (int k = 0; k < 4; ++k) out.strain[k] = size * strain[k];
    const double cosine = std::cos(0.01), sine = std::sin(0.01);
    const double Q[9] = {cosine, sine, 0, -sine, cosine, 0, 0, 0, 1};
    std::copy_n(Q, 9, out.rotation);
    return out;
}

// The stress after it, by the driver's own material [Pa].
std::vector<double> updated(const mpm::SandUpdate& update, mpm::Sand& sand) {
    mpm::Body body = sand_block({0.0, 0.0, 0.1, 1, 1, 1700.0}, 1.0);
    const mpm::ParticleView q = body.particles.view();
    auto increments = std::make_unique<mpm::Increments>();
    for (int k = 0; k < 4; ++k) q[c::S_rr + k][0] = update.stress[k];
    for (int k = 0; k < GRIT_SAND_STATE_SIZE; ++k) q[mpm::Sand::state + k][0] = update.state[k];
    for (int k = 0; k < 4; ++k) increments->strain[k][0] = update.strain[k];
    for (int k = 0; k < 9; ++k) increments->rotation[k][0] = update.rotation[k];
    sand.update({q, 0, 1}, *increments);
    return {q[c::S_rr][0], q[c::S_zz][0], q[c::S_tt][0], q[c::S_rz][0]};
}

TEST(ReplayedUpdate, GivesTheSameStress) {
    const Workplace here;
    mpm::Sand sand(catalogue_sand("lausitz", 1000.0), strict());
    for (const double size : {1e-5, 1e-3, -1e-3}) {
        const mpm::SandUpdate update = update_of(size);
        here.write("x.toml", cli::replay_case(update, sand, "an update\nof a particle"));
        const Answer answer = here.run("x");
        ASSERT_EQ(answer.status, 0) << answer.text << here.text("x.toml");
        auto result = here.result("x");
        const std::vector<double> expected = updated(update, sand);
        const char* const names[] = {"stress_11", "stress_22", "stress_33", "stress_12"};
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(1e3 * result.at(names[k]).back(), expected[k], 1e-6 * 200e3) << names[k];
        EXPECT_EQ(result.at("stress_11").size(), 2u);  // start and one increment
    }
}

TEST(ReplayedUpdate, WithoutMemoryOrWithoutIntergranularStrainSaysSo) {
    const Workplace here;
    mpm::SandUpdate update = update_of(1e-3);
    std::fill_n(update.state, 6, 0.0);
    grit_sand_options basic = strict();
    basic.intergranular_off = 1;
    for (const grit_sand_options& options : {strict(), basic}) {
        mpm::Sand sand(catalogue_sand("lausitz", 1000.0), options);
        here.write("x.toml", cli::replay_case(update, sand, "x"));
        ASSERT_EQ(here.run("x").status, 0) << here.text("x.toml");
        EXPECT_NEAR(1e3 * here.result("x").at("stress_22").back(), updated(update, sand)[1],
                    1e-6 * 200e3);
    }
}

class FailingParticle : public testing::Test {
  protected:
    // What a step of the simulation throws.
    mpm::MaterialFailure failure() {
        try {
            for (int i = 0; i < 50; ++i) simulation->step();
        } catch (const mpm::MaterialFailure& error) {
            return error;
        }
        ADD_FAILURE() << "nothing failed";
        return {{}, 0, ""};
    }
    // Says of a replay what the simulation said.
    void expect_same_words(const mpm::MaterialFailure& error) {
        cli::write_replay_case(here.path("x.toml"), error, *simulation);
        const Answer answer = here.run("x");
        EXPECT_NE(answer.status, 0);
        EXPECT_TRUE(answer.says(error.reason())) << answer.text << error.reason();
    }

    Workplace here;
    std::unique_ptr<mpm::Simulation> simulation = sand_box();
};

TEST_F(FailingParticle, IsNamedAndFailsAloneInTheSameWords) {
    simulation->step();
    // One that is thrown into the others.
    mpm::Particles& particles = simulation->body(0).particles;
    particles.view()[c::v_z][simulation->find(0, 57)] = -1.2e4;
    const mpm::MaterialFailure error = failure();
    EXPECT_EQ(error.name(), "sand");
    EXPECT_EQ(error.body(), 0u);
    EXPECT_NE(error.reason().find("|strain increment| must be at most 0.2"), std::string::npos);
    const std::string what = error.what();
    EXPECT_TRUE(
        what.starts_with("body sand, particle " + std::to_string(error.particle()) + ", t = "))
        << what;
    // The particle is as it was before the update.
    const std::ptrdiff_t p = simulation->find(0, error.particle());
    EXPECT_EQ(particles(c::S_zz, p), error.update().stress[1]);
    expect_same_words(error);
    EXPECT_TRUE(here.text("x.toml").starts_with("# " + what));
}

TEST_F(FailingParticle, OfAVoidRatioBeyondAllLimitsIsRefusedWithIt) {
    simulation->step();
    mpm::Particles& particles = simulation->body(0).particles;
    const std::ptrdiff_t p = simulation->find(0, 31);
    particles.view()[mpm::Sand::state + GRIT_SAND_VOID_RATIO][p] = -0.5;
    const mpm::MaterialFailure error = failure();
    EXPECT_EQ(error.particle(), 31);
    EXPECT_EQ(error.update().state[GRIT_SAND_VOID_RATIO], -0.5);
    EXPECT_NE(error.reason().find("void ratio must be in"), std::string::npos) << error.what();
    cli::write_replay_case(here.path("x.toml"), error, *simulation);
    EXPECT_TRUE(here.run("x").says("void ratio must be in"));
}

}  // namespace
