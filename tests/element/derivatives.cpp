// SPDX-License-Identifier: BSD-3-Clause
// Exact derivatives of whole tests under mixed control, against central differences of the tests.
#include <gtest/gtest.h>

#include <cmath>

#include <element/errors.hpp>
#include <element/start.hpp>

#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

constexpr int of_phi_c = 0, of_h_s = 1, of_n = 2, of_p_t = 8, of_R = 11;

Directions all_directions(bool intergranular_strain) {
    Directions by;
    for (int i = 0; i < (intergranular_strain ? GRIT_SAND_PARAMETER_COUNT : of_p_t); ++i)
        if (i != of_p_t) by.push_back(i);
    by.push_back(by_void_ratio);
    return by;
}

struct Case {
    grit_sand_parameters parameters = lausitz();
    GritLawOptions options;
    Start start;
    Program program;
    Settings settings;

    Case(Program p, double pressure = 100.0, double void_ratio = 0.65) : program(std::move(p)) {
        start.stress = -pressure * unit_tensor();
        start.void_ratio = void_ratio;
        options.tolerance = 1e-11;
        settings.tolerance = 1e-12;
    }
};

History run(const Case& c, const Directions& by = {}, const StartSlopes& given = {}) {
    const GritLaw law(c.parameters, c.options);
    Sample sample;
    sample.point = start_point(law, c.start);
    if (!by.empty()) sample.slopes = start_slopes(law, c.start, by, given);
    History history = simulate(law, sample, c.program, c.settings);
    EXPECT_FALSE(history.failure) << history.failure->message;
    return history;
}

double value_of(const Case& c, int direction) {
    double value = c.start.void_ratio;
    if (direction != by_void_ratio) grit_sand_parameter_get(&c.parameters, direction, &value);
    return value;
}

Case changed(Case c, int direction, double by) {
    if (direction == by_void_ratio) c.start.void_ratio += by;
    else grit_sand_parameter_set(&c.parameters, direction, value_of(c, direction) + by);
    return c;
}

using Row = Eigen::Matrix<double, 20, 1>;
Row row_of(const Record& r) {
    Row out;
    out << r.strain, r.effective_stress, r.total_stress, r.void_ratio, r.pore_pressure;
    return out;
}
Row slopes_of(const Record& r, Eigen::Index k) {
    Row out;
    out << r.slopes.strain.col(k), r.slopes.effective_stress.col(k), r.slopes.total_stress.col(k),
        r.slopes.void_ratio[k], r.slopes.pore_pressure[k];
    return out;
}

// Every number of every record; per relative change of the parameter, by the largest that there is of its kind.
void expect_central_differences(const char* name, const Case& c, double tolerance = 1e-6,
                                double step = 4e-4) {
    const Directions by = all_directions(c.options.intergranular_strain);
    const History history = run(c, by), plain = run(c);
    ASSERT_EQ(history.records.size(), plain.records.size());
    for (std::size_t i = 0; i < plain.records.size(); ++i)
        EXPECT_EQ((row_of(history.records[i]) - row_of(plain.records[i])).norm(), 0.0);
    double worst = 0.0;
    for (std::size_t k = 0; k < by.size(); ++k) {
        const double size = value_of(c, by[k]);
        const auto differences = [&](double by_share) {
            const History up = run(changed(c, by[k], by_share * size)),
                          down = run(changed(c, by[k], -by_share * size));
            std::vector<Row> out;
            for (std::size_t i = 0; i < plain.records.size(); ++i)
                out.push_back((row_of(up.records[i]) - row_of(down.records[i])) / (2.0 * by_share));
            return out;
        };
        const std::vector<Row> wide = differences(step), narrow = differences(0.5 * step);
        // strain, stress, void ratio, pore pressure
        constexpr Eigen::Index first[] = {0, 6, 18, 19, 20};
        for (int kind = 0; kind < 4; ++kind) {
            const Eigen::Index at = first[kind], count = first[kind + 1] - at;
            double largest = 0.0, error = 0.0, value = 0.0;
            for (std::size_t i = 0; i < plain.records.size(); ++i) {
                const Row exact = (4.0 * narrow[i] - wide[i]) / 3.0;
                const Row ours = size * slopes_of(history.records[i], static_cast<Eigen::Index>(k));
                largest = std::max(largest, exact.segment(at, count).norm());
                error = std::max(error, (ours - exact).segment(at, count).norm());
                value = std::max(value, row_of(plain.records[i]).segment(at, count).norm());
            }
            const double relative = error / std::max(largest, 0.01 * value);
            if (value > 0.0) worst = std::max(worst, relative);
            EXPECT_LE(error, tolerance * std::max(largest, 0.01 * value))
                << name << ", direction " << by[k] << ", kind " << kind;
        }
    }
    std::printf("%-32s %3zu records, %zu directions: largest relative difference %.1e\n", name,
                plain.records.size(), by.size(), worst);
}

