// SPDX-License-Identifier: BSD-3-Clause
// Normals by regression: what is known of the plane that parts two clouds.
#include <grit/version.h>

#include "../larger.hpp"
#include "support/clouds.hpp"

namespace {

using namespace tests;

// Each that this machine has, in turn.
int instruction_set(int k) { return GRIT_ISA_BASELINE + k % grit_instruction_set(); }

double difference(const Vec3& a, const Vec3& b) { return (a - b).lpNorm<Eigen::Infinity>(); }

// Minimum of the penalised loss as the header states it, in long double and without any thought of
// speed: full Newton, halved until the loss falls, until its gradient is roundoff.
Vec3 minimiser(int components, const Cloud& cloud, double ridge, double length) {
    using Real = long double;
    using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    const int D = components;
    Real total[2] = {0, 0};
    for (const Particle& p : cloud) total[p.body] += p.weight;
    const auto loss = [&](const Vector& u, Vector* gradient, Matrix* hessian) {
        Real value = ridge / 2 * u.head(D).squaredNorm();
        if (gradient) {
            *gradient = ridge * u;
            (*gradient)[D] = 0;
            *hessian = ridge * Matrix::Identity(D + 1, D + 1);
            (*hessian)(D, D) = 0;
        }
        for (const Particle& p : cloud) {
            Vector row(D + 1);
            for (int c = 0; c < D; ++c) row[c] = Real(p.x[c]) / length;
            row[D] = 1;
            const Real y = p.body == B ? 1 : -1;
            const Real m = y * u.dot(row), share = Real(p.weight) / total[p.body] / 2;
            const Real wrong = 1 / (1 + std::exp(m));  // probability of the other body
            value += share * (m > 0 ? std::log1p(std::exp(-m)) : std::log1p(std::exp(m)) - m);
            if (gradient) {
                *gradient -= share * wrong * y * row;
                *hessian += share * wrong * (1 - wrong) * row * row.transpose();
            }
        }
        return value;
    };
    Vector u = Vector::Zero(D + 1), g;
    Matrix H;
    for (int k = 0; k < 200; ++k) {
        const Real value = loss(u, &g, &H);
        if (g.norm() < 1e-17L) break;
        const Vector step = -H.ldlt().solve(g);
        Real share = 1;
        while (share > 1e-6L && loss(u + share * step, nullptr, nullptr) > value + 1e-18L)
            share /= 2;
        u += share * step;
    }
    EXPECT_LT(g.norm(), 1e-15L);
    Vec3 n = Vec3::Zero();
    for (int c = 0; c < D; ++c) n[c] = static_cast<double>(u[c] / u.head(D).norm());
    return n;
}

TEST(RegressionNormal, MinimisesThePenalisedLossOfTheHeader) {
    Dice dice(20);
    for (const int components : {2, 3})
        for (int k = 0; k < 300; ++k) {
            const double overlap = k % 3 == 0 ? 0.0 : dice.uniform(0.0, 1.0);
            Cloud cloud = parted_cloud(components, 4 + dice.below(40), overlap, dice);
            if (k % 2)
                for (Particle& p : cloud) p.weight = dice.log_uniform(0.1, 10.0);
            const double ridge = dice.log_uniform(1e-5, 10.0), length = dice.uniform(0.3, 3.0);
            const Vec3 n = regressed(components, cloud, ridge, length, 0, instruction_set(k));
            EXPECT_LT(difference(n, minimiser(components, cloud, ridge, length)), 2e-11)
                << components << " ridge " << ridge << " particles " << cloud.size();
            EXPECT_NEAR(n.norm(), 1.0, 4e-16);
        }
}

TEST(RegressionNormal, UsesARidgeOfOneThousandthUnlessToldOtherwise) {
    Dice dice(21);
    const Cloud cloud = parted_cloud(2, 16, 0.2, dice);
    EXPECT_EQ(regressed(2, cloud), regressed(2, cloud, 1e-3));
    EXPECT_NE(regressed(2, cloud), regressed(2, cloud, 2e-3));
}

// B is the mirror image of A: whatever A is, nothing but the mirror's normal can come out.
TEST(RegressionNormal, FindsThePlantedPlaneOfMirroredCloudsApartOrOverlapping) {
    Dice dice(22);
    for (const int components : {2, 3})
        for (int k = 0; k < 200; ++k) {
            const Vec3 n = dice.direction(components), at = dice.inside_ball(components);
            Cloud cloud;
            double centre = 0.0;
            for (int p = 0; p < 8; ++p) {
                Vec3 x = dice.inside_ball(components);
                const double reach = k % 2 ? 0.0 : 0.3;  // beyond the mirror
                x -= std::max(0.0, x.dot(n) - reach) * n;
                centre += x.dot(n);
                cloud.push_back({at + x, A});
                cloud.push_back({at + x - 2.0 * x.dot(n) * n, B});
            }
            EXPECT_LT(difference(regressed(components, cloud), (centre < 0.0 ? 1.0 : -1.0) * n),
                      1e-11);
        }
}

TEST(RegressionNormal, IsWithinDegreesOfThePlaneThatPartsParticlesOnARegularGrid) {
    Dice dice(23);
    double sum = 0.0, worst = 0.0;
    constexpr int nodes = 1000;
    for (int k = 0; k < nodes; ++k) {
        const Vec3 n = dice.direction(2);
        const double offset = dice.uniform(-0.4, 0.4);
        Cloud cloud;
        for (int p = 0; p < 16; ++p) {
            const int row = p / 4;
            const Vec3 x(0.5 * (p % 4) - 0.75, 0.5 * row - 0.75, 0.0);
            cloud.push_back({x, x.dot(n) > offset ? B : A});
        }
        const double angle = std::acos(std::min(1.0, regressed(2, cloud).dot(n)));
        sum += angle;
        worst = larger(worst, angle);
    }
    EXPECT_LT(sum / nodes, 0.1);  // 5 degrees and a bit: particles half a cell apart know no more
    EXPECT_LT(worst, 0.4);
}

TEST(RegressionNormal, OfASmallRidgeIsTheWidestGapAndOfALargeOneTheLineOfCentroids) {
    const Cloud cloud = {{{0.0, 0.0, 0.0}, A}, {{1.0, 0.0, 0.0}, B}, {{3.0, 10.0, 0.0}, B}};
    EXPECT_LT(difference(regressed(2, cloud, 1e-6), Vec3::UnitX()), 0.03);
    EXPECT_LT(difference(regressed(2, cloud, 1e3), Vec3(2.0, 5.0, 0.0).normalized()), 0.01);
}

TEST(RegressionNormal, TurnsWithTheCloudsAndDoesNotDependOnOriginOrUnit) {
    Dice dice(24);
    for (const int components : {2, 3})
        for (int k = 0; k < 100; ++k) {
            const Cloud cloud = parted_cloud(components, 16, k % 2 ? 0.3 : 0.0, dice);
            const Vec3 n = regressed(components, cloud);
            const Eigen::Matrix3d Q = dice.rotation(components);
            Vec3 shift = 100.0 * dice.direction(components);
            Cloud turned = cloud, shifted = cloud, longer = cloud;
            for (Particle& p : turned) p.x = Q * p.x;
            for (Particle& p : shifted) p.x += shift;
            for (Particle& p : longer) p.x *= 1024.0;
            EXPECT_LT(difference(regressed(components, turned), Q * n), 2e-12);
            EXPECT_LT(difference(regressed(components, shifted), n), 1e-11);
            EXPECT_EQ(regressed(components, longer, 0.0, 1024.0), n);
        }
}

// Found by torture: far particles were told from the one that came first.
TEST(RegressionNormal, OfAWideCloudIsTakenInAnyOrderOrRefusedInAny) {
    Dice dice(31);
    for (const double wide : {199.0, 201.0}) {
        Cloud cloud = {
            {{0.0, 0.0, 0.0}, A}, {{-0.5 * wide, 0.0, 0.0}, A}, {{0.5 * wide, 1.0, 0.0}, B}};
        Vec3 first = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            Clouds x(2, {cloud});
            EXPECT_EQ(x.regress(x.views()), wide > 200.0 ? GRIT_BAD_STATE : GRIT_OK)
                << wide << ' ' << k;
            if (k == 0) first = x.normal_at(0);
            EXPECT_LT(difference(x.normal_at(0), first), 1e-11) << wide << ' ' << k;
            std::rotate(cloud.begin(), cloud.begin() + 1, cloud.end());
        }
    }
}

