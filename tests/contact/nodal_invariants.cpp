// SPDX-License-Identifier: BSD-3-Clause
// Laws of nature at a node, on a million random nodes each: masses 1e-6 ... 1e6, in the plane and in
// space, penalty powers 0.5 ... 20, friction 0 ... 1, Geo-contact and frictional contact.
#include <functional>

#include "../larger.hpp"
#include "../samples.hpp"
#include "support/nodes.hpp"

namespace {

using namespace tests;

struct Setting {
    grit_contact_options options;
    std::uint64_t seed;
};

std::vector<Setting> settings() {
    std::vector<Setting> all;
    std::uint64_t seed = 400;
    for (const int components : {2, 3})
        for (const int law : {GRIT_CONTACT_GEO, GRIT_CONTACT_FRICTIONAL})
            for (const double k : {0.5, 1.0, 2.0, 6.0, 20.0}) {
                Random random(++seed);
                grit_contact_options o = options_with(components);
                o.law = law;
                o.penalty_power = k;
                o.friction_coefficient = random.uniform(0.0, 1.0);
                all.push_back({o, seed});
            }
    return all;
}

constexpr std::size_t nodes_per_setting = samples(50000);

using Check = std::function<void(const grit_contact_options&, const Node& before, const Node& after,
                                 const grit_contact_report&)>;

void on_all_nodes(const Check& check, double adhesion = 0.0) {
    std::size_t in_contact = 0;
    for (auto [options, seed] : settings()) {
        options.adhesion = adhesion;
        options.time_step = adhesion > 0.0 ? 1e-3 : 0.0;
        Nodes nodes = random_nodes(nodes_per_setting, options.components, seed);
        const std::vector<Node> before = nodes.node;
        ASSERT_EQ(nodes.correct(options), GRIT_OK) << nodes.error.message;
        for (std::size_t i = 0; i < before.size(); ++i) {
            check(options, before[i], nodes.node[i], nodes.reports[i]);
            in_contact += nodes.reports[i].state >= GRIT_CONTACT_STICK;
        }
    }
    EXPECT_GT(in_contact, samples(350000));  // half of them approach, of these most are near enough
}

double size_of(const Node& x) { return x.m_a * norm(x.v_a) + x.m_b * norm(x.v_b); }
Vec tangential(const Vec& w, const Vec& n) { return w - dot(w, n) * n; }

TEST(NodalContact, KeepsMomentum) {
    double worst = 0.0;
    on_all_nodes([&](const auto&, const Node& x, const Node& y, const auto&) {
        worst = larger(worst, norm(y.momentum() - x.momentum()) / size_of(x));
    });
    EXPECT_LE(worst, 5e-16);
}

TEST(NodalContact, NeverGainsEnergy) {
    double worst = 0.0;
    on_all_nodes([&](const auto&, const Node& x, const Node& y, const auto&) {
        // Of the relative motion: that of the centre of mass would drown it.
        worst = larger(worst, norm(y.w()) / norm(x.w()) - 1.0);
    });
    EXPECT_LE(worst, 1e-15);
}

TEST(NodalContact, LeavesTheShareOfTheApproachThatThePenaltyLeaves) {
    double worst = 0.0;
    on_all_nodes([&](const auto&, const Node& x, const Node& y, const grit_contact_report& r) {
        if (r.state < GRIT_CONTACT_STICK) return;
        const double w_n = dot(x.w(), x.n);
        const double left = dot(y.w(), x.n) - (1.0 - r.penalty_factor) * w_n;
        worst = larger(worst, std::fabs(left) / (norm(x.v_a) + norm(x.v_b)));
    });
    EXPECT_LE(worst, 1e-15);
}

TEST(NodalContact, SticksToOneTangentialVelocity) {
    double worst = 0.0;
    on_all_nodes([&](const auto&, const Node& x, const Node& y, const grit_contact_report& r) {
        if (r.state != GRIT_CONTACT_STICK) return;
        worst = larger(worst, norm(tangential(y.w(), x.n)) / (norm(x.v_a) + norm(x.v_b)));
    });
    EXPECT_LE(worst, 1e-15);
}

TEST(NodalContact, SlipsAtTheLimitOfCoulombTakenAfterThePenalty) {
    double worst = 0.0;
    on_all_nodes([&](const grit_contact_options& o, const Node& x, const Node&,
                     const grit_contact_report& r) {
        if (r.state < GRIT_CONTACT_STICK) return;
        const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]};
        const double J_n = dot(J, x.n), J_t = norm(tangential(J, x.n));
        EXPECT_NEAR(J_n, r.penalty_factor * x.m_r() * dot(x.w(), x.n),
                    1e-14 * x.m_r() * norm(x.w()));
        const double over = J_t - o.friction_coefficient * J_n;
        // Tangential parts of w below its roundoff say nothing.
        const double scale = std::max(o.friction_coefficient * J_n, 0.1 * x.m_r() * norm(x.w()));
        if (r.state == GRIT_CONTACT_SLIP) worst = larger(worst, std::fabs(over) / scale);
        else worst = larger(worst, over / scale);
    });
    EXPECT_LE(worst, 1.6e-14);
}

