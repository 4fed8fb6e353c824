// SPDX-License-Identifier: BSD-3-Clause
// A law behind a UMAT symbol: Grit's own UMAT must be Grit, and a careless one must do no harm.
#include <element/umat_law.hpp>

#include <gtest/gtest.h>

#include <element/errors.hpp>

#include "../larger.hpp"
#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

UmatSource grit_umat() {
    UmatSource source;
    source.library = GRIT_UMAT_LIBRARY;
    source.props = {33.0, 0.0, 1.6e6, 0.19, 0.44, 0.85, 1.0, 0.25,
                    1.0,  5.0, 2.0,   1e-4, 0.5,  6.0,  0.0, 10.7};
    source.state_size = 14;
    source.void_ratio = 6;
    source.minus_pore_pressure = 7;
    return source;
}

Sample umat_sample(const UmatLaw& law, const Sample& of_grit) {
    Sample out;
    out.point = law.start(of_grit.point.stress,
                          {of_grit.point.state.begin(), of_grit.point.state.begin() + 7});
    return out;
}

double worst_difference(const Program& program, double K_w = 0.0) {
    GritLawOptions options;
    options.water_stiffness = K_w;
    const GritLaw grit(lausitz(), options);
    UmatSource source = grit_umat();
    source.props[14] = K_w;
    const UmatLaw umat(source);
    Sample a = isotropic_sample(grit, 100.0, 0.7), b = umat_sample(umat, a);
    const History of_grit = simulate(grit, a, program), of_umat = simulate(umat, b, program);
    EXPECT_FALSE(of_grit.failure) << of_grit.failure->message;
    EXPECT_FALSE(of_umat.failure) << of_umat.failure->message;
    EXPECT_EQ(of_grit.records.size(), of_umat.records.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < std::min(of_grit.records.size(), of_umat.records.size()); ++i) {
        const Record &x = of_grit.records[i], &y = of_umat.records[i];
        worst = larger(worst, (x.stress - y.stress).norm() / x.stress.norm());
        worst = larger(worst, (x.strain - y.strain).norm());
        worst = larger(worst, std::abs(x.void_ratio - y.void_ratio));
        worst = larger(worst, std::abs(x.pore_pressure - y.pore_pressure) / 100.0);
    }
    return worst;
}

Program with_increments(Program program, int n) {
    for (Step& step : program) step.increments = n;
    return program;
}

TEST(UmatLaw, OfGritsOwnLibraryEqualsGritInTheOedometer) {
    EXPECT_LE(
        worst_difference(with_increments(
            {oedometer_stress(-300.0), oedometer_stress(350.0), oedometer_stress(-750.0)}, 100)),
        1e-8);
}

TEST(UmatLaw, OfGritsOwnLibraryEqualsGritInTheTriaxialTest) {
    EXPECT_LE(worst_difference(with_increments({triaxial_drained(-0.1)}, 200)), 1e-8);
    EXPECT_LE(worst_difference(with_increments({triaxial_undrained(-0.05)}, 200)), 1e-8);
}

TEST(UmatLaw, OfGritsOwnLibraryEqualsGritWithPoreWaterOfItsOwn) {
    EXPECT_LE(worst_difference(with_increments({triaxial_drained(-0.02)}, 200), 2e6), 1e-8);
}

TEST(UmatLaw, TakesTheTangentByColumns) {
    const GritLaw grit(lausitz());
    const UmatLaw umat(grit_umat());
    const Sample a = isotropic_sample(grit, 100.0, 0.7);
    StrainIncrement increment;
    increment.strain << -0.01, 0.004, 0.001, 0.003, -0.002, 0.001;
    const Matrix6 expected = grit.advance(a.point, increment).tangent;
    EXPECT_GT((expected - expected.transpose()).norm(), 0.01 * expected.norm());
    EXPECT_LE((umat.advance(umat_sample(umat, a).point, increment).tangent - expected).norm(),
              1e-8 * expected.norm());
}

TEST(UmatLaw, RotatesStressAndMemoryAsGritDoes) {
    Step turn;
    DeformationGradient motion;
    motion.F << 0.0, -0.99, 0.0, 1.02, 0.0, 0.01, 0.0, 0.0, 1.0;
    turn.kind = motion;
    turn.increments = 50;
    Program program = with_increments({triaxial_drained(-0.002)}, 50);
    program.push_back(turn);
    EXPECT_LE(worst_difference(program), 1e-8);
}

TEST(UmatLaw, FindsTheUsualSymbol) { EXPECT_EQ(UmatLaw(grit_umat()).symbol(), "umat_"); }

std::string complaint_about(const UmatSource& source) {
    try {
        const UmatLaw law(source);
    } catch (const BadCase& error) {
        return error.what();
    }
    return "";
}

TEST(UmatLaw, SaysWhatIsWrongWithALibrary) {
    UmatSource source = grit_umat();
    source.library = "no_such_library.so";
    EXPECT_NE(complaint_about(source).find("no_such_library.so"), std::string::npos);
    source.library = GRIT_LIBRARY;
    EXPECT_NE(complaint_about(source).find("has no symbol umat_, UMAT or umat"), std::string::npos);
    source = grit_umat();
    source.state_size = 6;
    EXPECT_EQ(complaint_about(source), "NSTATV is 6: there is no STATEV(7)");
}

TEST(UmatLaw, ReportsAFailedIncrementAndTriesASmallerOne) {
    const UmatLaw law(grit_umat());
    MaterialPoint point = law.start(-100.0 * unit_tensor(), {0, 0, 0, 0, 0, 0, 0.7});
    StrainIncrement increment;
    increment.strain = -0.5 * unit_tensor();
    const Response response = law.advance(point, increment);
    EXPECT_EQ(response.outcome, Outcome::retry_smaller);
    EXPECT_LT(response.reduction, 1.0);
    EXPECT_NE(response.message.find("PNEWDT"), std::string::npos) << response.message;
}

// The careless UMAT is isotropic elasticity, E = 1000, nu = 0.25, which spoils its inputs.
UmatSource careless_umat(int state_size) {
    UmatSource source;
    source.library = GRIT_CARELESS_UMAT;
    source.props = {1000.0, 0.25};
    source.state_size = state_size;
    return source;
}

TEST(UmatLaw, KeepsItsInputsFromACarelessLibrary) {
    const UmatLaw law(careless_umat(2));
    EXPECT_EQ(law.symbol(), "UMAT");
    Sample sample;
    sample.point = law.start(Vector6::Zero(), {});
    Step step = triaxial_drained(-0.01);
    step.increments = 7;
    const History history = simulate(law, sample, {step});
    ASSERT_FALSE(history.failure) << history.failure->message;
    EXPECT_NEAR(sample.strain[0], -0.01, 1e-15);
    EXPECT_NEAR(sample.strain[1], 0.0025, 1e-12);
    EXPECT_NEAR(sample.point.stress[0], -10.0, 1e-9);
    EXPECT_EQ(law.state_names()[1], "statev(2)");
}

TEST(UmatLaw, NoticesALibraryThatWritesBeyondItsState) {
    const UmatLaw law(careless_umat(1));
    Sample sample;
    sample.point = law.start(Vector6::Zero(), {});
    const History history = simulate(law, sample, {oedometer_strain(-0.01)});
    ASSERT_TRUE(history.failure);
    EXPECT_NE(history.failure->message.find("STATEV(1)"), std::string::npos)
        << history.failure->message;
}

}  // namespace
