// SPDX-License-Identifier: BSD-3-Clause
// Invariants and start-up helpers.
#include "support/random_sand.hpp"
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

grit_sand_invariants invariants_of(const Sand& sand, const State& x) {
    grit_sand_invariants i{};
    i.struct_size = sizeof i;
    EXPECT_EQ(grit_sand_invariants_of(sand, voigt_stress(x.T).data(), state_array(x).data(), &i),
              GRIT_OK);
    return i;
}

TEST(Invariants, OfTriaxialCompressionAndExtensionAreTheHandWorkedOnes) {
    const Sand& sand = four_sands()[0];
    State x;
    x.e = 0.7;
    x.T = principal(-300.0, -100.0, -100.0);
    grit_sand_invariants i = invariants_of(sand, x);
    EXPECT_NEAR(i.p, 500.0 / 3.0, 1e-12);
    EXPECT_NEAR(i.q, 200.0, 1e-12);
    EXPECT_NEAR(i.lode_angle, 0.0, 1e-12);
    EXPECT_NEAR(i.mobilised_friction_angle, M_PI / 6.0, 1e-12);
    EXPECT_NEAR(i.tan_psi, std::sqrt(3.0) * std::sqrt(2.0 / 3.0) * 200.0 / 500.0, 1e-12);
    x.T = principal(-300.0, -100.0, -300.0);
    i = invariants_of(sand, x);
    EXPECT_NEAR(i.lode_angle, M_PI / 3.0, 1e-12);
    EXPECT_NEAR(i.q, 200.0, 1e-12);
    EXPECT_NEAR(i.mobilised_friction_angle, M_PI / 6.0, 1e-12);
}

TEST(Invariants, AgreeWithThePrincipalStresses) {
    for (const Sand& sand : four_sands()) {
        Random random(30);
        for (int k = 0; k < 50; ++k) {
            const State x = random_state(sand, random);
            const grit_sand_invariants i = invariants_of(sand, x);
            const Eigen::Vector3d s =
                Eigen::SelfAdjointEigenSolver<Full>(full(x.T)).eigenvalues();  // increasing
            EXPECT_NEAR(std::sin(i.mobilised_friction_angle), (s[0] - s[2]) / (s[0] + s[2]), 1e-12);
            EXPECT_NEAR(i.q, std::sqrt(1.5) * deviator(x.T).norm(), 1e-10);
            const double b = (s[1] - s[2]) / (s[0] - s[2]);  // 0 compression, 1 extension
            const double theta = std::atan2(std::sqrt(3.0) * b, 2.0 - b);
            EXPECT_NEAR(i.lode_angle, theta, 1e-12);
            EXPECT_NEAR(i.rho, x.h.norm() / sand.p.elastic_strain_radius, 1e-14);
            const VoidRatios e = void_ratios(sand, i.p);
            EXPECT_NEAR(i.relative_density, (e.e_c - x.e) / (e.e_c - e.e_d), 1e-12);
        }
    }
}

// Where two principal stresses nearly coincide, in axes of any direction, the Lode angle is told to roundoff:
// by the determinant alone it would be off by the root of it, 1e-8.
TEST(Invariants, TellTheLodeAngleToRoundoffWhereTwoPrincipalStressesCoincide) {
    const Sand& sand = four_sands()[0];
    Random random(31);
    for (const double theta : {0.0, 1e-12, 1e-9, 1e-6, 1e-3})
        for (const bool extension : {false, true})
            for (int k = 0; k < 20; ++k) {
                const double angle = extension ? M_PI / 3.0 - theta : theta;
                State x;
                x.e = 0.7;
                const double third = 2.0 * M_PI / 3.0, from_largest = M_PI / 3.0 - angle;
                x.T = rotated(random.rotation(),
                              principal(-100.0 + 60.0 * std::cos(from_largest),
                                        -100.0 + 60.0 * std::cos(from_largest - third),
                                        -100.0 + 60.0 * std::cos(from_largest + third)));
                const grit_sand_invariants i = invariants_of(sand, x);
                EXPECT_NEAR(i.lode_angle, angle, 1e-14);
                const double largest = std::cos(angle - M_PI / 3.0), smallest = -std::cos(angle);
                EXPECT_NEAR(std::sin(i.mobilised_friction_angle),
                            60.0 * (largest - smallest) / (200.0 - 60.0 * (largest + smallest)),
                            1e-14);
            }
}

