// SPDX-License-Identifier: BSD-3-Clause
// V2
#include <gtest/gtest.h>

#include <array>

#include "support/box.hpp"

namespace {

using namespace mpm_test;

constexpr Shape shapes[] = {Shape::cpdi, Shape::cpdi_published, Shape::ugimp, Shape::point};
constexpr Scheme schemes[] = {Scheme::usl, Scheme::musl, Scheme::usf};

std::array<double, 3> totals(const std::vector<NodeRecord>& nodes) {
    std::array<double, 3> sum{};
    for (const NodeRecord& n : nodes)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += n[static_cast<int>(c)];
    return sum;
}

TEST(RigidMotion, KeepsMassMomentumShapeAndStressForEveryShapeFunctionAndScheme) {
    for (const Shape shape : shapes)
        for (const Scheme scheme : schemes)
            for (const bool axisymmetric : {true, false}) {
                Settings settings{.axisymmetric = axisymmetric, .shape = shape, .scheme = scheme};
                Simulation simulation(Axis::uniform(0.0, 1.0, 10), Axis::uniform(0.0, 4.0, 40),
                                      settings);
                Body body = make_box({0.1, 0.5, 0.13, 0.53, 9, 9, 1000.0}, axisymmetric,
                                     std::make_unique<LinearElastic>(1e6, 0.3));
                const ParticleView q = body.particles.view();
                const double v_r = axisymmetric ? 0.0 : 3.0, v_z = 20.0;
                double mass = 0.0;
                for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
                    q[column::v_r][p] = v_r;
                    q[column::v_z][p] = v_z;
                    mass += q[column::mass][p];
                }
                simulation.add_body(std::move(body));
                while (simulation.time() < 0.1) simulation.step();
                const auto sum = totals(simulation.records(0));
                EXPECT_NEAR(sum[0], mass, 1e-13 * mass);
                EXPECT_NEAR(sum[1], mass * v_r, 1e-13 * mass * v_z);
                EXPECT_NEAR(sum[2], mass * v_z, 1e-13 * mass * v_z);
                const Particles& moved = simulation.body(0).particles;
                for (std::ptrdiff_t p = 0; p < moved.size(); ++p) {
                    EXPECT_NEAR(moved(column::v_z, p), v_z, 1e-13 * v_z);
                    EXPECT_NEAR(moved(column::F_zz, p), 1.0, 1e-12);
                    EXPECT_NEAR(moved(column::S_rr, p), 0.0, 1e-6);
                }
                const std::ptrdiff_t first = simulation.find(0, 0);
                EXPECT_NEAR(moved(column::z, first), 0.13 + 0.2 / 9 + v_z * simulation.time(),
                            1e-12);
            }
}

}  // namespace
