// SPDX-License-Identifier: BSD-3-Clause
// More than two bodies at a node, (C7).
#include <algorithm>
#include <limits>
#include <string>

#include "../samples.hpp"
#include "support/bodies_at_nodes.hpp"

namespace {

using namespace tests;

Vec momentum(const BodiesAtNodes::One& x, int count) {
    Vec sum{};
    for (int b = 0; b < count; ++b) sum = sum + x.m[b] * x.v[b];
    return sum;
}

double size_of(const BodiesAtNodes::One& x, int count) {
    double sum = 0.0;
    for (int b = 0; b < count; ++b) sum += x.m[b] * norm(x.v[b]);
    return sum;
}

TEST(ManyBodies, KeepTheirTotalMomentum) {
    for (const int components : {2, 3})
        for (const int count : {3, 4, 8}) {
            BodiesAtNodes bodies(count, samples(count < 8 ? 20000 : 1000), 61, components);
            const auto before = bodies.node;
            ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
            for (std::size_t i = 0; i < before.size(); ++i)
                EXPECT_LE(norm(momentum(bodies.node[i], count) - momentum(before[i], count)),
                          1e-14 * size_of(before[i], count));
        }
}

TEST(ManyBodies, NeverGainEnergy) {
    BodiesAtNodes bodies(3, 50000, 62);
    for (auto& o : bodies.options) o.friction_coefficient = 3.0;
    const auto energy = [](const BodiesAtNodes::One& x) {
        double sum = 0.0;
        for (int b = 0; b < 3; ++b) sum += 0.5 * x.m[b] * dot(x.v[b], x.v[b]);
        return sum;
    };
    const auto before = bodies.node;
    ASSERT_EQ(bodies.correct(), GRIT_OK);
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LE(energy(bodies.node[i]), energy(before[i]) * (1.0 + 1e-14));
}

// Nor press by the last bit alone, where a pair that closed at first is opened by the others.
TEST(ManyBodies, NeverPull) {
    BodiesAtNodes bodies(7, 10000, 71);
    for (auto& o : bodies.options) {
        o.law = GRIT_CONTACT_FRICTIONAL;
        o.friction_coefficient = 0.0;
    }
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    std::size_t pressed = 0;
    for (std::size_t i = 0; i < bodies.reports.size(); ++i) {
        const grit_contact_report& r = bodies.reports[i];
        const Vec& n = bodies.node[i / bodies.who.size()].n[i % bodies.who.size()];
        const double J = dot({r.impulse[0], r.impulse[1], r.impulse[2]}, n);
        EXPECT_TRUE(J == 0.0 || J > 1e-14) << i << ": " << J;
        pressed += J > 0.0;
    }
    EXPECT_GT(pressed, bodies.node.size());
}

TEST(ManyBodies, OfWhichTwoMeetAreAPair) {
    BodiesAtNodes bodies(3, 1000, 63);
    Nodes pair;
    for (auto& x : bodies.node) {
        x.m[2] = 0.0;
        Node y;
        y.m_a = x.m[0];
        y.m_b = x.m[1];
        y.v_a = x.v[0];
        y.v_b = x.v[1];
        y.n = x.n[0];
        y.s = x.s[0];
        pair.node.push_back(y);
    }
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    grit_contact_options options = options_with();
    options.friction_coefficient = 0.3;
    ASSERT_EQ(pair.correct(options), GRIT_OK);
    for (std::size_t i = 0; i < bodies.node.size(); ++i) {
        EXPECT_TRUE(same_bits(bodies.node[i].v[0], pair.node[i].v_a));
        EXPECT_TRUE(same_bits(bodies.node[i].v[1], pair.node[i].v_b));
        EXPECT_EQ(std::memcmp(&bodies.reports[3 * i], &pair.reports[i], sizeof pair.reports[i]), 0);
    }
    EXPECT_EQ(std::memcmp(&bodies.sums[0], &pair.sums, sizeof pair.sums), 0);
}

// A row of bodies along x, body b at rest but for the first; all pairs of neighbours are known.
BodiesAtNodes row(int count) {
    BodiesAtNodes bodies(count, 1, 64);
    bodies.who.clear();
    for (int b = 0; b + 1 < count; ++b) bodies.who.emplace_back(b, b + 1);
    auto& x = bodies.node[0];
    for (int b = 0; b < count; ++b) {
        x.m[b] = 1.0;
        x.v[b] = {b == 0 ? 1.0 : 0.0, 0.0, 0.0};
    }
    for (std::size_t p = 0; p < bodies.who.size(); ++p) {
        x.n[p] = {1.0, 0.0, 0.0};
        x.s[p] = 0.0;
    }
    return bodies;
}

TEST(ManyBodies, InARowMoveOnTogether) {
    BodiesAtNodes bodies = row(3);
    bodies.call.sweep_tolerance = 1e-12;
    bodies.call.sweep_limit = 100;
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(bodies.node[0].v[b][0], 1.0 / 3.0, 1e-11);
    // The impulses that do it: 2/3 on the second body, 1/3 on the third.
    EXPECT_NEAR(bodies.reports[0].impulse[0], 2.0 / 3.0, 1e-11);
    EXPECT_NEAR(bodies.reports[1].impulse[0], 1.0 / 3.0, 1e-11);
}

TEST(ManyBodies, DoNotLoseThePenaltyBySweeping) {
    // Sweeps replace a pair's impulse: a second pair far away may not harden the first.
    BodiesAtNodes bodies = row(3);
    bodies.node[0].s[0] = 0.5;
    bodies.node[0].v[2] = {5.0, 0.0, 0.0};  // parts from the second
    bodies.call.sweep_limit = 50;
    for (auto& o : bodies.options) o.penalty_power = 1.0;
    ASSERT_EQ(bodies.correct(), GRIT_OK);
    EXPECT_NEAR(bodies.node[0].v[0][0] - bodies.node[0].v[1][0], 0.5, 1e-12);
}

TEST(ManyBodies, StandBetweenEachOtherWhateverTheirMasses) {
    // A light body between heavy ones that close in on it: sweeps alone would need as many as the ratio.
    for (const double light : {1e-2, 1e-4, 1e-8}) {
        BodiesAtNodes bodies = row(3);
        auto& x = bodies.node[0];
        x.m[1] = light;
        x.v[0] = {1.0, 0.2, 0.0};
        x.v[1] = {0.0, 0.0, 0.0};
        x.v[2] = {-1.0, 0.0, 0.0};
        ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
        // The light body's velocity is a small difference of impulses.
        for (int b = 0; b < 3; ++b)
            EXPECT_NEAR(bodies.node[0].v[b][0], 0.0, 1e-14 / light) << light;
    }
}

TEST(ManyBodies, ThatCannotGiveWaySaySo) {
    BodiesAtNodes bodies = row(3);  // a free body between two rigid ones that close in on it
    bodies.options[0].rigid = GRIT_CONTACT_A_RIGID;
    bodies.options[1].rigid = GRIT_CONTACT_B_RIGID;
    bodies.node[0].v[2] = {-1.0, 0.0, 0.0};
    const auto before = bodies.node;
    EXPECT_EQ(bodies.correct(), GRIT_NOT_CONVERGED);
    EXPECT_NE(std::string(bodies.error.message).find("squeezed"), std::string::npos);
    EXPECT_EQ(std::memcmp(&before[0], &bodies.node[0], sizeof before[0]), 0);
    EXPECT_EQ(bodies.reports[0].status, GRIT_NOT_CONVERGED);
}

// Where none is held there are always impulses that part them, however alike what they say.
TEST(ManyBodies, ThatNothingHoldsAreNeverSqueezed) {
    for (const double friction : {0.0, 0.3}) {
        BodiesAtNodes bodies(8, 500, 77, 2);
        Random random(78);
        for (auto& o : bodies.options) {
            o.law = GRIT_CONTACT_FRICTIONAL;
            o.friction_coefficient = friction;
        }
        for (auto& x : bodies.node)
            for (double& m : x.m) m = random.log_uniform(1e-4, 1e4);
        EXPECT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
        for (const auto& x : bodies.node)
            for (std::size_t p = 0; p < bodies.who.size(); ++p) {
                const auto [a, b] = bodies.who[p];
                EXPECT_LE(dot(x.v[a] - x.v[b], x.n[p]), friction > 0.0 ? 0.4 : 1e-8);
            }
    }
}

// Nor by rigid ones that are not there, or apart, or move alike.
TEST(ManyBodies, BesideRigidOnesThatDoNotSqueezeAreNotSqueezed) {
    for (const bool there : {false, true}) {
        BodiesAtNodes bodies(5, 1, 66);
        bodies.who = {{2, 3}, {3, 4}, {0, 2}, {1, 2}};
        for (std::size_t p = 0; p < 4; ++p) {
            bodies.options[p].law = GRIT_CONTACT_FRICTIONAL;
            bodies.options[p].mass_tolerance = 0.0;
        }
        bodies.options[2].rigid = bodies.options[3].rigid = GRIT_CONTACT_A_RIGID;
        auto& x = bodies.node[0];
        for (double& m : x.m) m = 1.0;
        x.m[3] = 1e-9;
        x.m[0] = x.m[1] = there ? 1.0 : 0.0;
        x.v[0] = x.v[1] = {there ? -5.0 : 7.0, 0.0, 0.0};
        if (!there) x.v[1] = {-7.0, 0.0, 0.0};
        x.v[2] = {1.0, 0.0, 0.0};
        x.v[3] = {0.0, 0.0, 0.0};
        x.v[4] = {-1.0, 0.0, 0.0};
        x.n[0] = x.n[2] = x.n[3] = {1.0, 0.0, 0.0};
        x.n[1] = {std::cos(1e-4), std::sin(1e-4), 0.0};
        EXPECT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    }
}

// A heavy and a light one between two rigid ones that move apart: what blocks a light body is small beside it.
TEST(ManyBodies, GiveWayToRigidOnesHoweverLightTheyAre) {
    for (const double light : {1e-3, 1e-12, 1e-19}) {
        BodiesAtNodes bodies(4, 1, 67);  // rigid, rigid, heavy, light
        bodies.who = {{0, 2}, {1, 3}, {3, 2}};
        for (std::size_t p = 0; p < 3; ++p) {
            bodies.options[p].law = GRIT_CONTACT_FRICTIONAL;
            bodies.options[p].friction_coefficient = 0.0;
            bodies.options[p].mass_tolerance = 0.0;
        }
        bodies.options[0].rigid = bodies.options[1].rigid = GRIT_CONTACT_A_RIGID;
        auto& x = bodies.node[0];
        x.m[0] = x.m[1] = x.m[2] = 1.0;
        x.m[3] = light;
        const double speed[] = {1.0, 1.2, 0.0, 0.5};
        for (std::size_t b = 0; b < 4; ++b) x.v[b] = {speed[b], 0.0, 0.0};
        for (std::size_t p = 0; p < 3; ++p) x.n[p] = {1.0, 0.0, 0.0};
        ASSERT_EQ(bodies.correct(), GRIT_OK) << light << ": " << bodies.error.message;
        for (const std::size_t b : {2u, 3u}) EXPECT_NEAR(x.v[b][0], 1.2, 1e-6) << light;
    }
}

// A light body between heavy ones, and a chain of which each is heavier: the last digits of the heavier are all that M has of it.
TEST(ManyBodies, MayHaveAnyMasses) {
    for (const double heavy : {1e8, 1e13, 1e18}) {
        BodiesAtNodes between = row(3);
        for (auto& o : between.options) o.mass_tolerance = 0.0;
        between.node[0].m[0] = between.node[0].m[2] = heavy;
        ASSERT_EQ(between.correct(), GRIT_OK) << between.error.message;
        for (int b = 0; b < 3; ++b)
            EXPECT_NEAR(between.node[0].v[b][0], 0.5, 1e-6) << b << " of " << heavy;
    }
    BodiesAtNodes chain = row(4);
    for (auto& o : chain.options) {
        o.law = GRIT_CONTACT_FRICTIONAL;
        o.mass_tolerance = 0.0;
    }
    chain.options[0].rigid = GRIT_CONTACT_A_RIGID;
    chain.node[0].m[2] = 1e9;
    chain.node[0].m[3] = 1e18;
    ASSERT_EQ(chain.correct(), GRIT_OK) << chain.error.message;
    for (int b = 0; b < 4; ++b) EXPECT_NEAR(chain.node[0].v[b][0], 1.0, 1e-6) << b;
    EXPECT_NEAR(chain.reports[2].impulse[0], 1e18, 1e12);
}

// Rigid ones that slide by each other fast and close in slowly press out what is in between as fast as they slide, at the most.
TEST(ManyBodies, BetweenRigidOnesThatSlideFastAreNotSqueezedBySlowOnes) {
    BodiesAtNodes bodies(3, 1, 85);
    bodies.who = {{0, 2}, {1, 2}};
    bodies.options.resize(2);
    for (auto& o : bodies.options) {
        o.law = GRIT_CONTACT_FRICTIONAL;
        o.friction_coefficient = 0.0;
        o.rigid = GRIT_CONTACT_A_RIGID;
    }
    auto& x = bodies.node[0];
    for (double& m : x.m) m = 1.0;
    const double closing = 1e-6, wedge = 1e-5;
    x.v[0] = {};
    x.v[1] = {-closing, 1.0, 0.0};
    x.v[2] = {0.0, 1.0, 0.0};
    x.n[0] = {1.0, 0.0, 0.0};
    x.n[1] = {-std::cos(wedge), std::sin(wedge), 0.0};
    x.s[0] = x.s[1] = -1.0;
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    EXPECT_NEAR(x.v[2][1], 1.0 + closing / wedge, 1e-6);
}

// Three in a ring, whose normals are one but for what a host's roundoff makes of them, or a little more.
TEST(ManyBodies, InARingOfNearlyOneNormalAreNeitherSqueezedNorThrown) {
    for (const double angle : {0.0, 1e-16, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3}) {
        BodiesAtNodes ring = row(3);
        ring.who.emplace_back(2, 0);
        ring.options.push_back(ring.options[0]);
        for (auto& o : ring.options) {
            o.law = GRIT_CONTACT_FRICTIONAL;
            o.friction_coefficient = 0.0;
        }
        auto& x = ring.node[0];
        x.n[2] = {std::cos(angle), std::sin(angle), 0.0};
        x.v[2] = {0.0, 1.0, 0.0};
        ASSERT_EQ(ring.correct(), GRIT_OK) << angle << ": " << ring.error.message;
        double energy = 0.0;
        for (int b = 0; b < 3; ++b) energy += dot(x.v[b], x.v[b]);
        EXPECT_LE(energy, 2.0) << angle;
        for (std::size_t p = 0; p < 3; ++p) {
            const auto [a, b] = ring.who[p];
            EXPECT_LE(dot(x.v[a] - x.v[b], x.n[p]), 2e-6) << angle << ", pair " << p;
        }
    }
}

// Eight bodies along two directions, give or take what digits can tell.
BodiesAtNodes along_nearly_two_normals(std::size_t nodes, std::uint64_t seed, int rigid,
                                       double heaviest = 1e4) {
    BodiesAtNodes bodies(8, nodes, seed, 2);
    Random random(seed + 1);
    std::erase_if(bodies.who, [&](const auto& pair) { return pair.second < rigid; });
    bodies.options.resize(bodies.who.size());
    bodies.sums.resize(bodies.who.size());
    for (std::size_t p = 0; p < bodies.who.size(); ++p) {
        bodies.options[p].law = GRIT_CONTACT_FRICTIONAL;
        bodies.options[p].friction_coefficient = 0.0;
        if (bodies.who[p].first < rigid) bodies.options[p].rigid = GRIT_CONTACT_A_RIGID;
    }
    for (auto& x : bodies.node) {
        for (double& m : x.m) m = random.log_uniform(1.0 / heaviest, heaviest);
        const double first = random.uniform(0.0, 6.3), second = random.uniform(0.0, 6.3);
        for (std::size_t p = 0; p < bodies.who.size(); ++p) {
            double angle = random.below(2) ? first : second;
            if (random.below(2)) angle += random.log_uniform(1e-6, 1e-4);
            x.n[p] = (random.below(2) ? 1.0 : -1.0) * Vec{std::cos(angle), std::sin(angle), 0.0};
        }
    }
    return bodies;
}

// More than normals may be off.
double approach_of(const BodiesAtNodes::One& x, int a, int b, std::size_t pair) {
    const Vec w = x.v[static_cast<std::size_t>(a)] - x.v[static_cast<std::size_t>(b)];
    return dot(w, x.n[pair]) - 1e-4 * norm(w);
}

double fastest(const BodiesAtNodes::One& x) {
    double speed = 0.0;
    for (const Vec& v : x.v) speed = std::max(speed, norm(v));
    return speed;
}

// Impulses around their rings are without measure, and roundoff of these may not be taken for a way out.
TEST(ManyBodies, OfNearlyTwoNormalsAreNeitherSqueezedNorThrownWhateverTheirMasses) {
    for (const double heaviest : {1e4, 1e10}) {
        BodiesAtNodes bodies = along_nearly_two_normals(samples(20000), 79, 0, heaviest);
        const auto before = bodies.node;
        EXPECT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const auto& x = bodies.node[i];
            double old = 0.0, now = 0.0;
            for (std::size_t b = 0; b < 8; ++b) {
                old += x.m[b] * dot(before[i].v[b], before[i].v[b]);
                now += x.m[b] * dot(x.v[b], x.v[b]);
            }
            EXPECT_LE(now, old * (1.0 + 1e-12)) << i;
            Vec told[8] = {};  // by the reports, momentum
            double size[8];    // of all that a body's velocity has been on its way
            for (std::size_t b = 0; b < 8; ++b) size[b] = norm(before[i].v[b]) + norm(x.v[b]);
            for (std::size_t p = 0; p < bodies.who.size(); ++p) {
                const auto [a, b] = bodies.who[p];
                EXPECT_LE(approach_of(x, a, b, p), 2e-4 * fastest(before[i]))
                    << i << ", pair " << p;
                const double* J = bodies.reports[i * bodies.who.size() + p].impulse;
                told[a] = told[a] - Vec{J[0], J[1], J[2]};
                told[b] = told[b] + Vec{J[0], J[1], J[2]};
                for (const int body : {a, b}) size[body] += norm({J[0], J[1], J[2]}) / x.m[body];
            }
            double largest = 0.0;
            for (std::size_t b = 0; b < 8; ++b)
                largest = std::max(largest, size[b] * std::sqrt(x.m[b]));
            for (std::size_t b = 0; b < 8; ++b)
                EXPECT_LE(norm(told[b] - x.m[b] * (x.v[b] - before[i].v[b])),
                          1e-12 * largest * std::sqrt(x.m[b]))
                    << i << ", body " << b;
        }
    }
}