// A principal stress that pulls: no circle through the origin bounds it.
TEST(Invariants, HaveARightAngleOfFrictionBeyondAllCones) {
    const Sand& sand = four_sands()[0];
    State x;
    x.e = 0.7;
    for (const double pull : {1e-9, 1.0, 2.0, 50.0}) {
        x.T = principal(-100.0, -30.0, pull);
        EXPECT_EQ(invariants_of(sand, x).mobilised_friction_angle, std::asin(1.0)) << pull;
    }
}

// Members behind the caller's struct_size are left alone.
TEST(Invariants, ReachAsFarAsTheCallersStruct) {
    const Sand& sand = four_sands()[0];
    State x;
    x.e = 0.7;
    x.T = principal(-300.0, -100.0, -150.0);
    const grit_sand_invariants whole = invariants_of(sand, x);
    grit_sand_invariants part{};
    part.struct_size = offsetof(grit_sand_invariants, relative_density);
    part.relative_density = 7.0;
    ASSERT_EQ(grit_sand_invariants_of(sand, voigt_stress(x.T).data(), state_array(x).data(), &part),
              GRIT_OK);
    EXPECT_EQ(part.relative_density, 7.0);
    EXPECT_EQ(part.rho, whole.rho);
    EXPECT_EQ(part.mobilised_friction_angle, whole.mobilised_friction_angle);
}

TEST(VoidRatios, FallWithPressureByBauersLaw) {
    for (const Sand& sand : four_sands())
        for (const double p : {0.0, 1.0, 100.0, 1e4}) {
            const double fall =
                std::exp(-std::pow(3.0 * p / sand.p.granulate_hardness, sand.p.stiffness_exponent));
            const VoidRatios e = void_ratios(sand, p);
            EXPECT_NEAR(e.e_i, sand.p.loosest_void_ratio * fall, 1e-14);
            EXPECT_NEAR(e.e_c, sand.p.critical_void_ratio * fall, 1e-14);
            EXPECT_NEAR(e.e_d, sand.p.densest_void_ratio * fall, 1e-14);
            double value = 0.0;
            ASSERT_EQ(grit_sand_void_ratio_at_pressure(sand, 0.7, p, &value), GRIT_OK);
            EXPECT_NEAR(value, 0.7 * fall, 1e-14);
        }
}

TEST(VoidRatios, AreRefusedAtNegativePressureOrForNoVoids) {
    double e[3];
    for (const double p : {-1.0, std::nan(""), HUGE_VAL})
        EXPECT_EQ(grit_sand_void_ratios(four_sands()[0], p, e), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_void_ratio_at_pressure(four_sands()[0], 0.0, 1.0, e), GRIT_BAD_CALL);
}

TEST(StressAtRest, IsTheWeightAboveAndK0TimesIt) {
    const Sand& sand = four_sands()[0];
    double s[6];
    ASSERT_EQ(grit_sand_stress_at_rest(sand, 18.0, 5.0, 10.0, 0.4, 1, s), GRIT_OK);
    const double expected[6] = {-40.0, -100.0, -40.0, 0.0, 0.0, 0.0};
    for (int c = 0; c < 6; ++c) EXPECT_DOUBLE_EQ(s[c], expected[c]);
    ASSERT_EQ(grit_sand_stress_at_rest(sand, 18.0, 5.0, 10.0, -1.0, 2, s), GRIT_OK);
    EXPECT_NEAR(s[0], -100.0 * (1.0 - std::sin(sand.p.critical_friction_angle)), 1e-12);
    EXPECT_DOUBLE_EQ(s[2], -100.0);
    EXPECT_EQ(grit_sand_stress_at_rest(sand, 18.0, -5.0, 0.0, 0.4, 2, s), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_stress_at_rest(sand, 18.0, 5.0, 0.0, 0.4, 3, s), GRIT_BAD_CALL);
}