TEST(NodalContact, FrictionActsAgainstTheSlip) {
    on_all_nodes([&](const grit_contact_options& o, const Node& x, const Node&,
                     const grit_contact_report& r) {
        if (r.state != GRIT_CONTACT_SLIP || o.friction_coefficient < 1e-3) return;
        const Vec J = {r.impulse[0], r.impulse[1], r.impulse[2]};
        const Vec J_t = tangential(J, x.n), w_t = tangential(x.w(), x.n);
        EXPECT_GE(dot(J_t, w_t),
                  (1.0 - 1e-9) * norm(J_t) * norm(w_t) - 1e-13 * norm(J) * norm(w_t));
    });
}

TEST(NodalContact, DoesNotSeeACommonVelocity) {
    for (const auto& [options, seed] : settings()) {
        Nodes nodes = random_nodes(nodes_per_setting / 5, options.components, seed);
        Nodes moving = nodes;
        const Vec v = {3.0, -2.0, options.components == 3 ? 1.0 : 0.0};
        for (Node& x : moving.node) {
            x.v_a = x.v_a + v;
            x.v_b = x.v_b + v;
        }
        nodes.correct(options);
        moving.correct(options);
        for (std::size_t i = 0; i < nodes.node.size(); ++i) {
            const Node &x = nodes.node[i], &y = moving.node[i];
            EXPECT_LE(norm(y.v_a - v - x.v_a), 1.6e-14);
            EXPECT_LE(norm(y.v_b - v - x.v_b), 1.6e-14);
        }
    }
}

TEST(NodalContact, TurnsWithTheBodies) {
    // A turn by 40 degrees about (1, 2, 2)/3 in space, about the third axis in the plane.
    for (const auto& [options, seed] : settings()) {
        const Vec axis = options.components == 3 ? Vec{1 / 3., 2 / 3., 2 / 3.} : Vec{0, 0, 1};
        const auto turned = [&](const Vec& v) {
            const double c = std::cos(0.7), s = std::sin(0.7);
            const Vec across = {axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2],
                                axis[0] * v[1] - axis[1] * v[0]};
            return c * v + s * across + ((1 - c) * dot(axis, v)) * axis;
        };
        Nodes nodes = random_nodes(nodes_per_setting / 5, options.components, seed);
        Nodes other = nodes;
        for (Node& x : other.node) {
            x.n = turned(x.n);
            x.v_a = turned(x.v_a);
            x.v_b = turned(x.v_b);
        }
        nodes.correct(options);
        other.correct(options);
        for (std::size_t i = 0; i < nodes.node.size(); ++i) {
            EXPECT_LE(norm(other.node[i].v_a - turned(nodes.node[i].v_a)), 1e-14);
            EXPECT_LE(norm(other.node[i].v_b - turned(nodes.node[i].v_b)), 1e-14);
        }
    }
}