// Friction neither gives energy, though all go by fast, nor is it lost where one of many sweeps leaves roundoff.
TEST(ManyBodies, OfNearlyTwoNormalsRubWithoutAGain) {
    const Vec common = {1e3, -2e3, 0.0};
    BodiesAtNodes bodies = along_nearly_two_normals(2000, 83, 0);
    for (auto& o : bodies.options) o.friction_coefficient = 0.3;
    for (auto& x : bodies.node)
        for (Vec& v : x.v) v = v + common;
    const auto before = bodies.node;
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    std::size_t rubbing = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        double old = 0.0, now = 0.0, roundoff = 0.0;
        for (std::size_t b = 0; b < 8; ++b) {
            const Vec v = before[i].v[b] - common, w = bodies.node[i].v[b] - common;
            old += before[i].m[b] * dot(v, v);
            now += before[i].m[b] * dot(w, w);
            roundoff += before[i].m[b] * 1e-15 * norm(common) * (norm(v) + norm(w));
        }
        EXPECT_LE(now, old * (1.0 + 1e-12) + roundoff) << i;
        bool rubs = false;
        for (std::size_t p = 0; p < bodies.who.size(); ++p) {
            const double* J = bodies.reports[i * bodies.who.size() + p].impulse;
            const Vec& n = before[i].n[p];
            rubs = rubs || std::fabs(J[0] * n[1] - J[1] * n[0]) > 1e-3 * norm({J[0], J[1], 0.0});
        }
        rubbing += rubs;
    }
    EXPECT_GE(rubbing, 920u);  // 928; 904 where such roundoff takes friction away
}