TEST(RegressionNormal, OfSwappedBodiesIsTheOppositeBitwise) {
    Dice dice(25);
    for (const int components : {2, 3})
        for (int k = 0; k < 50; ++k) {
            Cloud cloud = parted_cloud(components, 5 + k, 0.2, dice);
            const Vec3 n = regressed(components, cloud);
            for (Particle& p : cloud) p.body = 1 - p.body;
            EXPECT_EQ(regressed(components, cloud), -n);
        }
}

TEST(RegressionNormal, OfHalfASymmetricCloudWithItsFixedComponentsIsThatOfTheWhole) {
    Dice dice(26);
    for (const int components : {2, 3})
        for (int k = 0; k < 100; ++k) {
            const Cloud half = parted_cloud(components, 10, k % 2 ? 0.3 : 0.0, dice);
            const int across = k % components;
            Cloud whole = half;
            for (Particle p : half) {
                p.x[across] = -p.x[across];
                whole.push_back(p);
            }
            const Vec3 n = regressed(components, half, 0.0, 1.0, 1 << across);
            EXPECT_EQ(n[across], 0.0);
            EXPECT_LT(difference(n, regressed(components, whole)), 2e-11);
        }
    const Cloud two = {{{0.0, 0.0, 0.0}, A}, {{1.0, -2.0, 3.0}, B}};
    EXPECT_EQ(regressed(3, two, 0.0, 1.0, 5), Vec3(0.0, -1.0, 0.0));
    EXPECT_EQ(regressed(3, two, 0.0, 1.0, 7), Vec3::Zero().eval());
}

