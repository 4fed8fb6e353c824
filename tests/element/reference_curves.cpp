// SPDX-License-Identifier: BSD-3-Clause
// Mixed control against the exact response of Lausitz sand (DOP853, rtol 1e-12). A row of the file
// ends `parts` increments; strain is straight within an increment, so where the path bends there is
// an error of the increments' size besides the law's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "../larger.hpp"
#include "support/lausitz.hpp"
#include "support/tables/csv.hpp"

namespace {

using namespace tests;
using namespace element;

using Row = std::vector<double>;

constexpr Control e = Control::strain, s = Control::stress;
enum Column { strain = 1, stress = 7, void_ratio = 13, memory = 14 };

struct Curve {
    const char* file;
    Controls controls;
    bool undrained = false;
    bool intergranular_strain = true;
};

constexpr Controls by_stress{s, s, s, e, e, e}, oedometer{s, e, e, e, e, e},
    triaxial{e, s, s, e, e, e}, shear{e, s, e, e, e, e};

Vector6 vector(const Row& row, int at) { return Vector6::Map(row.data() + at); }

// Prescribed values at the rows and at parts - 1 places between them. Undrained: total stress, the
// lateral stress that the test begins with.
Imported history_of(const std::vector<Row>& rows, const Curve& curve, int parts) {
    Imported out;
    out.rows = mixed_control(curve.controls);
    const auto prescribed = [&](const Row& row) {
        Row c(6);
        for (std::size_t i = 0; i < 6; ++i) {
            const bool by_strain = curve.controls[i] == e;
            const Row& from = by_strain || !curve.undrained ? row : rows[0];
            c[i] = from[i + (by_strain ? strain : stress)];
        }
        return c;
    };
    out.table.push_back(prescribed(rows[0]));
    for (std::size_t r = 1; r < rows.size(); ++r) {
        const Row a = prescribed(rows[r - 1]), b = prescribed(rows[r]);
        for (int k = 1; k <= parts; ++k) {
            Row c(6);
            for (std::size_t i = 0; i < 6; ++i)
                c[i] = k == parts ? b[i] : a[i] + k * (b[i] - a[i]) / parts;
            out.table.push_back(c);
        }
    }
    for (int i = 0; i < 6; ++i) out.columns[static_cast<std::size_t>(i)].index = i;
    return out;
}

// Largest difference over all rows: stress relative to the largest component of any row.
struct Worst {
    double stress = 0.0, strain = 0.0, void_ratio = 0.0;
    long iterations = 0, increments = 0;
};

Worst run(const Curve& curve, double tolerance, int parts) {
    const std::vector<Row> rows =
        grit::csv::read_numbers(std::string(GRIT_DATA "/reference/") + curve.file + ".csv").rows;
    const GritLaw law = lausitz_law(tolerance, curve.intergranular_strain);
    Sample sample;
    sample.point = law.start(vector(rows[0], stress), rows[0][void_ratio]);
    Vector6::Map(sample.point.state.data()) = vector(rows[0], memory);
    Step step;
    step.kind = history_of(rows, curve, parts);
    step.undrained = curve.undrained;
    step.every = parts;
    Settings settings;
    settings.tolerance = std::min(1e-9, tolerance);
    const History history = simulate(law, sample, {step}, settings);
    EXPECT_FALSE(history.failure) << curve.file << ": " << history.failure->message;
    Worst worst;
    if (history.failure) return worst;
    EXPECT_EQ(history.records.size(), rows.size());
    double largest = 0.0;
    for (const Row& row : rows)
        largest = std::max(largest, vector(row, stress).cwiseAbs().maxCoeff());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Record& record = history.records[i];
        const Vector6 difference = record.effective_stress - vector(rows[i], stress);
        worst.stress =
            larger(worst.stress, difference.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / largest);
        worst.strain = larger(
            worst.strain,
            (record.strain - vector(rows[i], strain)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
        worst.void_ratio =
            larger(worst.void_ratio, std::abs(record.void_ratio - rows[i][void_ratio]));
        worst.iterations += record.iterations;
    }
    worst.increments = static_cast<long>(rows.size() - 1) * parts;
    std::printf("%-30s tolerance %.0e: %7ld increments, %.2f iterations each; stress %.1e, strain "
                "%.1e, e %.1e\n",
                curve.file, tolerance, worst.increments,
                static_cast<double>(worst.iterations) / static_cast<double>(worst.increments),
                worst.stress, worst.strain, worst.void_ratio);
    return worst;
}

// Default and tightest tolerance of the law; the parts are what the bends of the path ask for.
void expect_curve(const Curve& curve, int parts, int parts_of_tight, double limit_of_tight = 1e-6) {
    const Worst standard = run(curve, 1e-5, parts);
    EXPECT_LE(standard.stress, 1e-4) << curve.file;
    EXPECT_LE(standard.void_ratio, 1e-5) << curve.file;
    const Worst tight = run(curve, 1e-12, parts_of_tight);
    EXPECT_LE(tight.stress, limit_of_tight) << curve.file;
    EXPECT_LE(tight.strain, 1e-7) << curve.file;
}

TEST(ReferenceCurve, IsotropicCompressionByStressIsMetWithAndWithoutMemory) {
    expect_curve({"a_iso_lausitz_diso", by_stress}, 1, 1);
    expect_curve({"a_iso_lausitz_dzero", by_stress}, 1, 1);
    expect_curve({"a_iso_lausitz_noIGS_dzero", by_stress, false, false}, 1, 1);
}

TEST(ReferenceCurve, OedometerByStressIsMetInLoadingUnloadingAndReloading) {
    expect_curve({"b_oed_lausitz", oedometer}, 1, 1, 3e-6);
    expect_curve({"b_oed_lausitz_noIGS", oedometer, false, false}, 1, 1);
}

TEST(ReferenceCurve, DrainedTriaxialCompressionIsMetFromLooseToDense) {
    expect_curve({"c_txd_lausitz_p100_e0.55", triaxial}, 1, 8);
    expect_curve({"c_txd_lausitz_p100_e0.80", triaxial}, 1, 8);
    expect_curve({"c_txd_lausitz_p400_e0.55", triaxial}, 1, 8);
    expect_curve({"c_txd_lausitz_p400_e0.75", triaxial}, 1, 8);
    expect_curve({"c_txd_lausitz_noIGS_p100_e0.55", triaxial, false, false}, 1, 8);
}

TEST(ReferenceCurve, UndrainedTriaxialCompressionIsMetFromLooseToDense) {
    expect_curve({"d_txu_lausitz_p100_e0.55", triaxial, true}, 1, 1);
    expect_curve({"d_txu_lausitz_p100_e0.70", triaxial, true}, 1, 1);
    expect_curve({"d_txu_lausitz_p100_e0.80", triaxial, true}, 1, 1, 2e-6);
    expect_curve({"d_txu_lausitz_p400_e0.75", triaxial, true}, 1, 1, 2e-6);
}

// Each reversal bends the path anew within R = 1e-4, the size of a row being 2e-5 at the largest.
TEST(ReferenceCurve, DrainedStrainCyclesAreMet) {
    expect_curve({"e_cycd_lausitz_a1e-03", triaxial}, 6, 48);
    expect_curve({"e_cycd_lausitz_a1e-04", triaxial}, 1, 6);
}

TEST(ReferenceCurve, UndrainedStrainCyclesAreMet) {
    expect_curve({"e_cycu_lausitz_a1e-03", triaxial, true}, 1, 1);
    expect_curve({"e_cycu_lausitz_a1e-04", triaxial, true}, 1, 1);
    expect_curve({"e_cycu_lausitz_a1e-05", triaxial, true}, 1, 1);
}

TEST(ReferenceCurve, SimpleShearIsMetAtConstantStressAndAtConstantVolume) {
    expect_curve({"f_ssd_lausitz", shear}, 1, 8);
    expect_curve({"f_ssu_lausitz", shear, true}, 1, 1);
}

}  // namespace
