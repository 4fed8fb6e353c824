// SPDX-License-Identifier: BSD-3-Clause
// The same test by files and Grit's own law, by files and the UMAT, and by the element library alone:
// the law behind all three is the same, so what is compared are the ways to it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <element/grit_law.hpp>
#include <element/simulate.hpp>
#include <incremental_driver/run.hpp>

#include "support/folder.hpp"

namespace {

constexpr double same = 1e-8;

// Largest difference, relative to the largest value of the column or of its kind.
double difference(const Table& a, const Table& b) {
    double worst = a.size() == b.size() ? 0.0 : INFINITY;
    const std::size_t ends[] = {2, 8, 14, 20, 28};  // time, strain, stress, h, the other ones
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        const bool alone = end == 28;
        double scale = 0.0, gap = 0.0;
        for (std::size_t c = begin; c < end; ++c) {
            if (alone) scale = gap = 0.0;
            for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
                scale = std::max(scale, std::abs(a[i][c]));
                gap = std::max(gap, std::abs(a[i][c] - b[i][c]));
            }
            if (gap > 0.0) worst = std::max(worst, gap / scale);
        }
        begin = end;
    }
    return worst;
}

Table of_files(const std::filesystem::path& folder, const std::string& output, int headings,
               const std::filesystem::path& umat = {}) {
    const Folder out;
    incremental_driver::run({folder, out.path(), umat});
    return read_table(out.path(output), headings);
}

Table of_files(const Folder& folder, const std::filesystem::path& umat = {}) {
    return of_files(folder.path(), "result.out", 1, umat);
}

const std::filesystem::path files = GRIT_INP_FILES;
const std::filesystem::path umat = GRIT_UMAT_LIBRARY;

struct Sand {
    element::GritLaw law;
    element::Sample sample;
};

// Lausitz sand, isotropic stress, h left by isotropic compression.
Sand lausitz(double pressure, double void_ratio) {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &parameters);
    Sand out{element::GritLaw(parameters), {}};
    const element::Vector6 one = element::unit_tensor();
    out.sample.point = out.law.start(-pressure * one, void_ratio);
    out.law.mobilise(out.sample.point, -one, 1.0);
    return out;
}

Table strain_and_stress(const element::History& history) {
    Table out;
    for (const element::Record& record : history.records) {
        out.push_back({record.time, record.time});
        out.back().insert(out.back().end(), record.strain.begin(), record.strain.end());
        out.back().insert(out.back().end(), record.stress.begin(), record.stress.end());
        out.back().resize(28, 0.0);
    }
    return out;
}

Table without_state(Table rows) {
    for (auto& row : rows) std::fill(row.begin() + 14, row.end(), 0.0);
    return rows;
}

element::Step step(const element::Controls& controls, double change, int increments) {
    element::Linear linear;
    linear.rows = mixed_control(controls);
    linear.change[0] = change;
    element::Step out;
    out.kind = linear;
    out.increments = increments;
    out.duration = 1.0;
    return out;
}

constexpr auto E = element::Control::strain, S = element::Control::stress;

TEST(IncrementalDriverOedometer, IsTheReferenceTheUmatAndTheElementLibrary) {
    const Table rows = of_files(files / "oedometer", "oedometer.out", 2);
    ASSERT_EQ(rows.size(), 1201u);
    // verification/data/reference/b_oed_lausitz.csv, its own error 2.3e-6
    EXPECT_NEAR(rows.back()[2], -0.049555434356, 3e-6 * 0.0496);
    EXPECT_NEAR(rows.back()[9], -189.654216055, 3e-6 * 400.0);
    EXPECT_NEAR(rows.back()[20], 0.617809084142, 1e-6);
    EXPECT_LT(difference(rows, of_files(files / "oedometer", "oedometer.out", 2, umat)), same);
    Sand sand = lausitz(10.0, 0.7);
    const element::Controls oedometer{S, E, E, E, E, E};
    const element::Program program{step(oedometer, -190, 400), step(oedometer, 180, 400),
                                   step(oedometer, -380, 400)};
    EXPECT_LT(difference(without_state(rows),
                         strain_and_stress(simulate(sand.law, sand.sample, program))),
              same);
}

TEST(IncrementalDriverTriaxial, IsTheReferenceTheUmatAndTheElementLibrary) {
    const Table rows = of_files(files / "triaxial", "triaxial.out", 1);
    ASSERT_EQ(rows.size(), 501u);
    // verification/data/reference/c_txd_lausitz_p100_e0.55.csv
    EXPECT_NEAR(rows.back()[8], -398.912004047, 1e-4 * 399.0);
    EXPECT_NEAR(rows.back()[20], 0.612734068335, 1e-5);
    EXPECT_LT(difference(rows, of_files(files / "triaxial", "triaxial.out", 1, umat)), same);
    Sand sand = lausitz(100.0, 0.55);
    const element::Controls triaxial{E, S, S, E, E, E};
    const element::Program program{step(triaxial, -0.002, 100), step(triaxial, -0.198, 400)};
    EXPECT_LT(difference(without_state(rows),
                         strain_and_stress(simulate(sand.law, sand.sample, program))),
              same);
}

TEST(IncrementalDriverClassicLayout, IsThatOfTheUmatForPoreWaterRotationAndInitialVoidRatio) {
    const Folder folder;
    Folder::fill(folder);
    std::string parameters = lausitz_parameters();
    parameters.replace(parameters.find("0.0\n10.7"), 8, "2e6\n0.72");  // K_w, e_0
    folder.write("parameters.inp", parameters);
    folder.write("initialconditions.inp",
                 "6\n-110\n-130\n-120\n5\n0\n0\n14\n0\n0\n0\n0\n0\n0\n0\n-20\n");
    folder.write("test.inp", "result.out\n*TriaxialE1\n30 10 1\n-0.004\n*DeformationGradient\n"
                             "20 5 1\n1.001\n0.999\n1\n0.1\n-0.09\n0.02\n0\n0\n0.03\n");
    const Table rows = of_files(folder);
    EXPECT_LT(difference(rows, of_files(folder, umat)), same);
    EXPECT_LT(rows[30][20], 0.72);  // e, compressed by the pressure
    EXPECT_NE(rows[30][21], -20.0);
}

TEST(IncrementalDriverClassicLayout, SwitchesTheIntergranularStrainOffAsTheUmatDoes) {
    const Folder folder;
    Folder::fill(folder);
    std::string parameters = lausitz_parameters();
    parameters.replace(parameters.find("5.0\n2.0\n1e-4"), 12, "0.0\n0.0\n0.0");  // m_R, m_T, R
    folder.write("parameters.inp", parameters);
    const Table rows = of_files(folder);
    EXPECT_LT(difference(rows, of_files(folder, umat)), same);
    EXPECT_LT(rows.back()[8], -100.0);
    EXPECT_EQ(rows.back()[14], 0.0);
}

}  // namespace
