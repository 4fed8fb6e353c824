// SPDX-License-Identifier: BSD-3-Clause
// Dual through the kernel's stress rate, against the paper's equations on Eigen's AutoDiffScalar.
#define GRIT_TARGET kernel_test
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <unsupported/Eigen/AutoDiff>

#include "support/dual.hpp"
#include "umat/model/strain_directions.hpp"
#include "umat/model/stress_rate.hpp"

#include "tests/umat/support/paper.hpp"
#include "tests/umat/support/states.hpp"

namespace {

namespace kernel = grit::kernel_test;
using namespace tests;
using kernel::Dual;
using Scalar = Eigen::AutoDiffScalar<Vec>;

paper::Vector<Scalar> variables(const Vec& A) {
    paper::Vector<Scalar> x;
    for (int i = 0; i < 6; ++i) x[i] = Scalar(A[i], 6, i);
    return x;
}
paper::Vector<Scalar> constants(const Vec& A) {
    paper::Vector<Scalar> x;
    for (int i = 0; i < 6; ++i) x[i] = Scalar(A[i], Vec(Vec::Zero()));
    return x;
}
kernel::Tensor<Dual> dual(const Vec& A, bool variable) {
    kernel::Tensor<Dual> x;
    for (int i = 0; i < 6; ++i) x[i] = variable ? Dual::variable(A[i], i) : Dual(A[i]);
    return x;
}

struct Derivative {
    Vec value;
    Mat slope;
};

// The kernel's rate for D, differentiated by the stress or by D.
Derivative kernel_rate(const Sand& sand, const State& x, const Vec& D, bool by_stress, bool igs) {
    const grit::Material& m = grit::material_of(sand.prepared);
    const auto path = kernel::straight_path(m, dual(D, !by_stress), dual(x.h, false), Dual(x.e));
    const auto T = kernel::marched(m, dual(x.T, by_stress));
    const auto course = kernel::first_course(m, path);
    const auto at = igs ? kernel::waypoint(m, course.loading,
                                           kernel::mobilisation_at_start(m, course), path.e_0)
                        : kernel::basic_waypoint(m, path.e_0);
    const auto rate = igs ? kernel::course_rate<Dual, true>(m, path, at, T)
                          : kernel::course_rate<Dual, false>(m, path, at, T);
    Derivative out;
    for (int r = 0; r < 6; ++r) {
        const Dual T_rate = rate.T[r] / at.ds * path.length;
        out.value[r] = T_rate.v;
        for (int c = 0; c < 6; ++c) out.slope(r, c) = T_rate.d[c];
    }
    return out;
}

Derivative referee_rate(const Sand& sand, const State& x, const Vec& D, bool by_stress, bool igs) {
    const auto T = by_stress ? variables(x.T) : constants(x.T);
    const auto D_ = by_stress ? constants(D) : variables(D);
    const Scalar e(x.e, Vec(Vec::Zero()));
    const paper::Vector<Scalar> rate =
        igs ? paper::intergranular_rate<Scalar>(sand.p, T, x.h, e, D_)
            : paper::basic_rate<Scalar>(sand.p, T, e, D_);
    Derivative out;
    for (int r = 0; r < 6; ++r) {
        out.value[r] = rate[r].value();
        out.slope.row(r) = rate[r].derivatives().transpose();
    }
    return out;
}

void expect_same_derivatives(bool by_stress, bool igs) {
    for (const Sand& sand : four_sands()) {
        Random random(90);
        for (int i = 0; i < 100; ++i) {
            const State x = random_state(sand, random);
            const Vec D = random.uniform(0.5, 2.0) * random.direction();
            const Derivative ours = kernel_rate(sand, x, D, by_stress, igs);
            const Derivative theirs = referee_rate(sand, x, D, by_stress, igs);
            EXPECT_LE((ours.value - theirs.value).norm(), 1e-11 * theirs.value.norm());
            EXPECT_LE((ours.slope - theirs.slope).norm(), 1e-11 * theirs.slope.norm())
                << sand.name << " " << i;
        }
    }
}

TEST(Dual, DifferentiatesTheBasicRateByTheStress) { expect_same_derivatives(true, false); }
TEST(Dual, DifferentiatesTheBasicRateByTheStrainRate) { expect_same_derivatives(false, false); }
TEST(Dual, DifferentiatesTheIntergranularRateByTheStress) { expect_same_derivatives(true, true); }
TEST(Dual, DifferentiatesTheIntergranularRateByTheStrainRate) {
    expect_same_derivatives(false, true);
}

// f(x, y) with every operation of the dual type once.
template <class Real> Real everything(const Real& x, const Real& y) {
    const Real a = 2.0 * x + y / 3.0 - 1.5;
    const Real b = exp(-x * 0.3) * log(y + 4.0) / (3.0 - x);
    const Real c = sqrt(x * x + y * y) - y * 0.25 + (7.0 + x) - (x - 1.0) / y;
    return a * b - c / a + 2.0 / c;
}

TEST(Dual, DifferentiatesEveryOperation) {
    Random random(91);
    using Two = Eigen::AutoDiffScalar<Eigen::Vector2d>;
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform(0.5, 2.5), y = random.uniform(0.5, 2.5);
        const Dual ours = everything(Dual::variable(x, 0), Dual::variable(y, 1));
        const Two X(x, 2, 0), Y(y, 2, 1);
        const Two a = Two(2.0 * X) + Two(Y / 3.0) - 1.5;
        const Two b = Two(exp(Two(-X * 0.3))) * Two(log(Two(Y + 4.0))) / Two(3.0 - X);
        const Two c =
            Two(sqrt(Two(X * X + Y * Y))) - Two(Y * 0.25) + Two(7.0 + X) - Two(Two(X - 1.0) / Y);
        const Two theirs = Two(a * b) - Two(c / a) + Two(2.0 / c);
        EXPECT_NEAR(ours.v, theirs.value(), 1e-13 * (1.0 + std::fabs(theirs.value())));
        for (int k = 0; k < 2; ++k)
            EXPECT_NEAR(ours.d[k], theirs.derivatives()[k],
                        1e-11 * (1.0 + theirs.derivatives().norm()));
    }
}