// Numbers that are none on the way are no answer.
TEST(ManyBodies, OfNearlyTwoNormalsBetweenTwoRigidOnesAreKeptApartOrRefused) {
    BodiesAtNodes bodies = along_nearly_two_normals(samples(40000), 81, 2);
    const auto before = bodies.node;
    EXPECT_EQ(bodies.correct(), GRIT_NOT_CONVERGED);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const auto& x = bodies.node[i];
        if (bodies.reports[i * bodies.who.size()].status != GRIT_OK) {
            ++refused;
            continue;
        }
        for (std::size_t p = 0; p < bodies.who.size(); ++p) {
            const auto [a, b] = bodies.who[p];
            EXPECT_LE(approach_of(x, a, b, p), 2e-4 * fastest(before[i])) << i << ", pair " << p;
        }
    }
    EXPECT_LT(refused, before.size());
}

// However fast they are.
TEST(ManyBodies, ThatAreApartDoNotMakeTheOthersSweepLess) {
    const auto settled = [](double fast) {
        BodiesAtNodes bodies(4, 1, 65);
        bodies.who = {{0, 1}, {1, 2}, {1, 3}};
        auto& x = bodies.node[0];
        for (double& m : x.m) m = 1.0;
        x.v[0] = {fast, 0.0, 0.0};
        x.v[1] = {0.0, 0.0, 0.0};
        x.v[2] = {-1e-3, 1.0, 0.0};
        x.v[3] = {1.0, -1e-3, 0.0};
        x.n[0] = x.n[1] = {1.0, 0.0, 0.0};
        x.n[2] = {0.0, 1.0, 0.0};
        x.s[0] = 2.0;  // beyond a cell
        x.s[1] = x.s[2] = -1.0;
        EXPECT_EQ(bodies.correct(), GRIT_OK);
        return bodies.node[0].v[1];
    };
    EXPECT_TRUE(same_bits(settled(0.0), settled(1e6)));
}