Step of(Step step, int increments, double first_share = 0.0) {
    step.increments = increments;
    step.first_share = first_share;
    return step;
}

TEST(TestDerivatives, AreCentralDifferencesOfDrainedTests) {
    expect_central_differences("drained triaxial", {{of(triaxial_drained(-0.06), 20, 1e-3)}});
    expect_central_differences("drained, loose",
                               {{of(triaxial_drained(-0.06), 20, 1e-3)}, 50.0, 0.8});
    expect_central_differences("drained, constant p", {{of(triaxial_constant_p(-0.03), 15, 1e-3)}});
    expect_central_differences("biaxial", {{of(biaxial_drained(-0.03), 15, 1e-3)}});
    expect_central_differences("drained by stress", {{of(triaxial_drained_stress(-120.0), 15)}});
}

TEST(TestDerivatives, AreCentralDifferencesOfOedometersAndIsotropicCompression) {
    expect_central_differences("oedometer", {{of(oedometer_strain(-0.02), 15, 1e-3)}});
    expect_central_differences("oedometer, unloading", {{of(oedometer_stress(-300.0), 10),
                                                         of(oedometer_stress(200.0), 10, 1e-2),
                                                         of(oedometer_stress(-400.0), 10, 1e-2)}});
    expect_central_differences("isotropic", {{of(isotropic_stress(-300.0), 10, 1e-2)}});
    expect_central_differences("isotropic strain", {{of(isotropic_strain(-0.005), 10)}});
}

TEST(TestDerivatives, AreCentralDifferencesOfUndrainedTests) {
    expect_central_differences("undrained triaxial", {{of(triaxial_undrained(-0.03), 20, 1e-3)}});
    expect_central_differences("undrained, loose",
                               {{of(triaxial_undrained(-0.03), 20, 1e-3)}, 200.0, 0.75});
    expect_central_differences("undrained by stress", {{of(triaxial_undrained_stress(-60.0), 10)}});
    expect_central_differences(
        "undrained, then drainage",
        {{of(triaxial_undrained(-0.01), 10, 1e-2), of(drainage(), 20, 1e-3)}});
}

TEST(TestDerivatives, AreCentralDifferencesOfShearAndCycles) {
    expect_central_differences("simple shear, constant stress",
                               {{of(simple_shear_constant_stress(0.05), 20, 1e-3)}});
    expect_central_differences("simple shear, constant volume",
                               {{of(simple_shear_constant_volume(0.05), 20, 1e-3)}});
    Circulating cycles;
    cycles.rows = mixed_control({Control::stress, Control::stress, Control::stress, Control::strain,
                                 Control::strain, Control::strain});
    cycles.amplitude[0] = 30.0;
    cycles.cycles = 2.0;
    Step cyclic;
    cyclic.kind = cycles;
    expect_central_differences("cycles of stress", {{of(cyclic, 40)}});
    Repetition repeated;
    repeated.times = 2;
    repeated.steps = {of(triaxial_drained(-1e-3), 6, 1e-2), of(triaxial_drained(1e-3), 6, 1e-2)};
    Step block;
    block.kind = repeated;
    expect_central_differences("cycles of strain", {{block}});
}

