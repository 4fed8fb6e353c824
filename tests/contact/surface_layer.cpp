// SPDX-License-Identifier: BSD-3-Clause
// Surface contact with a stiffness, (V8): the pressure is eps (overlap + tau its rate) at the end of the step.
#include <algorithm>
#include <cmath>

#include "support/meeting_grids.hpp"

namespace {

using namespace tests;

SurfaceCall with_layer(double dt, double eps, double tau, double mu = 0.0, int components = 2) {
    SurfaceCall call(components, mu);
    call.options.time_step = dt;
    call.options.contact_stiffness = eps;
    call.options.relaxation_time = tau;
    return call;
}

// The block's interface lies along nodes of mass 1 per length: its velocity follows from the pressure alone.
BlockAndFloor block_over(double gap, double speed) {
    BlockAndFloor out = block_above_floor(7, 0.0, speed);
    for (std::size_t i = 1; i < out.floor.position.size(); i += 2) out.floor.position[i] -= gap;
    return out;
}

TEST(SurfaceLayer, BearsByTheOverlapAtTheEndOfTheStepAndItsRate) {
    const double v = 2.0;
    for (const double dt : {1e-4, 1e-2})
        for (const double eps : {1.0, 1e3, 1e7})
            for (const double tau : {0.0, 1e-3, 1.0})
                for (const double gap : {-0.3, -1e-3, 0.0, 0.4 * v * dt}) {
                    auto [floor, block] = block_over(gap, v);
                    SurfaceCall call = with_layer(dt, eps, tau);
                    ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
                    // w + p dt = v; p = eps (w dt - gap + tau w), of a gap that is open: of what is closed beyond it.
                    const double of_gap = gap > 0.0 ? dt + tau : dt;
                    const double w = (v + eps * of_gap * gap) / (1.0 + eps * dt * (dt + tau));
                    for (std::size_t i = 0; i < block.vertices(); ++i)
                        EXPECT_NEAR(-block.velocity_of_vertex(i), w,
                                    1e-9 * (v + std::fabs(gap) / dt))
                            << dt << ' ' << eps << ' ' << tau << ' ' << gap;
                    EXPECT_NEAR(call.totals.normal_impulse, 7.0 * (v - w),
                                1e-8 * (v + std::fabs(gap) / dt));
                }
}

// A block that falls on the floor, step by step.
struct Fall {
    BlockAndFloor of;
    SurfaceCall call;
    Fall(const SurfaceCall& with, double speed)
        : of(block_above_floor(7, 0.0, speed)), call(with) {}
    double overlap() const { return 3.0 - of.block.position[1]; }
    // Of the block, which does not bend.
    double speed() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < of.block.vertices(); ++i) sum -= of.block.velocity_of_vertex(i);
        return sum / static_cast<double>(of.block.vertices());
    }
    // Of a unit of length.
    double energy() const {
        const double in = std::max(overlap(), 0.0);
        return 0.5 * speed() * speed() + 0.5 * call.options.contact_stiffness * in * in;
    }
    void step(double g) {
        const double dt = call.options.time_step;
        for (std::size_t i = 1; i < of.block.v.size(); i += 2) of.block.v[i] -= g * dt;
        ASSERT_EQ(call(of.floor, of.block), GRIT_OK) << call.error.message;
        for (std::size_t i = 1; i < of.block.position.size(); i += 2)
            of.block.position[i] -= dt * speed();
    }
};

TEST(SurfaceLayer, RestsWhereItsStiffnessCarriesTheLoadWhateverTheStep) {
    const double eps = 1e3, g = 9.81;
    for (const double dt : {2e-3, 1e-2, 0.1})
        for (const double tau : {0.02, 0.2}) {
            Fall fall(with_layer(dt, eps, tau), 0.0);
            for (int i = 0; i < 5000; ++i) fall.step(g);
            EXPECT_NEAR(fall.overlap(), g / eps, 1e-9) << dt << ' ' << tau;
            EXPECT_NEAR(fall.speed(), 0.0, 1e-9);
        }
}

TEST(SurfaceLayer, GivesBackWhatItTookAndNoMore) {
    for (const double tau : {0.0, 1e-3, 0.1})
        for (const double dt : {1e-4, 1e-2}) {
            Fall fall(with_layer(dt, 1e4, tau), 1.0);
            double before = fall.energy(), deepest = 0.0;
            for (int i = 0; fall.overlap() > -0.01 && i < 2000; ++i) {
                fall.step(0.0);
                EXPECT_LE(fall.energy(), before * (1.0 + 1e-12));
                before = fall.energy();
                deepest = std::max(deepest, fall.overlap());
            }
            EXPECT_GT(deepest, 0.0);
            EXPECT_LT(fall.speed(), 0.0) << "it parts";
            // A spring of 0.01 s that is stepped over a hundred times a radian takes little.
            if (tau == 0.0 && dt == 1e-4) {
                EXPECT_LT(fall.speed(), -0.97);
                EXPECT_NEAR(deepest, 0.01, 2e-4);
            }
        }
}

