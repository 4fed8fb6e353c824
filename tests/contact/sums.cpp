// SPDX-License-Identifier: BSD-3-Clause
// Sums over nodes are exact: no order, no cut and no cancellation changes a bit.
#include <algorithm>

#include "support/nodes.hpp"

namespace {

using namespace tests;

grit_contact_totals totals_of(const grit_contact_sums& sums) {
    grit_contact_totals totals{};
    totals.struct_size = sizeof totals;
    EXPECT_EQ(grit_contact_sums_read(&sums, &totals), GRIT_OK);
    return totals;
}

// One node whose impulse on B along x is exactly J: a rigid B stops A.
Node giving(double J) {
    Node x;
    x.n = {J >= 0.0 ? 1.0 : -1.0, 0.0, 0.0};
    x.v_a = {J, 0.0, 0.0};
    return x;
}

double sum_of(const std::vector<double>& terms) {
    grit_contact_options options = options_with();
    options.law = GRIT_CONTACT_FRICTIONAL;
    options.rigid = GRIT_CONTACT_B_RIGID;
    Nodes nodes;
    for (const double J : terms) nodes.node.push_back(giving(J));
    EXPECT_EQ(nodes.correct(options), GRIT_OK) << nodes.error.message;
    return totals_of(nodes.sums).impulse_on_b[0];
}

TEST(ContactSums, SurviveCancellation) {
    EXPECT_EQ(sum_of({1e90, 1.0, -1e90}), 1.0);
    EXPECT_EQ(sum_of({1e90, 1e-90, -1e90}), 1e-90);
    EXPECT_EQ(sum_of({0.1, 0.2, 0.3, -0.6}), 0x1p-55 + 0x1p-55 - 0x1p-55);
    EXPECT_EQ(sum_of({-3.0, 2.0}), -1.0);
}

TEST(ContactSums, OfNothingAreZero) {
    grit_contact_sums sums{};
    EXPECT_EQ(totals_of(sums).impulse_on_b[0], 0.0);
}

TEST(ContactSums, RoundToTheNearestAndTiesToEven) {
    EXPECT_EQ(sum_of({1.0, 0x1p-53}), 1.0);
    EXPECT_EQ(sum_of({1.0, 0x1p-53, 0x1p-150}), 1.0 + 0x1p-52);
    EXPECT_EQ(sum_of({1.0 + 0x1p-52, 0x1p-53}), 1.0 + 0x1p-51);
    EXPECT_EQ(sum_of({1.0, -0x1p-54, -0x1p-150}), 1.0 - 0x1p-53);
    EXPECT_EQ(sum_of({0x1.fffffffffffffp0, 0x1p-53}), 2.0);
    EXPECT_EQ(sum_of({0x1p-200, 0x1p-253, 0x1p-300}), 0x1p-200 + 0x1p-252);
}

TEST(ContactSums, AgreeWithHigherPrecision) {
    Random random(51);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> terms;
        long double sum = 0.0;
        for (int i = 0; i < 50; ++i) {
            terms.push_back(random.uniform(-1.0, 1.0));
            sum += terms.back();
        }
        EXPECT_EQ(sum_of(terms), static_cast<double>(sum));
    }
}

TEST(ContactSums, SayWhenTheyAreFull) {
    Nodes nodes({giving(1.0)});
    ASSERT_EQ(nodes.correct(options_with()), GRIT_OK);
    grit_contact_totals totals{};
    totals.struct_size = sizeof totals;
    for (int doubling = 0; doubling < 30; ++doubling) {
        const grit_contact_sums same = nodes.sums;
        grit_contact_sums_add(&nodes.sums, &same);
    }
    EXPECT_EQ(grit_contact_sums_read(&nodes.sums, &totals), GRIT_OK);
    EXPECT_EQ(totals.impulse_on_b[0], 0.5 * 0x1p30);
    grit_contact_sums_add(&nodes.sums, &nodes.sums);
    EXPECT_EQ(grit_contact_sums_read(&nodes.sums, &totals), GRIT_BAD_STATE);
}

TEST(ContactSums, DoNotDependOnTheOrder) {
    Random random(52);
    std::vector<double> terms;
    for (int i = 0; i < 1000; ++i)
        terms.push_back(random.normal() * random.log_uniform(1e-30, 1e30));
    const double sum = sum_of(terms);
    std::sort(terms.begin(), terms.end());
    EXPECT_EQ(sum_of(terms), sum);
    std::reverse(terms.begin(), terms.end());
    EXPECT_EQ(sum_of(terms), sum);
}

TEST(ContactSums, TotalTheReports) {
    for (const int components : {2, 3}) {
        grit_contact_options options = options_with(components);
        options.friction_coefficient = 0.4;
        options.time_step = 1e-3;
        Nodes nodes = random_nodes(2000, components, 53);
        nodes.remembered = true;
        for (std::size_t i = 0; i < 100; ++i) nodes.node[i].m_b = 0.0;
        ASSERT_EQ(nodes.correct(options), GRIT_OK);
        long double force[3] = {}, moment[3] = {}, energies[4] = {};
        std::ptrdiff_t counts[4] = {};
        double scale = 0.0;
        for (std::size_t i = 0; i < nodes.node.size(); ++i) {
            const grit_contact_report& r = nodes.reports[i];
            const Vec& x = nodes.node[i].x;
            const Vec f = {r.force[0], r.force[1], r.force[2]};
            for (int c = 0; c < 3; ++c) {
                force[c] += f[static_cast<std::size_t>(c)];
                const auto j = static_cast<std::size_t>((c + 1) % 3);
                const auto k = static_cast<std::size_t>((c + 2) % 3);
                moment[c] += x[j] * f[k] - x[k] * f[j];
            }
            energies[0] += r.trial_energy_normal;
            energies[1] += r.trial_energy_tangential;
            energies[2] += r.dissipation_normal;
            energies[3] += r.dissipation_tangential;
            ++counts[r.state];
            scale += norm(f);
        }
        const grit_contact_totals t = totals_of(nodes.sums);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(t.force_on_b[c], double(force[c]), 1e-15 * scale);
            EXPECT_NEAR(t.moment_on_b[c], double(moment[c]), 1e-14 * scale);
            EXPECT_EQ(t.impulse_on_a[c], -t.impulse_on_b[c]);
            EXPECT_EQ(t.force_on_a[c], -t.force_on_b[c]);
            EXPECT_EQ(t.moment_on_a[c], -t.moment_on_b[c]);
            EXPECT_NEAR(t.impulse_on_b[c], 1e-3 * t.force_on_b[c], 1e-17 * scale);
        }
        EXPECT_DOUBLE_EQ(t.trial_energy_normal, double(energies[0]));
        EXPECT_DOUBLE_EQ(t.trial_energy_tangential, double(energies[1]));
        EXPECT_NEAR(t.dissipation_normal, double(energies[2]), 1e-15 * scale);
        EXPECT_NEAR(t.dissipation_tangential, double(energies[3]), 1e-15 * scale);
        EXPECT_EQ(t.inactive, counts[GRIT_CONTACT_INACTIVE]);
        EXPECT_EQ(t.open, counts[GRIT_CONTACT_OPEN]);
        EXPECT_EQ(t.stick, counts[GRIT_CONTACT_STICK]);
        EXPECT_EQ(t.slip, counts[GRIT_CONTACT_SLIP]);
        EXPECT_GE(t.inactive, 100);
        EXPECT_EQ(t.failed, 0);
    }
}

}  // namespace