TEST(Mobilise, SetsTheMemoryAlongADirection) {
    for (const Sand& sand : four_sands()) {
        Random random(31);
        const Vec D = 3.0 * random.direction();
        double state[8] = {9, 9, 9, 9, 9, 9, 0.7, 0.1};
        ASSERT_EQ(grit_sand_mobilise(sand, voigt_strain(D).data(), 0.6, state), GRIT_OK);
        const Vec expected = 0.6 * sand.p.elastic_strain_radius * D.normalized();
        EXPECT_LE((strain_from(state) - expected).norm(), 1e-15 * sand.p.elastic_strain_radius);
        EXPECT_EQ(state[GRIT_SAND_VOID_RATIO], 0.7);
        EXPECT_EQ(state[GRIT_SAND_SEPARATION], 0.1);
        const double nothing[6] = {};
        EXPECT_EQ(grit_sand_mobilise(sand, nothing, 1.0, state), GRIT_BAD_CALL);
        EXPECT_EQ(grit_sand_mobilise(sand, voigt_strain(D).data(), 1.1, state), GRIT_BAD_CALL);
    }
}

// Uniaxial strain along any axis, both ways, with and without intergranular strain.
TEST(WaveModulus, BoundsTheStiffnessInEveryDirection) {
    for (const Sand& sand : four_sands())
        for (const auto igs : {Intergranular::on, Intergranular::off}) {
            Random random(32);
            double closest = 0.0;
            for (int i = 0; i < 500; ++i) {
                State x = random_state(sand, random);
                const Eigen::Vector3d n(random.normal(), random.normal(), random.normal());
                const Vec D = mandel(n.normalized() * n.normalized().transpose());
                double modulus = 0.0;
                ASSERT_EQ(grit_sand_wave_modulus(sand, igs == Intergranular::off,
                                                 voigt_stress(x.T).data(), x.e, &modulus),
                          GRIT_OK);
                if (i % 2) x.h.setZero();
                for (const double sign : {-1.0, 1.0}) {
                    const double stiffness = D.dot(rate(sand, x, sign * D, igs).T) * sign;
                    closest = std::fmax(closest, stiffness / modulus);
                }
            }
            EXPECT_LE(closest, 1.0 + 1e-12) << sand.name;
            EXPECT_GE(closest, 0.8) << sand.name;  // and is no idle bound
        }
}

// Sands of any parameters, n along an axis of stress or not, and |h| = R in the plane of nn and of what T_hat has across
// it: where L:h is largest and least along n.
TEST(WaveModulus, BoundsTheStiffnessAlongTheWorstMemory) {
    Random random(35);
    double closest = 0.0;
    for (int i = 0; i < 400; ++i) {
        const Sand sand =
            i % 4 ? random_sand(random) : four_sands()[static_cast<std::size_t>(i / 4 % 4)];
        const double p = 1e-4 * sand.p.granulate_hardness * random.log_uniform(1e-2, 1.0);
        const Vec direction = deviator(random.direction()).normalized();
        State x;
        x.T = stress_with(p, random.uniform(0.0, 0.95) * critical_obliquity(sand, direction),
                          direction) +
              sand.p.pressure_shift * identity();
        x.e = void_ratio_at(sand, p, random.uniform(0.2, 1.1));
        const Eigen::SelfAdjointEigenSolver<Full> principal_axes(full(x.T));
        const Eigen::Vector3d n =
            i % 3 ? Eigen::Vector3d(principal_axes.eigenvectors().col(i % 2 ? 0 : 2))
                  : Eigen::Vector3d(random.normal(), random.normal(), random.normal());
        const Vec D = mandel(n.normalized() * n.normalized().transpose());
        Vec across = x.T - x.T.dot(D) * D;
        across /= std::fmax(across.norm(), 1e-300);
        double modulus = 0.0;
        ASSERT_EQ(grit_sand_wave_modulus(sand, 0, voigt_stress(x.T).data(), x.e, &modulus),
                  GRIT_OK);
        for (int k = 0; k < 72; ++k) {
            const double angle = k * M_PI / 36.0;
            x.h = sand.p.elastic_strain_radius * (std::cos(angle) * D + std::sin(angle) * across);
            for (const double sign : {-1.0, 1.0})
                closest = std::fmax(closest, D.dot(rate(sand, x, sign * D).T) * sign / modulus);
        }
    }
    EXPECT_LE(closest, 1.0 + 1e-12);
    EXPECT_GE(closest, 0.99);
}