// Of an index list the node, not its place there.
TEST(ManyBodies, ThatCannotGiveWayAreNamedAsTheHostNamesTheirNode) {
    BodiesAtNodes bodies = row(3);
    bodies.options[0].rigid = GRIT_CONTACT_A_RIGID;
    bodies.options[1].rigid = GRIT_CONTACT_B_RIGID;
    bodies.node.assign(4, bodies.node[0]);
    for (std::size_t i = 0; i < 3; ++i) bodies.node[i].v[2] = {2.0, 0.0, 0.0};
    const std::vector<std::ptrdiff_t> index = {0, 3, 1, 2};
    bodies.call.index = index.data();
    EXPECT_EQ(bodies.correct(), GRIT_NOT_CONVERGED);
    EXPECT_EQ(bodies.error.point, 3);
    EXPECT_EQ(std::string(bodies.error.message).rfind("node 3:", 0), 0U) << bodies.error.message;
}

// (C5) once more: without its own impulse a pair approaches with w, and gets f_p m_r w_n and Coulomb. How many meet.
int meeting_as_pairs_alone(const BodiesAtNodes& bodies) {
    int meeting = 0;
    for (std::size_t i = 0; i < bodies.node.size(); ++i)
        for (std::size_t p = 0; p < bodies.who.size(); ++p) {
            const auto& x = bodies.node[i];
            const grit_contact_report& r = bodies.reports[bodies.who.size() * i + p];
            const auto a = static_cast<std::size_t>(bodies.who[p].first);
            const auto b = static_cast<std::size_t>(bodies.who[p].second);
            const int rigid = bodies.options[p].rigid;
            const double m_r = rigid == GRIT_CONTACT_A_RIGID ? x.m[b]
                               : rigid == GRIT_CONTACT_B_RIGID
                                   ? x.m[a]
                                   : x.m[a] * x.m[b] / (x.m[a] + x.m[b]);
            const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]};
            const Vec w = x.v[a] - x.v[b] + (1.0 / m_r) * J;
            const double w_n = dot(w, x.n[p]), J_n = dot(J, x.n[p]);
            const double f_p = 1.0 - std::pow(std::min(std::max(x.s[p], 0.0), 1.0), 6.0);
            const double allowed = 1e-8 * std::max(1.0, J_n);
            EXPECT_NEAR(J_n, f_p * m_r * std::max(w_n, 0.0), allowed);
            const Vec w_t = w - w_n * x.n[p], J_t = J - J_n * x.n[p];
            EXPECT_NEAR(norm(J_t), std::min(m_r * norm(w_t), 0.3 * J_n), allowed);
            meeting += J_n > 0.0;
        }
    return meeting;
}