// The first three span I, the strain and h; even where these are parallel or zero.
TEST(StrainDirections, AreOrthonormalAndTheLastThreeAreAcrossTheCourse) {
    Random random(93);
    const Vec I = (Vec() << 1.0, 1.0, 1.0, 0.0, 0.0, 0.0).finished();
    for (int i = 0; i < 1000; ++i) {
        const Vec strain = random.log_uniform(1e-12, 0.1) * (i % 4 == 1 ? I : random.direction());
        const Vec h = i % 4 == 2   ? Vec(1e-4 * strain)
                      : i % 4 == 3 ? Vec(Vec::Zero())
                                   : Vec(1e-4 * random.direction());
        kernel::Tensor<double> strain_, h_;
        for (int c = 0; c < 6; ++c) strain_[c] = strain[c], h_[c] = h[c];
        const kernel::StrainDirections r = kernel::strain_directions(strain_, h_);
        Mat Q;
        for (int k = 0; k < 6; ++k)
            for (int c = 0; c < 6; ++c) {
                Q(k, c) = r.d[k][c];
                EXPECT_NEAR(r.component[c][k], r.d[k][c], 1e-15);
            }
        EXPECT_LE((Q * Q.transpose() - Mat::Identity()).norm(), 1e-14);
        for (const Vec& course : {I, strain, h})
            EXPECT_LE((Q * course).tail<3>().norm(), 1e-14 * course.norm());
    }
}

TEST(Dual, HasTheValueOfThePlainDouble) {
    Random random(92);
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform(0.5, 2.5), y = random.uniform(0.5, 2.5);
        using kernel::exp, kernel::log, kernel::sqrt;
        const Dual f = exp(Dual::variable(x, 0)) * log(Dual::variable(y, 1)) / sqrt(Dual(x));
        EXPECT_EQ(f.v, exp(x) * log(y) / sqrt(x));
    }
}

}  // namespace