// Its border is the one of updates: to 1.01 R it is scaled back, beyond it is refused.
TEST(Operators, TakeTheMemoryThatUpdatesTake) {
    const Sand& sand = four_sands()[0];
    Random random(36);
    State x = random_state(sand, random);
    const Vec D = random.direction();
    x.h = sand.p.elastic_strain_radius * random.direction();
    const Rate at_R = rate(sand, x, D);
    const Mat M_at_R = stiffness_M(sand, x, D);
    x.h *= 1.009;
    EXPECT_LE((rate(sand, x, D).T - at_R.T).norm(), 1e-12 * at_R.T.norm());
    EXPECT_LE((rate(sand, x, D).h - at_R.h).norm(), 1e-12 * at_R.h.norm());
    EXPECT_LE((stiffness_M(sand, x, D) - M_at_R).norm(), 1e-12 * M_at_R.norm());
    x.h *= 1.02 / 1.009;
    double T_rate[6] = {7, 7, 7, 7, 7, 7}, M[36] = {7};
    const auto call = [&](int off) {
        return grit_sand_rate(sand, off, voigt_stress(x.T).data(), state_array(x).data(),
                              voigt_strain(D).data(), T_rate, nullptr);
    };
    EXPECT_EQ(call(0), GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_intergranular_stiffness(sand, voigt_stress(x.T).data(),
                                                state_array(x).data(), voigt_strain(D).data(), M),
              GRIT_BAD_CALL);
    EXPECT_EQ(T_rate[0], 7);
    EXPECT_EQ(M[0], 7);
    EXPECT_EQ(call(1), GRIT_OK);  // without h it does not matter
}

// n points with 4 or 6 components, some of them separated or outside of the cone, as structure of arrays.
struct ManyPoints {
    static constexpr std::ptrdiff_t n = 203;
    std::ptrdiff_t components;
    std::vector<double> stress, state, moduli;
    grit_sand_points points{};

    ManyPoints(const Sand& sand, unsigned seed, int count = 4)
        : components(count), stress(static_cast<std::size_t>(count * n)), state(8 * n),
          moduli(n, -1.0) {
        Random random(seed);
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const State x = random_state(sand, random);
            const double scale = i % 20 == 7 ? 0.0 : 1.0, tension = i % 20 == 11 ? -1.0 : 1.0;
            const auto voigt = voigt_stress(x.T);
            for (std::ptrdiff_t c = 0; c < components; ++c)
                stress[static_cast<std::size_t>(c * n + i)] = scale * tension *
                                                              (i % 20 == 3 && c == 0 ? 0.1 : 1.0) *
                                                              voigt[static_cast<std::size_t>(c)];
            state[static_cast<std::size_t>(GRIT_SAND_VOID_RATIO * n + i)] = x.e;
        }
        points.struct_size = sizeof points;
        points.components = count;
        points.stress = grit_mutable_view_of(stress.data(), 1, n);
        points.state = grit_mutable_view_of(state.data(), 1, n);
    }
    double alone(const Sand& sand, int off, std::size_t i) const {
        double voigt[6] = {};
        for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
            voigt[c] = stress[c * n + i];
        double modulus = 0.0;
        EXPECT_EQ(
            grit_sand_wave_modulus(sand, off, voigt, state[GRIT_SAND_VOID_RATIO * n + i], &modulus),
            GRIT_OK);
        return modulus;
    }
};