TEST(ManyBodies, EndAtTheImpulsesOfPairsAlone) {
    BodiesAtNodes bodies(4, 3000, 69);
    bodies.call.sweep_tolerance = 1e-11;
    bodies.call.sweep_limit = 100000;
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    EXPECT_GT(meeting_as_pairs_alone(bodies), 5000);
}

// Seen from none of the two are the others free of work, and none of both is to decide whether friction stays.
TEST(ManyBodies, RubAgainstRigidOnesThatMoveDifferently) {
    BodiesAtNodes bodies(3, 9000, 73);
    bodies.who = {{0, 1}, {1, 2}};
    bodies.options.pop_back();
    bodies.options[0].rigid = GRIT_CONTACT_A_RIGID;
    bodies.options[1].rigid = GRIT_CONTACT_B_RIGID;
    for (auto& x : bodies.node) {
        x.v[2] = 3.0 * x.v[2];
        if (dot(x.n[0], x.n[1]) > 0.8)
            x.n[1] = -1.0 * x.n[1];  // between two friction cones it may be wedged
    }
    bodies.call.sweep_tolerance = 1e-11;
    bodies.call.sweep_limit = 100000;
    const auto before = bodies.node;
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    EXPECT_GT(meeting_as_pairs_alone(bodies), 3000);
    for (std::size_t i = 0; i < before.size(); ++i)
        for (const std::size_t b : {0, 2})
            EXPECT_TRUE(same_bits(bodies.node[i].v[b], before[i].v[b]));
}

