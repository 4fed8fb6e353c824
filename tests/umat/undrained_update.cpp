// SPDX-License-Identifier: BSD-3-Clause
// Undrained points: the update of the sand and (W1), one by one.
#include "support/batch.hpp"
#include "support/random_sand.hpp"
#include "support/undrained.hpp"

namespace {

using namespace tests;

// Any sand, under pressure, without stress or apart; water at rest, under suction or cavitated.
struct Trial {
    Sand sand;
    Water water;
    WetPoint start;
    Vec dE;
};

Trial random_trial(Random& random) {
    Trial t{random_sand(random), {random.log_uniform(1e-2, 1e7)}, {}, {}};
    if (random.uniform() < 0.3) t.water.porosity = random.uniform(0.01, 1.0);
    const double p = random.log_uniform(1e-3, 1e3);
    State x;
    x.T = stress_with(p, random.uniform(0.0, 0.5), deviator(random.direction()).normalized());
    x.e = void_ratio_at(t.sand, p, random.uniform(0.05, 1.2));
    x.h = random_memory(t.sand, random);
    t.start.sand = point_of(x);
    if (random.uniform() < 0.2) {  // tension
        std::fill_n(t.start.sand.stress, 6, 0.0);
        std::fill_n(t.start.sand.state, 6, 0.0);
        t.start.sand.state[GRIT_SAND_SEPARATION] =
            random.uniform() < 0.5 ? 0.0 : random.log_uniform(1e-6, 1e-1);
    }
    t.dE = random.log_uniform(1e-8, 1e-2) * random.direction();
    const double reach = t.water.bulk_modulus * std::fabs(trace(t.dE)) * (1.0 + 1.0 / x.e);
    if (random.uniform() < 0.5) t.water.largest_tension = random.uniform() * reach;
    t.start.p_w = random.uniform(-2.0, 2.0) * reach;
    return t;
}

TEST(UndrainedUpdate, IsThatOfTheSandAndThatOfItsWater) {
    Random random(181);
    int cavitated = 0, stress_free = 0, wet = 0;
    for (int i = 0; i < 3000; ++i) {
        const Trial t = random_trial(random);
        const Voigt strain = voigt_strain(t.dE);
        WetPoint end = t.start;
        Point dry = t.start.sand;
        const grit_sand_options options = options_with(1e-3, GRIT_TANGENT_CONSISTENT);
        const Outcome drained = update(t.sand, dry, strain.data(), options);
        const Outcome out = update_undrained(t.sand, t.water, end, strain.data(), options);
        ASSERT_EQ(out.status, drained.status);
        EXPECT_TRUE(same_bits(end.sand, dry));
        if (out.status != GRIT_OK) continue;
        const double e_0 = t.start.sand.state[GRIT_SAND_VOID_RATIO];
        const double e = dry.state[GRIT_SAND_VOID_RATIO];
        const double K_w = t.water.bulk_modulus;
        const double change =
            t.water.porosity > 0.0 ? K_w / t.water.porosity * trace(t.dE) : K_w * std::log(e / e_0);
        // The logarithm knows e/e_0 to some bits only.
        EXPECT_NEAR(end.p_w, t.start.p_w - change,
                    1e-15 * (std::fabs(t.start.p_w) + 10.0 * K_w * (1.0 + 1.0 / e)));
        for (int c = 0; c < 6; ++c)
            EXPECT_EQ(end.total[c],
                      c < 3 ? dry.stress[c] - borne(t.water, end.p_w) : dry.stress[c]);
        const bool bears = end.p_w > -t.water.largest_tension;
        EXPECT_EQ(out.report.flags, drained.report.flags | (bears ? 0 : GRIT_SAND_CAVITATED));
        EXPECT_EQ(out.report.evaluations, drained.report.evaluations);
        const double n = t.water.porosity > 0.0 ? t.water.porosity : e / (1.0 + e);
        for (int r = 0; r < 6; ++r)
            for (int c = 0; c < 6; ++c) {
                const double K = bears && r < 3 && c < 3 ? K_w / n : 0.0;
                EXPECT_NEAR(out.tangent[6 * r + c], drained.tangent[6 * r + c] + K,
                            K > 0.0 ? 1e-15 * std::fabs(drained.tangent[0]) + 1e-14 * K : 0.0);
            }
        cavitated += !bears;
        wet += bears;
        stress_free += (out.report.flags & GRIT_SAND_STRESS_FREE) != 0;
    }
    EXPECT_GE(cavitated, 300);
    EXPECT_GE(wet, 1000);
    EXPECT_GE(stress_free, 300);
}

// Central differences of the total stress of the steps taken, where the sand's stress has a derivative: away
// from reversal (ConsistentTangent), and from where the water begins to cavitate.
TEST(UndrainedTangent, IsTheDerivativeOfTheTotalStress) {
    Random random(182);
    int compared = 0, cavitated = 0;
    for (int i = 0; i < 4000; ++i) {
        const Trial t = random_trial(random);
        const State x = state_of(t.start.sand);
        const double length = t.dE.norm();
        const Vec D = t.dE / length;
        const double along = x.h.dot(D);
        if (x.T.norm() == 0.0 || !(std::fabs(along) > 0.05 * x.h.norm() + 0.01 * length) ||
            !(std::fabs(along + length) > 0.05 * length))
            continue;
        const grit_sand_options options = options_with(0.1);
        struct End {
            Vec total;
            double p_w;
            grit_sand_report report;
        };
        const auto at = [&](const Vec& dE) {
            WetPoint point = t.start;
            const Outcome out =
                update_undrained(t.sand, t.water, point, voigt_strain(dE).data(), options);
            EXPECT_EQ(out.status, GRIT_OK) << out.error.message;
            return End{stress_from(point.total), point.p_w, out.report};
        };
        WetPoint point = t.start;
        const Outcome out = update_undrained(t.sand, t.water, point, voigt_strain(t.dE).data(),
                                             options_with(0.1, GRIT_TANGENT_CONSISTENT));
        const bool turns = along < 0.0 && along > -length;
        if (out.status != GRIT_OK || out.report.substeps != (turns ? 2 : 1) ||
            (out.report.flags & (GRIT_SAND_STRESS_FREE | GRIT_SAND_OUTSIDE_CONE |
                                 GRIT_SAND_VOID_CLAMPED | GRIT_SAND_H_CLAMPED)))
            continue;
        Mat C;
        bool smooth = true;
        for (int j = 0; j < 6 && smooth; ++j) {
            const Vec step = 1e-4 * length * Vec::Unit(j);
            const End up = at(t.dE + step), down = at(t.dE - step);
            C.col(j) = (up.total - down.total) / (2e-4 * length);
            smooth = up.report.flags == out.report.flags && down.report.flags == out.report.flags &&
                     up.report.substeps == out.report.substeps &&
                     down.report.substeps == out.report.substeps;
        }
        if (!smooth) continue;
        ++compared;
        cavitated += (out.report.flags & GRIT_SAND_CAVITATED) != 0;
        const Mat tangent = stiffness_from(out.tangent);
        // What bits of a total stress leave of the differences.
        const double noise =
            1e-15 * (stress_from(point.total).norm() + std::fabs(point.p_w)) / (1e-4 * length);
        EXPECT_LE((C - tangent).norm(), 1e-5 * tangent.norm() + noise)
            << i << ", increment " << length << ", flags " << out.report.flags;
    }
    EXPECT_GE(compared, 500);
    EXPECT_GE(cavitated, 80);
}

// The water's part alone, at any point, the stress-free ones too.
TEST(UndrainedTangent, HasTheDerivativeOfThePressureThatBears) {
    Random random(183);
    int compared = 0, stress_free = 0;
    for (int i = 0; i < 3000; ++i) {
        const Trial t = random_trial(random);
        const double probe = 1e-3 * t.dE.norm();
        const auto borne_after = [&](double volumetric) {
            WetPoint point = t.start;
            const Vec dE = t.dE + volumetric / 3.0 * identity();
            const Outcome out = update_undrained(t.sand, t.water, point, voigt_strain(dE).data(),
                                                 options_with(0.1));
            return std::pair{out.status, borne(t.water, point.p_w)};
        };
        const Voigt strain = voigt_strain(t.dE);
        WetPoint point = t.start;
        Point dry = t.start.sand;
        const grit_sand_options options = options_with(0.1, GRIT_TANGENT_CONTINUUM);
        const Outcome drained = update(t.sand, dry, strain.data(), options);
        const Outcome out = update_undrained(t.sand, t.water, point, strain.data(), options);
        const auto [up_status, up] = borne_after(probe);
        const auto [down_status, down] = borne_after(-probe);
        if (out.status || up_status || down_status) continue;
        const double away = std::fabs(point.p_w + t.water.largest_tension);
        const double e = point.sand.state[GRIT_SAND_VOID_RATIO];
        const double K =
            t.water.bulk_modulus / (t.water.porosity > 0.0 ? t.water.porosity : e / (1.0 + e));
        if (away < 2.0 * K * probe) continue;
        ++compared;
        stress_free += (out.report.flags & GRIT_SAND_STRESS_FREE) != 0;
        const double noise =
            1e-15 * std::fabs(point.p_w) / probe + 1e-15 * std::fabs(drained.tangent[1]);
        EXPECT_NEAR(out.tangent[1] - drained.tangent[1], -(up - down) / (2.0 * probe),
                    1e-5 * K + noise);
    }
    EXPECT_GE(compared, 2000);
    EXPECT_GE(stress_free, 300);
}

TEST(WaterStiffness, IsWhatTheTangentHas) {
    Random random(188);
    for (int i = 0; i < 500; ++i) {
        const Trial t = random_trial(random);
        const Voigt strain = voigt_strain(t.dE);
        WetPoint end = t.start;
        Point dry = t.start.sand;
        const grit_sand_options options = options_with(1e-3, GRIT_TANGENT_CONTINUUM);
        const Outcome drained = update(t.sand, dry, strain.data(), options);
        const Outcome out = update_undrained(t.sand, t.water, end, strain.data(), options);
        if (out.status != GRIT_OK) continue;
        const grit_sand_water water = water_of(t.water, nullptr);
        double K = -1.0;
        ASSERT_EQ(
            grit_sand_water_stiffness(&water, end.p_w, end.sand.state[GRIT_SAND_VOID_RATIO], &K),
            GRIT_OK);
        EXPECT_EQ(out.tangent[1], drained.tangent[1] + K);
    }
}

TEST(WaterStiffness, IsRefusedToWatersAndPointsThatAreNone) {
    grit_sand_water water = water_of({1e5}, nullptr);
    double K = -1.0;
    EXPECT_EQ(grit_sand_water_stiffness(nullptr, 0.0, 0.6, &K), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_water_stiffness(&water, 0.0, 0.6, nullptr), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_water_stiffness(&water, std::nan(""), 0.6, &K), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_water_stiffness(&water, 0.0, 0.0, &K), GRIT_BAD_CALL);
    water.bulk_modulus = -1.0;
    EXPECT_EQ(grit_sand_water_stiffness(&water, 0.0, 0.6, &K), GRIT_BAD_PARAMETER);
    EXPECT_EQ(K, -1.0);
    EXPECT_EQ(grit_sand_water_init(nullptr, sizeof water), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_water_init(&water, 3), GRIT_BAD_CALL);
}

constexpr std::size_t many = 600;  // more than are taken at a time

struct WetBatch : Batch {
    std::vector<double> p_w;
    std::vector<Voigt> total;
};

WetBatch random_wet_batch(const Sand& sand, std::uint64_t seed, bool in_plane = false) {
    WetBatch batch{random_batch(sand, many, seed, in_plane), {}, {}};
    Random random(seed + 1);
    for (std::size_t i = 0; i < many; ++i) batch.p_w.push_back(random.uniform(-300.0, 300.0));
    batch.total.assign(many, Voigt{1.5, 1.5, 1.5, 1.5, 1.5, 1.5});
    return batch;
}

const Water sea{2e4, 0.0, 100.0};

grit_status update_all(const Sand& sand, WetBatch& batch, const grit_sand_options& options,
                       const grit_sand_points& q) {
    grit_sand_water water = water_of(sea, batch.p_w.data(), batch.total[0].data());
    water.pore_pressure.point_stride = 1;
    water.total_stress.point_stride = 6;
    const auto n = q.index ? 400 : static_cast<std::ptrdiff_t>(many);
    return grit_sand_update_undrained(sand, &options, &water, n, &q, batch.reports.data(),
                                      &batch.error);
}

TEST(UndrainedUpdate, OfManyPointsIsThatOfEachToTheBit) {
    const Sand sand = sand_named("lausitz");
    for (const int tangent : {GRIT_TANGENT_NONE, GRIT_TANGENT_CONTINUUM, GRIT_TANGENT_CONSISTENT}) {
        const grit_sand_options options = options_with(1e-5, tangent);
        const WetBatch start = random_wet_batch(sand, 184);
        WetBatch all = start;
        ASSERT_EQ(update_all(sand, all, options, all.views()), GRIT_OK) << all.error.message;
        int cavitated = 0;
        for (std::size_t i = 0; i < many; ++i) {
            WetPoint alone{start.points[i], start.p_w[i], {}};
            const Outcome out = update_undrained(sand, sea, alone, start.strain[i].data(), options);
            ASSERT_TRUE(same_bits(alone.sand, all.points[i])) << i;
            ASSERT_EQ(alone.p_w, all.p_w[i]) << i;
            for (std::size_t c = 0; c < 6; ++c) ASSERT_EQ(alone.total[c], all.total[i][c]) << i;
            for (std::size_t c = 0; c < 36 && tangent != GRIT_TANGENT_NONE; ++c)
                ASSERT_EQ(out.tangent[c], all.tangents[i][c]) << i;
            EXPECT_EQ(out.report.flags, all.reports[i].flags);
            cavitated += (out.report.flags & GRIT_SAND_CAVITATED) != 0;
        }
        EXPECT_GE(cavitated, 50);
    }
}

TEST(UndrainedUpdate, OfAnIndexListTakesItsPointsAndNoOthers) {
    const Sand sand = sand_named("lausitz");
    const WetBatch start = random_wet_batch(sand, 185);
    WetBatch all = start, some = start;
    const grit_sand_options options = options_with();
    ASSERT_EQ(update_all(sand, all, options, all.views()), GRIT_OK);
    std::vector<std::ptrdiff_t> index;
    for (std::ptrdiff_t k = 0; k < 400; ++k) index.push_back(k * 7 % 600);
    grit_sand_points q = some.views();
    q.index = index.data();
    ASSERT_EQ(update_all(sand, some, options, q), GRIT_OK) << some.error.message;
    for (std::size_t i = 0; i < many; ++i) {
        const bool taken =
            std::find(index.begin(), index.end(), static_cast<std::ptrdiff_t>(i)) != index.end();
        const WetBatch& expected = taken ? all : start;
        EXPECT_TRUE(same_bits(some.points[i], expected.points[i])) << i;
        EXPECT_EQ(some.p_w[i], expected.p_w[i]) << i;
        EXPECT_EQ(some.total[i], expected.total[i]) << i;
    }
}

TEST(UndrainedUpdate, OfFourComponentsIsThePlanePartOfSix) {
    const Sand sand = sand_named("lausitz");
    WetBatch six = random_wet_batch(sand, 186, true), four = six;
    const grit_sand_options options = options_with(1e-5, GRIT_TANGENT_CONSISTENT);
    grit_sand_points q = four.views();
    q.components = 4;
    ASSERT_EQ(update_all(sand, six, options, six.views()), GRIT_OK);
    ASSERT_EQ(update_all(sand, four, options, q), GRIT_OK);
    for (std::size_t i = 0; i < many; ++i) {
        EXPECT_EQ(four.p_w[i], six.p_w[i]);
        for (std::size_t c = 0; c < 6; ++c)
            EXPECT_EQ(four.total[i][c], c < 4 ? six.total[i][c] : 1.5);
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t c = 0; c < 4; ++c)
                EXPECT_EQ(four.tangents[i][6 * r + c], six.tangents[i][6 * r + c]);
        EXPECT_EQ(four.tangents[i][4], 1.25);
    }
}

TEST(UndrainedUpdate, ByNoStrainChangesNoBit) {
    Random random(187);
    for (int i = 0; i < 200; ++i) {
        Trial t = random_trial(random);
        const double nothing[6] = {};
        WetPoint end = t.start;
        ASSERT_EQ(update_undrained(t.sand, t.water, end, nothing).status, GRIT_OK);
        EXPECT_TRUE(same_bits(end.sand, t.start.sand));
        EXPECT_EQ(end.p_w, t.start.p_w);
    }
}

}  // namespace