TEST(TestDerivatives, AreCentralDifferencesWithTheBasicModelAndWithWaterInTheLaw) {
    Case wet({of(triaxial_drained(-0.01), 10, 1e-2)});
    wet.options.water_bulk_modulus = 2e5;
    expect_central_differences("water of the law", wet);
    wet.options.water_bulk_modulus = 0.0;
    wet.options.water_stiffness = 5e5;
    expect_central_differences("water of constant stiffness", wet);
    Case basic({of(triaxial_undrained(-0.01), 10, 1e-2)});
    basic.options.intergranular_strain = false;
    basic.start.intergranular_strain = IntergranularStrain::off;
    expect_central_differences("basic model", basic);
}

TEST(TestDerivatives, AreCentralDifferencesOfAbsoluteGoals) {
    Linear to;
    to.rows = mixed_control({Control::stress, Control::stress, Control::strain, Control::strain,
                             Control::strain, Control::strain});
    to.change << -180.0, -90.0, -0.002, 0.001, 0.0, 0.0;
    to.absolute = {true, true, true, true, false, false};
    Step absolute;
    absolute.kind = to;
    expect_central_differences("absolute goals",
                               {{of(triaxial_drained(-0.01), 10, 1e-2), of(absolute, 8)}});
}

Step gradient_that_turns() {
    DeformationGradient gradient;
    gradient.F << 0.99, 0.03, 0.0, -0.02, 0.985, 0.0, 0.0, 0.0, 1.0;
    Step step;
    step.kind = gradient;
    return of(step, 10);
}

TEST(TestDerivatives, AreCentralDifferencesOfADeformationGradientThatTurns) {
    expect_central_differences("deformation gradient",
                               {{of(triaxial_drained(-0.005), 5), gradient_that_turns()}});
}

// e = e_0 exp(-x), and a K0 stress of 1 - sin phi_c.
TEST(TestDerivatives, FollowAStartThatDependsOnParameters) {
    const Directions by = {of_phi_c, of_h_s, of_n, of_R, by_void_ratio};
    const auto started = [](Case c) {
        const double sine = std::sin(c.parameters.critical_friction_angle);
        c.start.stress << -200.0, -200.0 * (1.0 - sine), -200.0 * (1.0 - sine), 0.0, 0.0, 0.0;
        const GritLaw law(c.parameters, c.options);
        const double p = -c.start.stress.head<3>().mean();
        c.start.void_ratio = void_ratio_at_pressure(law.sand(), c.start.void_ratio, p);
        return c;
    };
    Case c({of(oedometer_strain(-0.01), 10, 1e-2)});
    constexpr double e_0 = 0.68;
    c.start.void_ratio = e_0;
    const Case at = started(c);
    StartSlopes given;
    given.stress = Matrix6X::Zero(6, 5);
    const double cosine = std::cos(c.parameters.critical_friction_angle);
    given.stress(1, 0) = given.stress(2, 0) = 200.0 * cosine;
    const GritLaw law(c.parameters, c.options);
    const double p = -at.start.stress.head<3>().mean();
    given.void_ratio = slopes_at_pressure(law.sand(), e_0, p, by);
    // By phi_c through p: that of p_t is by the pressure.
    given.void_ratio[0] +=
        slopes_at_pressure(law.sand(), e_0, p, {of_p_t})[0] * -400.0 / 3.0 * cosine;
    const History history = run(at, by, given);
    for (std::size_t k = 0; k < by.size(); ++k) {
        const double size = value_of(c, by[k]), step = 1e-4;
        const History up = run(started(changed(c, by[k], step * size))),
                      down = run(started(changed(c, by[k], -step * size)));
        for (std::size_t i = 0; i < history.records.size(); ++i) {
            const Row exact = (row_of(up.records[i]) - row_of(down.records[i])) / (2.0 * step);
            const Row ours = size * slopes_of(history.records[i], static_cast<Eigen::Index>(k));
            EXPECT_LE((ours - exact).norm(), 2e-6 * std::max(exact.norm(), 1.0))
                << by[k] << " " << i;
        }
    }
}

// Recorded where it ends only.
Step ending_exactly(Step step, const char* condition) {
    step.exit.exactly = true;
    step.exit.any_of.push_back(parse_condition(
        condition, incremental_driver_words({"", "", "", "", "", "", "void_ratio"})));
    step.every = step.increments;
    return step;
}