TEST(ManyBodies, StopSweepingWhenAsked) {
    // With friction the impulses settle slowly: a loose tolerance or a low limit ends earlier.
    BodiesAtNodes loose(4, 1, 70), tight(4, 1, 70), stopped(4, 1, 70);
    for (BodiesAtNodes* bodies : {&loose, &tight, &stopped})
        for (auto& o : bodies->options) {
            o.friction_coefficient = 0.6;
            o.law = GRIT_CONTACT_FRICTIONAL;
        }
    loose.call.sweep_tolerance = 0.3;
    tight.call.sweep_tolerance = stopped.call.sweep_tolerance = 1e-10;
    stopped.call.sweep_limit = 2;
    for (BodiesAtNodes* bodies : {&loose, &tight, &stopped}) EXPECT_EQ(bodies->correct(), GRIT_OK);
    EXPECT_NE(std::memcmp(&loose.node[0], &tight.node[0], sizeof loose.node[0]), 0);
    EXPECT_NE(std::memcmp(&stopped.node[0], &tight.node[0], sizeof loose.node[0]), 0);
}

// Friction that holds a pair in its approach is left out.
TEST(ManyBodies, LeaveNoMoreThanATenthOfTheLargestApproachHoweverTheyRub) {
    BodiesAtNodes bodies(4, 3000, 79, 2);
    for (auto& o : bodies.options) {
        o.law = GRIT_CONTACT_FRICTIONAL;
        o.friction_coefficient = 5.0;
    }
    const auto approach = [&](std::size_t i, std::size_t p) {
        const auto& x = bodies.node[i];
        const auto a = static_cast<std::size_t>(bodies.who[p].first);
        const auto b = static_cast<std::size_t>(bodies.who[p].second);
        return dot(x.v[a] - x.v[b], x.n[p]);
    };
    std::vector<double> largest(bodies.node.size(), 0.0);
    for (std::size_t i = 0; i < largest.size(); ++i)
        for (std::size_t p = 0; p < bodies.who.size(); ++p)
            largest[i] = std::max(largest[i], approach(i, p));
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    for (std::size_t i = 0; i < largest.size(); ++i)
        for (std::size_t p = 0; p < bodies.who.size(); ++p)
            EXPECT_LE(approach(i, p), 0.1 * largest[i] + 1e-12) << i << ' ' << p;
}