// Points that part from a row leave it little by little: no step of the force, whatever the slope. Where they left at once, for
// being a fiftieth of the reach away, what they pulled went with them: nearly half of the force.
TEST(SurfaceLayer, CarriesNoLessAndNoMoreAtOnceWhereSurfacesPart) {
    for (const double slope : {0.02, 0.05, 0.2})
        for (const bool axisymmetric : {false, true}) {
            const double eps = 1.0, dt = 1e-3, by = 1e-4;
            double before = -1.0, largest = 0.0, step = 0.0;
            for (double level = -0.2; level < 0.1; level += by) {
                GridBody floor, block;
                add_face(floor, false, 0.0, 7.0, 14, [](double, double) { return 3.0; });
                add_face(block, true, 0.0, 7.0, 14,
                         [&](double x, double) { return 3.0 + level + slope * x; });
                floor.rigid = true;
                std::mt19937_64 random(1);
                block.fill(random, 0.0, 0.0);
                block.weigh(0.0, 7.0);
                SurfaceCall call = with_layer(dt, eps, 0.0);
                call.options.axisymmetric = axisymmetric;
                ASSERT_EQ(call(floor, block), GRIT_OK) << call.error.message;
                const double force = call.totals.normal_impulse / dt;
                if (before >= 0.0) step = std::max(step, std::fabs(force - before));
                before = force;
                largest = std::max(largest, force);
            }
            EXPECT_GT(largest, 10.0 * step);
            // What a point of all may change by, four times over.
            EXPECT_LT(step, 4.0 * eps * by * (axisymmetric ? 24.5 : 7.0)) << slope;
        }
}

// Around the axis as in the plane, by r.
TEST(SurfaceLayer, PressesEveryPlaceAlikeInAxisymmetry) {
    auto [floor, block] = block_over(-0.1, 0.0);
    for (std::size_t i = 0; i < block.mass.size(); ++i) block.mass[i] *= 1e6;
    SurfaceCall call = with_layer(1e-2, 1e3, 0.0);
    call.options.axisymmetric = 1;
    ASSERT_EQ(call(floor, block), GRIT_OK);
    EXPECT_NEAR(call.totals.normal_impulse, 1e-2 * 1e3 * 0.1 * 24.5, 1e-3);
    for (const grit_surface_report& r : call.reports)
        EXPECT_NEAR(r.normal_force, 1e3 * 0.1 * r.area, 1e-3 * 1e3 * 0.1 * r.area);
}

// Nothing flies faster than that, however deep it is and however stiff the layer.
TEST(SurfaceLayer, PressesOutWithinItsRelaxationTime) {
    for (const auto& [tau, mu] : {std::pair{0.0, 0.0}, {1e-3, 0.0}, {1.0, 0.0}, {1e-3, 0.3}}) {
        const double dt = 1e-3, overlap = 0.2;
        auto [floor, block] = block_over(-overlap, 0.0);
        SurfaceCall call = with_layer(dt, 1e12, tau, mu);
        ASSERT_EQ(call(floor, block), GRIT_OK);
        for (std::size_t i = 0; i < block.vertices(); ++i)
            EXPECT_NEAR(block.velocity_of_vertex(i), overlap / (dt + tau),
                        1e-5 * overlap / (dt + tau));
    }
}

TEST(SurfaceLayer, OfNoEndOfStiffnessIsTheRigidSurface) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        std::mt19937_64 random(seed);
        auto [floor, block] = block_above_floor(7, 0.0, 1.0);
        for (double& v : block.v) v += 2.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 1.0;
        GridBody same = block;
        SurfaceCall rigid(2, 0.3), stiff = with_layer(rigid.options.time_step, 1e30, 0.0, 0.3);
        ASSERT_EQ(rigid(floor, block), GRIT_OK);
        ASSERT_EQ(stiff(floor, same), GRIT_OK);
        EXPECT_EQ(same.v, block.v);
    }
}

// However early sweeps end, and with whatever friction.
TEST(SurfaceLayer, KeepsMomentumAndMakesNoEnergyButWhatItHeld) {
    for (const int components : {2, 3})
        for (std::uint64_t seed = 0; seed < (components == 2 ? 200u : 30u); ++seed)
            for (const double mu : {0.0, 0.3, 5.0}) {
                Meeting m(components, seed, 1.0);
                for (GridBody* body : {&m.a, &m.b})
                    std::fill(body->fixed.begin(), body->fixed.end(), 0);
                const double eps = std::pow(10.0, static_cast<double>(seed % 9) - 2.0);
                const double tau =
                    seed % 3 == 0 ? 0.0 : std::pow(10.0, -static_cast<double>(seed % 5));
                SurfaceCall call = with_layer(1e-2, eps, tau, mu, components);
                if (seed % 4 == 0) call.options.sweep_limit = 1 + static_cast<int>(seed % 3);
                const double before = m.a.kinetic() + m.b.kinetic();
                const auto p_a = m.a.momentum(), p_b = m.b.momentum();
                ASSERT_EQ(call(m.a, m.b), GRIT_OK) << call.error.message;
                const auto q_a = m.a.momentum(), q_b = m.b.momentum();
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(q_a[c] + q_b[c], p_a[c] + p_b[c], 1e-11 * std::sqrt(before));
                const double overlap = std::max(-call.totals.smallest_gap, 0.0);
                const double held = 0.5 * eps * overlap * overlap * call.totals.area;
                EXPECT_LE(m.a.kinetic() + m.b.kinetic(), before * (1.0 + 1e-13) + held)
                    << seed << ' ' << mu;
                for (const grit_surface_report& r : call.reports) EXPECT_GE(r.normal_force, 0.0);
            }
}

}  // namespace
