// SPDX-License-Identifier: BSD-3-Clause
// Normals from gradients: sign, constraints, sizes.
#include "support/clouds.hpp"

namespace {

using namespace tests;

struct Node {
    Vec3 a = Vec3::Zero(), b = Vec3::Zero(), given = Vec3::Zero();
    int fixed = 0;
    double scale = 0.0;
};

struct Result {
    Vec3 n = Vec3::Constant(7.0);
    grit_status status = GRIT_OK;
    grit_contact_normal_counts counts{sizeof(grit_contact_normal_counts), 0, 0, 0};
};

Result normal(int components, int source, const Node& x, double threshold = 0.0) {
    Result r;
    grit_contact_gradients q{};
    q.struct_size = sizeof q;
    q.components = components;
    q.source = source;
    q.gradient_a = grit_view_of(x.a.data(), 3, 1);
    q.gradient_b = grit_view_of(x.b.data(), 3, 1);
    q.given = grit_view_of(x.given.data(), 3, 1);
    q.scale = grit_view_of(&x.scale, 1, 1);
    q.threshold = threshold;
    q.fixed = &x.fixed;
    q.normal = grit_mutable_view_of(r.n.data(), 3, 1);
    grit_error error{};
    r.status = grit_contact_normals_from_gradients(1, &q, &r.counts, &error);
    EXPECT_EQ(r.status, GRIT_OK) << error.message;
    return r;
}

// sum_p V_p grad N of the tent functions of a grid of cell 1 at the node `at`.
Vec3 gradient(int components, const std::vector<Vec3>& particles, const Vec3& at) {
    Vec3 g = Vec3::Zero();
    for (const Vec3& x : particles)
        for (int c = 0; c < components; ++c) {
            double term = x[c] < at[c] ? 1.0 : -1.0;
            for (int other = 0; other < components; ++other) {
                const double distance = std::fabs(x[other] - at[other]);
                if (other != c) term *= 1.0 - distance;
                if (distance >= 1.0) term = 0.0;
            }
            g[c] += 0.125 * term;
        }
    return g;
}

// Two blocks that fill x < 0 and x > 0 around the node at the origin.
std::vector<Vec3> block(int components, double side) {
    std::vector<Vec3> particles;
    for (const double x : {0.25, 0.75})
        for (const double y : {-0.75, -0.25, 0.25, 0.75})
            for (const double z : {-0.75, -0.25, 0.25, 0.75})
                if (components == 3 || z == 0.25)
                    particles.push_back({side * x, y, components == 3 ? z : 0.0});
    return particles;
}

TEST(ContactNormal, PointsFromAToBFromEverySource) {
    for (const int components : {2, 3})
        for (const double side_of_a : {-1.0, 1.0}) {
            const auto of_a = block(components, side_of_a), of_b = block(components, -side_of_a);
            Node x;
            x.a = gradient(components, of_a, Vec3::Zero());
            x.b = gradient(components, of_b, Vec3::Zero());
            x.given = -side_of_a * 0.3 * Vec3::UnitX();
            const Vec3 expected = -side_of_a * Vec3::UnitX();
            for (const int source : {GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B,
                                     GRIT_CONTACT_NORMAL_AVERAGE, GRIT_CONTACT_NORMAL_GIVEN}) {
                const Vec3 n = normal(components, source, x).n;
                for (int c = 0; c < components; ++c)
                    EXPECT_NEAR(n[c], expected[c], 1e-15) << source;
            }
            Cloud cloud;
            for (const Vec3& p : of_a) cloud.push_back({p, A});
            for (const Vec3& p : of_b) cloud.push_back({p, B});
            EXPECT_NEAR((regressed(components, cloud) - expected).norm(), 0.0, 1e-12);
        }
}

TEST(ContactNormal, HasTheLengthOneAndTheDirectionOfItsSource) {
    Dice dice(1);
    for (const int components : {2, 3})
        for (int k = 0; k < 1000; ++k) {
            Node x;
            x.a = dice.log_uniform(1e-6, 1e6) * dice.direction(components);
            x.b = dice.log_uniform(1e-6, 1e6) * dice.direction(components);
            x.given = x.b;
            const auto check = [&](int source, const Vec3& along) {
                Vec3 n = normal(components, source, x).n;
                if (components == 2) n[2] = 0.0;
                EXPECT_NEAR((n - along.normalized()).norm(), 0.0, 6e-16) << source;
                EXPECT_NEAR(n.norm(), 1.0, 4e-16);
            };
            check(GRIT_CONTACT_NORMAL_OF_A, x.a);
            check(GRIT_CONTACT_NORMAL_OF_B, -x.b);
            check(GRIT_CONTACT_NORMAL_AVERAGE, x.a - x.b);
            check(GRIT_CONTACT_NORMAL_GIVEN, x.given);
        }
}

TEST(ContactNormal, OfSwappedBodiesIsTheOppositeBitwise) {
    Dice dice(2);
    for (int k = 0; k < 200; ++k) {
        Node x, swapped;
        swapped.b = x.a = dice.inside_ball(3);
        swapped.a = x.b = dice.inside_ball(3);
        const int sources[][2] = {{GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B},
                                  {GRIT_CONTACT_NORMAL_AVERAGE, GRIT_CONTACT_NORMAL_AVERAGE}};
        for (const auto& source : sources)
            EXPECT_EQ(normal(3, source[0], x).n, -normal(3, source[1], swapped).n);
    }
}

TEST(ContactNormal, LosesFixedComponentsBeforeItIsNormalised) {
    Node x;
    x.a = {3.0, 4.0, 12.0};
    x.fixed = GRIT_CONTACT_FIXED_1;
    EXPECT_EQ(normal(2, GRIT_CONTACT_NORMAL_OF_A, x).n, Vec3(0.0, 1.0, 7.0));
    x.fixed = GRIT_CONTACT_FIXED_3;
    EXPECT_NEAR((normal(3, GRIT_CONTACT_NORMAL_OF_A, x).n - Vec3(0.6, 0.8, 0.0)).norm(), 0.0,
                2e-16);
    x.fixed = GRIT_CONTACT_FIXED_1 | GRIT_CONTACT_FIXED_3;
    EXPECT_EQ(normal(3, GRIT_CONTACT_NORMAL_OF_A, x).n, Vec3(0.0, 1.0, 0.0));
    for (const int source :
         {GRIT_CONTACT_NORMAL_OF_B, GRIT_CONTACT_NORMAL_AVERAGE, GRIT_CONTACT_NORMAL_GIVEN}) {
        x.b = x.given = {-5.0, 2.0, 0.5};
        x.fixed = GRIT_CONTACT_FIXED_2;
        EXPECT_EQ(normal(3, source, x).n[1], 0.0);
        EXPECT_NEAR(normal(3, source, x).n.norm(), 1.0, 4e-16);
    }
}

TEST(ContactNormal, IsZeroAndCountedWhereItIsUndefined) {
    const auto expect_undefined = [](int source, const Node& x) {
        const Result r = normal(3, source, x);
        EXPECT_EQ(r.n, Vec3::Zero().eval());
        EXPECT_EQ(r.counts.undefined, 1);
        EXPECT_EQ(r.counts.defined, 0);
        EXPECT_EQ(r.counts.failed, 0);
    };
    Node x;
    for (int source = GRIT_CONTACT_NORMAL_OF_A; source <= GRIT_CONTACT_NORMAL_GIVEN; ++source)
        expect_undefined(source, x);
    x.a = x.b = {1.0, 2.0, 3.0};
    expect_undefined(GRIT_CONTACT_NORMAL_AVERAGE, x);  // they cancel
    x.b[0] += 1e-8;
    expect_undefined(GRIT_CONTACT_NORMAL_AVERAGE, x);
    x.fixed = 7;
    expect_undefined(GRIT_CONTACT_NORMAL_OF_A, x);
    x.a = {1.0, 1e-9, 0.0};  // on the axis: what is left is roundoff
    x.fixed = GRIT_CONTACT_FIXED_1;
    expect_undefined(GRIT_CONTACT_NORMAL_OF_A, x);
    x.a[1] = 1e-7;
    EXPECT_EQ(normal(3, GRIT_CONTACT_NORMAL_OF_A, x).n, Vec3(0.0, 1.0, 0.0));
    EXPECT_EQ(normal(3, GRIT_CONTACT_NORMAL_OF_A, x, 1e-6).n, Vec3::Zero().eval());
    x.fixed = 0;
    x.scale = 1e9;  // inside a body
    expect_undefined(GRIT_CONTACT_NORMAL_OF_A, x);
    x.scale = 1e7;
    EXPECT_EQ(normal(3, GRIT_CONTACT_NORMAL_OF_A, x).counts.defined, 1);
}

TEST(ContactNormal, IsTheSameForGradientsOfAnySize) {
    Dice dice(3);
    for (int k = 0; k < 100; ++k) {
        Node x;
        x.a = dice.direction(3);
        x.b = dice.direction(3);
        for (const int source :
             {GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B, GRIT_CONTACT_NORMAL_AVERAGE}) {
            const Vec3 n = normal(3, source, x).n;
            for (const double size : {0x1p-960, 0x1p-500, 0x1p500, 0x1p980}) {
                Node y = x;
                y.a *= size;
                y.b *= size;
                y.scale = 1e5 * size;
                EXPECT_EQ(normal(3, source, y).n, n) << size;
                y.scale = 1e9 * size;
                EXPECT_EQ(normal(3, source, y).counts.undefined, 1) << size;
            }
        }
    }
    Node tiny;
    tiny.a = {5e-324, 5e-324, 0.0};
    EXPECT_NEAR(normal(3, GRIT_CONTACT_NORMAL_OF_A, tiny).n[0], std::sqrt(0.5), 2e-16);
}

TEST(NormalFromGradients, IsThereWhateverTheirSize) {
    for (const double size : {1e-300, 1e-6, 0.01, 0.5, 1.0, 2.0, 1e300}) {
        Node x;
        x.a = Vec3(size, -size, 0.0);
        const Result r = normal(2, GRIT_CONTACT_NORMAL_OF_A, x);
        EXPECT_NEAR(r.n.head<2>().norm(), 1.0, 1e-15) << size;
    }
}

}  // namespace