// Of a soft spring overlap / dt is no velocity that is small against others.
TEST(ManyBodies, OnSoftSpringsSweepUntilTheirVelocitiesSettle) {
    const auto settled = [](double tolerance) {
        constexpr double gap = -1e-2, area = 1.0;
        BodiesAtNodes bodies(4, 300, 76);
        bodies.gap = grit_view_of(&gap, 0, 1);
        bodies.area = grit_view_of(&area, 0, 1);
        for (auto& o : bodies.options) {
            o.time_step = 1e-6;
            o.contact_stiffness = 1e8;  // 1e-4 m_r/dt2
            o.friction_coefficient = 0.6;
        }
        bodies.call.sweep_tolerance = tolerance;
        bodies.call.sweep_limit = 10000;
        EXPECT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
        return bodies.node;
    };
    const auto are = settled(1e-3), exact = settled(1e-11);
    double largest = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < are.size(); ++i)
        for (std::size_t b = 0; b < 4; ++b) {
            largest = std::max(largest, norm(are[i].v[b] - exact[i].v[b]));
            sum += norm(exact[i].v[b]);
        }
    EXPECT_LT(largest, 0.02 * sum / static_cast<double>(4 * are.size()));
}

TEST(ManyBodies, GiveTheSameBitsInAnyCompany) {
    BodiesAtNodes together(4, 50, 65);
    BodiesAtNodes start = together;
    together.correct();
    for (std::size_t i = 0; i < 50; ++i) {
        BodiesAtNodes alone = start;
        alone.node = {start.node[i]};
        alone.correct();
        EXPECT_EQ(std::memcmp(&alone.node[0], &together.node[i], sizeof alone.node[0]), 0);
    }
}

// A node with the bodies kept only, in their order.
BodiesAtNodes part_of(const BodiesAtNodes& whole, const std::vector<int>& kept) {
    BodiesAtNodes part = whole;
    const auto place = [&](int body) {
        const auto at = std::find(kept.begin(), kept.end(), body);
        return at == kept.end() ? -1 : static_cast<int>(at - kept.begin());
    };
    part.count = static_cast<int>(kept.size());
    for (std::size_t b = 0; b < kept.size(); ++b) {
        const auto from = static_cast<std::size_t>(kept[b]);
        part.node[0].m[b] = whole.node[0].m[from];
        part.node[0].v[b] = whole.node[0].v[from];
    }
    part.who.clear();
    part.options.clear();
    for (std::size_t p = 0; p < whole.who.size(); ++p) {
        const int a = place(whole.who[p].first), b = place(whole.who[p].second);
        if (a < 0 || b < 0) continue;
        part.node[0].n[part.who.size()] = whole.node[0].n[p];
        part.node[0].s[part.who.size()] = whole.node[0].s[p];
        part.who.emplace_back(a, b);
        part.options.push_back(whole.options[p]);
    }
    part.sums.resize(part.who.size());
    return part;
}

