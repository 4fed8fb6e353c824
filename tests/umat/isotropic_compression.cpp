// SPDX-License-Identifier: BSD-3-Clause
#include "support/paper.hpp"
#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

State isotropic_state(double p, double e) {
    State x;
    x.T = -p * identity();
    x.e = e;
    return x;
}

// |dp| = f_s |d eps_v|/3 [3 + a^2 -+ sqrt 3 a f_d], - loading, + unloading.
TEST(IsotropicCompression, HasTheClosedFormStiffnessOfLoadingAndUnloading) {
    for (const Sand& sand : four_sands())
        for (const double p : {1.0, 50.0, 1000.0})
            for (const double looseness : {0.2, 0.7, 1.0}) {
                SCOPED_TRACE(sand.name);
                const State x = isotropic_state(p, void_ratio_at(sand, p, looseness));
                const auto k = paper::parts<double>(sand.p, x.T, x.e);
                for (const double sign : {-1.0, 1.0}) {
                    const Vec D = sign / 3.0 * identity();  // |tr D| = 1
                    const double p_rate = trace(basic_rate(sand, x, D).T) / -3.0;
                    const double closed =
                        k.f_s / 3.0 * (3.0 + k.a * k.a + sign * std::sqrt(3.0) * k.a * k.f_d);
                    EXPECT_NEAR(p_rate / (-sign * closed), 1.0, 1e-12);
                }
            }
}

TEST(IsotropicCompression, KeepsTheStressIsotropic) {
    for (const Sand& sand : four_sands()) {
        const State x = isotropic_state(80.0, void_ratio_at(sand, 80.0, 0.6));
        const State y = updated(sand, x, -0.005 * identity());
        EXPECT_LE(deviator(y.T).norm(), 1e-12 * y.T.norm()) << sand.name;
    }
}

double distance_from_bauers_curve(const Sand& sand, double tolerance, int parts) {
    State x = isotropic_state(50.0, void_ratios(sand, 50.0).e_i);
    x.h = -sand.p.elastic_strain_radius / std::sqrt(3.0) * identity();
    grit_sand_options options = options_with(tolerance);
    options.intergranular_off = 1;
    for (int i = 0; i < parts; ++i) x = updated(sand, x, -0.02 / 3.0 / parts * identity(), options);
    return std::fabs(x.e / void_ratios(sand, -trace(x.T) / 3.0).e_i - 1.0);
}

TEST(IsotropicCompression, StaysOnBauersCurveFromTheLoosestState) {
    for (const Sand& sand : four_sands()) {
        EXPECT_LE(distance_from_bauers_curve(sand, 1e-5, 1), 1e-4) << sand.name;
        EXPECT_LE(distance_from_bauers_curve(sand, 1e-12, 20), 1e-11) << sand.name;
    }
}

}  // namespace