TEST(WaveModulus, OfManyPointsIsThatOfEach) {
    for (const Sand& sand : four_sands())
        for (const int off : {0, 1})
            for (int isa = GRIT_ISA_BASELINE; isa <= GRIT_ISA_AVX512; ++isa) {
                ManyPoints q(sand, 33, off == 0 ? 4 : 6);
                grit_sand_options options;
                grit_sand_options_init(&options, sizeof options);
                options.intergranular_off = off;
                options.instruction_set = isa;
                const grit_status status =
                    grit_sand_wave_moduli(sand, &options, q.n, &q.points, q.moduli.data(), nullptr);
                if (status == GRIT_BAD_CALL && isa > GRIT_ISA_BASELINE)
                    continue;  // not on this machine
                ASSERT_EQ(status, GRIT_OK);
                for (std::size_t i = 0; i < q.moduli.size(); ++i)
                    EXPECT_NEAR(q.moduli[i] / q.alone(sand, off, i), 1.0, 1e-13) << i;
                // A point's bits depend neither on n nor on its place.
                const std::ptrdiff_t order[] = {150, 7, 202, 11, 3};
                q.points.index = order;
                double few[5];
                ASSERT_EQ(grit_sand_wave_moduli(sand, &options, 5, &q.points, few, nullptr),
                          GRIT_OK);
                for (int i = 0; i < 5; ++i)
                    EXPECT_EQ(few[i], q.moduli[static_cast<std::size_t>(order[i])]);
            }
}

TEST(WaveModulus, OfABadPointIsNoNumberAndTheOthersAreThere) {
    const Sand sand = four_sands().front();
    ManyPoints q(sand, 34), good(sand, 34);
    ASSERT_EQ(grit_sand_wave_moduli(sand, nullptr, q.n, &good.points, good.moduli.data(), nullptr),
              GRIT_OK);
    q.stress[17] = NAN;
    q.state[GRIT_SAND_VOID_RATIO * q.n + 40] = -0.5;
    grit_error error;
    EXPECT_EQ(grit_sand_wave_moduli(sand, nullptr, q.n, &q.points, q.moduli.data(), &error),
              GRIT_BAD_STATE);
    EXPECT_EQ(error.point, 17);
    for (std::size_t i = 0; i < q.moduli.size(); ++i)
        if (i == 17 || i == 40) EXPECT_TRUE(std::isnan(q.moduli[i]));
        else EXPECT_EQ(q.moduli[i], good.moduli[i]) << i;
    q.stress[17] = -1.0;
    EXPECT_EQ(grit_sand_wave_moduli(sand, nullptr, q.n, &q.points, q.moduli.data(), &error),
              GRIT_BAD_STATE);
    EXPECT_STREQ(
        error.message,
        "point 40: no wave modulus: stress must be finite and the void ratio in (0, 1e+09], "
        "got -0.5");
}

TEST(WaveModulus, RefusesCallsThatMakeNoSense) {
    const Sand sand = four_sands().front();
    ManyPoints q(sand, 35);
    const auto refused = [&](const char* why, const grit_sand_points& points, std::ptrdiff_t n,
                             double* moduli) {
        grit_error error;
        EXPECT_EQ(grit_sand_wave_moduli(sand, nullptr, n, &points, moduli, &error), GRIT_BAD_CALL);
        EXPECT_NE(std::string(error.message).find(why), std::string::npos) << error.message;
    };
    grit_sand_points wrong = q.points;
    wrong.components = 3;
    refused("components", wrong, q.n, q.moduli.data());
    wrong = q.points;
    wrong.stress.base = nullptr;
    refused("stress has no base", wrong, q.n, q.moduli.data());
    wrong = q.points;
    wrong.state.base = nullptr;
    refused("state has no base", wrong, q.n, q.moduli.data());
    refused("moduli is null", q.points, q.n, nullptr);
    refused("n must be >= 0", q.points, -1, q.moduli.data());
    EXPECT_EQ(grit_sand_wave_moduli(nullptr, nullptr, 0, &q.points, nullptr, nullptr),
              GRIT_BAD_CALL);
    EXPECT_EQ(grit_sand_wave_moduli(sand, nullptr, 0, &q.points, nullptr, nullptr), GRIT_OK);
}

}  // namespace
