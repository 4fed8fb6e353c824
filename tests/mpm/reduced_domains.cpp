// SPDX-License-Identifier: BSD-3-Clause
// Domains that shear draws out: what stays of them when they are reduced, and whose are.
#include <gtest/gtest.h>

#include <adapters/mpm/kernel/reduced_domain.hpp>
#include <adapters/mpm/step/simulation.hpp>
#include <support/trials/split_mix.hpp>

#include "support/box.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace mpm_test;

struct Sides {
    double r1r, r1z, r2r, r2z;
    double area() const { return r1r * r2z - r1z * r2r; }
    double product() const { return r1r * r2r + r1z * r2z; }
    double shorter() const { return std::min(r1r * r1r + r1z * r1z, r2r * r2r + r2z * r2z); }
};

// A particle of these sides.
struct Sheared {
    Particles particles{0};
    explicit Sheared(const Sides& s, double l_r = 0.3, double l_z = 0.7) {
        particles.add({1.0, 1.0, l_r, l_z, 1.0}, false);
        const ParticleView q = particles.view();
        q[column::F_rr][0] = s.r1r / l_r;
        q[column::F_zr][0] = s.r1z / l_r;
        q[column::F_rz][0] = s.r2r / l_z;
        q[column::F_zz][0] = s.r2z / l_z;
    }
    Sides sides() const {
        const double l_r = particles(column::l_r, 0), l_z = particles(column::l_z, 0);
        return {particles(column::F_rr, 0) * l_r, particles(column::F_zr, 0) * l_r,
                particles(column::F_rz, 0) * l_z, particles(column::F_zz, 0) * l_z};
    }
};

// With x = m r1 + n r2: whole numbers m, n.
void expect_in_lattice(const Sides& of, double x, double y) {
    const double m = (x * of.r2z - y * of.r2r) / of.area();
    const double n = (of.r1r * y - of.r1z * x) / of.area();
    EXPECT_NEAR(m, std::round(m), 1e-9);
    EXPECT_NEAR(n, std::round(n), 1e-9);
}

TEST(ReducedDomain, SpansTheSameLatticeWithTheSameAreaAndLeansByNoMoreThanHalfASide) {
    grit::SplitMix random{7};
    int changed = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const auto dice = [&](double low, double high) { return random.uniform(low, high); };
        const double angle = dice(0.0, 6.3), length = dice(0.5, 2.0), lean = dice(-8.0, 8.0);
        const double c = std::cos(angle) * length, s = std::sin(angle) * length;
        // One side along the other by the lean, and across it.
        const double across = dice(0.5, 2.0);
        Sides before{c, s, lean * c - across * s, lean * s + across * c};
        if (trial % 2 == 0) before = {before.r2r, before.r2z, -before.r1r, -before.r1z};
        Sheared particle(before);
        before = particle.sides();  // as F has them
        baseline::reduce_domain(particle.particles.view(), 0);
        const Sides after = particle.sides();
        EXPECT_NEAR(after.area(), before.area(), 1e-12 * before.area());
        expect_in_lattice(before, after.r1r, after.r1z);
        expect_in_lattice(before, after.r2r, after.r2z);
        if (std::fabs(before.product()) <= before.shorter()) {
            EXPECT_EQ(after.product(), before.product());
            continue;
        }
        ++changed;
        EXPECT_LE(std::fabs(after.product()), 0.5 * before.shorter() * (1.0 + 1e-9));
    }
    EXPECT_GT(changed, 1000);
}

// Two bodies side by side in a box that is sheared to and fro along z.
double largest_lean(bool reduced, bool sand) {
    Simulation simulation(Axis::uniform(0.0, 1.0, 5), Axis::uniform(0.0, 2.0, 10),
                          {.axisymmetric = false, .cfl = 0.4, .reduced_domains = reduced});
    std::unique_ptr<Material> material;
    if (sand) material = std::make_unique<Sand>(lausitz(), sand_options());
    else material = std::make_unique<LinearElastic>(10e6, 0.3);
    Body body = make_box({0.2, 0.8, 0.4, 1.6, 6, 12, 1600.0}, false, std::move(material));
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        q[column::v_z][p] = 20.0 * (q[column::r][p] - 0.5);
        if (sand) q[Sand::state + GRIT_SAND_VOID_RATIO][p] = 0.7;
    }
    simulation.add_body(std::move(body));
    while (simulation.time() < 0.08) simulation.step();
    double largest = 0.0;
    const Particles& now = simulation.body(0).particles;
    for (std::ptrdiff_t p = 0; p < now.size(); ++p)
        largest = std::max(largest, std::fabs(now(column::F_zr, p) * now(column::l_r, p)) /
                                        (now(column::F_zz, p) * now(column::l_z, p)));
    return largest;
}

// Sand without stress is sheared by 20/s for 0.08 s.
TEST(ReducedDomain, IsThatOfSandWhereItIsAskedForAndOfNothingElse) {
    EXPECT_GT(largest_lean(false, true), 1.5);
    EXPECT_LE(largest_lean(true, true), 1.01);
    EXPECT_EQ(largest_lean(true, false), largest_lean(false, false));
}

}  // namespace