TEST(NodalContact, SwapsTheBodiesBitForBit) {
    for (const auto& [options, seed] : settings()) {
        Nodes nodes = random_nodes(nodes_per_setting, options.components, seed);
        Nodes swapped = nodes;
        for (Node& x : swapped.node) {
            std::swap(x.m_a, x.m_b);
            std::swap(x.v_a, x.v_b);
            x.n = -1.0 * x.n;
        }
        nodes.correct(options);
        swapped.correct(options);
        for (std::size_t i = 0; i < nodes.node.size(); ++i) {
            EXPECT_EQ(norm(nodes.node[i].v_a - swapped.node[i].v_b), 0.0);
            EXPECT_EQ(norm(nodes.node[i].v_b - swapped.node[i].v_a), 0.0);
        }
    }
}

TEST(NodalContact, GivesTheCommonVelocityAtTheSurfaceOfRoughBodies) {
    for (const int components : {2, 3}) {
        Nodes nodes = random_nodes(samples(500000), components, 42);
        for (Node& x : nodes.node) x.s = -std::fabs(x.s);
        const std::vector<Node> before = nodes.node;
        grit_contact_options options = options_with(components);
        options.friction_coefficient = 1e9;
        nodes.correct(options);
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Node &x = before[i], &y = nodes.node[i];
            if (dot(x.w(), x.n) <= 1e-6) continue;  // Coulomb's limit is far away
            const Vec v_c = (1.0 / (x.m_a + x.m_b)) * x.momentum();
            const double scale = norm(x.v_a) + norm(x.v_b);
            EXPECT_LE(norm(y.v_a - v_c), 1e-15 * scale);
            EXPECT_LE(norm(y.v_b - v_c), 1e-15 * scale);
        }
    }
}

TEST(NodalContact, IsAPlainSentenceInHigherPrecision) {
    // The equations once more, as a reader of the paper would write them.
    double worst = 0.0;
    const auto check = [&](const grit_contact_options& o, const Node& x, const Node& y,
                           const grit_contact_report& r) {
        using Long = long double;
        const auto length = [](const Long* v) {
            return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        };
        Long w[3], w_t[3], w_n = 0;
        for (int c = 0; c < 3; ++c) {
            w[c] = Long(x.v_a[c]) - x.v_b[c];
            w_n += w[c] * x.n[c];
        }
        for (int c = 0; c < 3; ++c) w_t[c] = w[c] - w_n * x.n[c];
        Long f_p = 1;
        if (o.law == GRIT_CONTACT_GEO) {
            const Long share = std::min(std::max<Long>(x.s, 0), Long(x.d)) / x.d;
            f_p = share > 0 ? 1 - std::pow(share, Long(o.penalty_power)) : 1;
        }
        Long v_a[3] = {x.v_a[0], x.v_a[1], x.v_a[2]};
        if (w_n > 0 && f_p > 0) {
            const Long m_r = Long(x.m_a) * x.m_b / (Long(x.m_a) + x.m_b);
            const Long J_n = f_p * m_r * w_n;
            const Long limit =
                o.friction_coefficient * J_n + f_p * o.adhesion * x.area * o.time_step;
            const Long J_t = std::min(m_r * length(w_t), limit);
            for (int c = 0; c < 3; ++c)
                v_a[c] -= (J_n * x.n[c] + (J_t > 0 ? J_t * w_t[c] / length(w_t) : 0)) / x.m_a;
            EXPECT_NEAR(r.penalty_factor, double(f_p), 4e-16 * (1 + o.penalty_power));
        }
        for (int c = 0; c < 3; ++c)
            worst = larger(worst, std::fabs(double(y.v_a[c] - v_a[c])) / (1.0 + norm(x.w())));
    };
    on_all_nodes(check);
    EXPECT_LE(worst, 4e-15);
    on_all_nodes(check, 1e3);  // an adhesion that is divided by the smallest masses
    EXPECT_LE(worst, 1e-12);
}

}  // namespace