TEST(RegressionNormal, CountsAParticleByItsWeight) {
    Dice dice(27);
    for (int k = 0; k < 50; ++k) {
        Cloud once = parted_cloud(3, 12, 0.3, dice);
        Cloud twice = once, absent = once, listed = once, scaled = once;
        once[3].weight = 2.0;
        twice.push_back(twice[3]);
        EXPECT_LT(difference(regressed(3, once), regressed(3, twice)), 2e-11);
        absent.erase(absent.begin() + 5);
        listed[5].weight = 0.0;
        EXPECT_EQ(regressed(3, listed), regressed(3, absent));
        const Vec3 n = regressed(3, scaled);
        for (Particle& p : scaled) p.weight = 0x1p300;
        EXPECT_EQ(regressed(3, scaled), n);
    }
}

TEST(RegressionNormal, LiesOnTheLineOfCollinearClouds) {
    Dice dice(28);
    for (const int components : {2, 3})
        for (const double overlap : {0.0, 0.3}) {
            const Vec3 n = dice.direction(components);
            Cloud cloud;
            for (int p = 0; p < 12; ++p) {
                const double along = p - 5.5;
                cloud.push_back({0.2 * along * n, along + overlap * (p % 2 ? 9 : 0) > 0.0 ? B : A});
            }
            EXPECT_LT(difference(regressed(components, cloud), n), 1e-12);
        }
    EXPECT_EQ(regressed(2, {{{0.0, 0.0, 0.0}, B}, {{0.0, 1.0, 0.0}, A}}), Vec3(0.0, -1.0, 0.0));
}

TEST(RegressionNormal, IsZeroWhereOneBodyIsAloneOrTheCloudsDoNotDiffer) {
    Dice dice(29);
    for (const int components : {2, 3}) {
        const Vec3 x = dice.inside_ball(components);
        const Vec3 y = dice.inside_ball(components), z = dice.inside_ball(components);
        const Vec3 zero = Vec3::Zero();
        EXPECT_EQ(regressed(components, {}), zero);
        EXPECT_EQ(regressed(components, {{x, A}}), zero);
        EXPECT_EQ(regressed(components, {{x, B}, {y, B}, {z, B}}), zero);
        EXPECT_EQ(regressed(components, {{x, A}, {y, B, 0.0}}), zero);
        EXPECT_EQ(regressed(components, {{x, A}, {x, B}}), zero);
        EXPECT_EQ(regressed(components, {{x, A}, {x, B}, {x, B}}), zero);
        Cloud coincident;  // pairs of one particle of each body, in an order of their own
        for (int p = 0; p < 11; ++p)
            coincident.push_back({dice.inside_ball(components), A, dice.uniform(0.1, 1.0)});
        for (std::size_t p = 0; p < 11; ++p) {
            coincident.push_back(coincident[7 * p % 11]);
            coincident.back().body = B;
        }
        for (const double ridge : {1e-6, 1e-3, 1.0, 1e3})
            EXPECT_EQ(regressed(components, coincident, ridge), zero);
    }
}

TEST(RegressionNormal, ConvergesForCloudsOfAnyShapeAndRidge) {
    Dice dice(30);
    for (const int components : {2, 3})
        for (int k = 0; k < 3000; ++k) {
            Cloud cloud =
                parted_cloud(components, 2 + dice.below(60), dice.uniform(-0.2, 1.0), dice);
            Vec3 shape = Vec3::Ones();
            for (int c = 0; c < components; ++c) shape[c] = dice.log_uniform(1e-6, 40.0);
            for (Particle& p : cloud) {
                p.x = p.x.cwiseProduct(shape);
                p.weight = dice.log_uniform(1e-6, 1e6);
            }
            const double ridge = dice.log_uniform(1e-6, 1e3);
            const Vec3 n = regressed(components, cloud, ridge, 1.0, 0, instruction_set(k));
            EXPECT_TRUE(std::fabs(n.norm() - 1.0) < 1e-14) << k;
        }
}

}  // namespace