// Where a step ends depends on the directions, and so does all that follows. The end is found to 1e-9 of an increment:
// small increments and wide differences, which do not see that.
TEST(TestDerivatives, FollowEndsThatAreMetExactly) {
    const Step back = of(triaxial_drained(0.001), 4);
    const auto ends = [](const char* name, const Case& c, double step = 4e-3) {
        EXPECT_EQ(run(c).exits.size(), 1U) << name;
        expect_central_differences(name, c, 5e-6, step);
    };
    const auto expect = [&](const char* name, const Step& step, const char* condition) {
        ends(name, {{ending_exactly(step, condition), back}});
    };
    expect("drained to a stress", of(triaxial_drained(-0.02), 200), "s1 < -140");
    expect("oedometer to a void ratio", of(oedometer_strain(-0.05), 200), "void_ratio < 0.62");
    expect("undrained to a pore pressure", of(triaxial_undrained(-0.02), 200), "pw > 20");
    expect("shear to a principal stress", of(simple_shear_constant_stress(0.02), 200),
           "sIII < -112");
    expect("by stress to a strain", of(oedometer_stress(-400.0), 200), "e1 < -0.004");
    expect("to a sum of both", of(triaxial_drained(-0.02), 200), "1000*e1 + 0.1*s1 < -24");
    Step wave;
    Circulating kind;
    kind.rows = std::get<Linear>(triaxial_drained(-0.01).kind).rows;
    kind.amplitude[0] = -0.004;
    kind.amplitude[1] = kind.amplitude[2] = -10.0;
    kind.phase[1] = kind.phase[2] = 0.5;
    wave.kind = kind;
    expect("waves to a stress", of(wave, 300), "s1 < -112");
    Step table;
    Imported history{kind.rows, {}, {}, {}};
    for (int i = 0; i <= 30; ++i) history.table.push_back({-2e-5 * i * i});
    history.columns[0] = {0, 1.0};
    table.kind = history;
    // It has a corner at each row: differences must not reach the next.
    ends("by a table to a stress", {{ending_exactly(of(table, 30), "s1 < -140"), back}}, 1e-3);
    Step drained = of(triaxial_undrained(0.0), 200);
    drained.undrained = false;
    drained.drains = true;
    ends("drained to a volume",
         {{of(triaxial_undrained(-0.002), 10, 1e-2), ending_exactly(drained, "ev > 1e-4"), back}});
}

TEST(TestDerivatives, AreRefusedWhereTheyMakeNoSense) {
    const auto refused = [](const char* part, auto act) {
        try {
            act();
            ADD_FAILURE() << part;
        } catch (const BadCase& bad) {
            EXPECT_NE(std::string(bad.what()).find(part), std::string::npos) << bad.what();
        }
    };
    const Case c({of(triaxial_drained(-0.01), 5)});
    refused("there must be one at least",
            [&] { start_slopes(GritLaw(c.parameters, c.options), c.start, {}); });
    refused("must be in [0, 14), or -1 for the void ratio, got 14", [&] { run(c, {14}); });
    refused("must have 1 columns, got 2", [&] { run(c, {0}, {Matrix6X::Zero(6, 2), {}}); });
    Case without = c;
    without.options.intergranular_strain = false;
    without.start.intergranular_strain = IntergranularStrain::off;
    refused("elastic_strain_radius (R), which an update without intergranular strain does not use",
            [&] { run(without, {of_R}); });
    const Case turned({ending_exactly(gradient_that_turns(), "e1 < -0.005")});
    refused("ends a deformation gradient exactly", [&] { run(turned, {0}); });
    Case unknown({of(triaxial_drained(-0.02), 1)});
    unknown.program[0].exit.exactly = true;
    unknown.program[0].exit.any_of.push_back(parse_condition("f < -1", [](const std::string&) {
        return Quantity{[](const Record& r) { return 100.0 * r.strain[0]; }};
    }));
    refused("\"f < -1\" speaks of a quantity without derivatives", [&] { run(unknown, {0}); });
    // Held before: it ends where the increment does.
    EXPECT_EQ(run({{ending_exactly(of(triaxial_drained(-0.01), 5), "e1 < 1")}}, {0}).exits.size(),
              1U);
}

}  // namespace