// Velocities of bodies without an active pair may be anything.
TEST(ManyBodies, DoNotFeelThoseThatAreNotThere) {
    Random random(72);
    const double anything[] = {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), 1e300, -0.7};
    int rubbing = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const int components = trial % 2 ? 2 : 3, count = 3 + trial % 6;
        BodiesAtNodes whole(count, 1, 7200 + static_cast<std::uint64_t>(trial), components);
        const int rigid = static_cast<int>(random.uniform(0.0, 2.0 * count));  // often none
        for (std::size_t p = 0; p < whole.who.size(); ++p) {
            whole.options[p].friction_coefficient = random.uniform(0.0, 1.0);
            if (whole.who[p].first == rigid) whole.options[p].rigid = GRIT_CONTACT_A_RIGID;
            if (whole.who[p].second == rigid) whole.options[p].rigid = GRIT_CONTACT_B_RIGID;
        }
        std::vector<int> kept;
        for (int b = 0; b < count; ++b) {
            const bool must = count - b <= 2 - static_cast<int>(kept.size());
            if (must || random.uniform(0.0, 1.0) < 0.6) {
                kept.push_back(b);
                continue;
            }
            const auto at = static_cast<std::size_t>(b);
            whole.node[0].m[at] = 0.0;
            for (int c = 0; c < components; ++c)
                whole.node[0].v[at][static_cast<std::size_t>(c)] =
                    anything[static_cast<int>(random.uniform(0.0, 5.0))];
        }
        BodiesAtNodes part = part_of(whole, kept);
        const BodiesAtNodes::One before = whole.node[0];
        ASSERT_EQ(whole.correct(), part.correct()) << whole.error.message << part.error.message;
        std::size_t k = 0;
        for (std::size_t b = 0; b < static_cast<std::size_t>(count); ++b) {
            const bool there = k < kept.size() && kept[k] == static_cast<int>(b);
            const Vec& expected = there ? part.node[0].v[k++] : before.v[b];
            EXPECT_EQ(std::memcmp(&whole.node[0].v[b], &expected, sizeof expected), 0)
                << "trial " << trial << ", body " << b;
        }
        std::size_t q = 0;
        for (std::size_t p = 0; p < whole.who.size(); ++p) {
            const auto is_kept = [&](int b) {
                return std::find(kept.begin(), kept.end(), b) != kept.end();
            };
            if (!is_kept(whole.who[p].first) || !is_kept(whole.who[p].second)) {
                EXPECT_EQ(whole.reports[p].state, GRIT_CONTACT_INACTIVE);
                continue;
            }
            rubbing += part.reports[q].trial_energy_tangential > 0.0;
            EXPECT_EQ(std::memcmp(&whole.reports[p], &part.reports[q], sizeof whole.reports[p]), 0)
                << "trial " << trial << ", pair " << p;
            EXPECT_EQ(std::memcmp(&whole.sums[p], &part.sums[q], sizeof whole.sums[p]), 0);
            ++q;
        }
    }
    EXPECT_GT(rubbing, 1000);
}

TEST(ManyBodies, WithARigidOneLeaveItAlone) {
    BodiesAtNodes bodies(3, 5000, 66);
    bodies.options[0].rigid = GRIT_CONTACT_B_RIGID;  // pair 0-1
    bodies.options[2].rigid = GRIT_CONTACT_A_RIGID;  // pair 1-2
    const auto before = bodies.node;
    ASSERT_EQ(bodies.correct(), GRIT_OK) << bodies.error.message;
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_TRUE(same_bits(bodies.node[i].v[1], before[i].v[1]));
}

TEST(ManyBodies, RefuseWhatCannotBe) {
    const auto expect = [](BodiesAtNodes& bodies, grit_status status, const char* message) {
        const auto before = bodies.node;
        EXPECT_EQ(bodies.correct(), status);
        EXPECT_STREQ(bodies.error.message, message);
        EXPECT_EQ(std::memcmp(before.data(), bodies.node.data(), sizeof before[0]), 0);
    };
    BodiesAtNodes bodies(3, 1, 67);
    bodies.who[2] = {1, 0};
    expect(bodies, GRIT_BAD_CALL, "pair 2: bodies 1 and 0 have a pair already");
    bodies = BodiesAtNodes(3, 1, 67);
    bodies.who[1] = {0, 3};
    expect(bodies, GRIT_BAD_CALL,
           "pair 1, a and b must be two different bodies of 0 ... 2, got 0 and 3");
    bodies = BodiesAtNodes(3, 1, 67);
    bodies.options[0].rigid = GRIT_CONTACT_A_RIGID;
    expect(bodies, GRIT_BAD_CALL, "pair 1: body 0 must be rigid in all of its pairs or in none");
    bodies = BodiesAtNodes(3, 1, 67);
    bodies.options[1].penalty_power = -1.0;
    expect(bodies, GRIT_BAD_CALL, "pair 1, penalty_power must be in (0, 1e6] [-], got -1");
    bodies = BodiesAtNodes(3, 1, 67);
    bodies.node[0].m[2] = -1.0;
    expect(bodies, GRIT_BAD_STATE, "pair 1, node 0: mass_b must be in [0, 1e100] [mass], got -1");
    bodies = BodiesAtNodes(3, 1, 67);
    bodies.node[0].n[2] = {0.0, 0.0, 0.5};
    expect(bodies, GRIT_BAD_STATE,
           "pair 2, node 0: normal must be a unit vector, |n|^2 within 1e-06 of 1 [-], "
           "got |n| = 0.5");
    bodies = BodiesAtNodes(3, 1, 67);
    bodies.count = 9;
    expect(bodies, GRIT_BAD_CALL, "count must be in [2, 8] bodies, got 9");
}

}  // namespace
