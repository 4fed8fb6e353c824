// SPDX-License-Identifier: BSD-3-Clause
// The same test by files and Grit's own law, by files and the UMAT, and by the element library alone, and by TOML:
// the law behind all three is the same, so what is compared are the ways to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <element/grit_law.hpp>
#include <element/simulate.hpp>

#include "../catalogue.hpp"
#include "support/compare.hpp"
#include "support/tables/csv.hpp"

namespace {

const std::filesystem::path files = GRIT_INP_FILES;
const std::filesystem::path umat = GRIT_UMAT_LIBRARY;

struct Sand {
    element::GritLaw law;
    element::Sample sample;
};

// Lausitz sand, isotropic stress, h left by isotropic compression.
Sand lausitz(double pressure, double void_ratio, const element::GritLawOptions& options = {}) {
    Sand out{element::GritLaw(catalogue_parameters("lausitz", 1.0), options), {}};
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

// Strain and stress of a run by grit element from a TOML file.
Table of_toml(const std::string& name) {
    const Folder out;
    const std::string command = std::string(GRIT_CLI) + " element --no-plot --quiet --out " +
                                out.path().string() + " " + (files / (name + ".toml")).string() +
                                " > /dev/null";
    if (std::system(command.c_str()) != 0) return {};
    const grit::csv::Numbers table = grit::csv::read_numbers(out.path(name + ".csv"));
    Table rows;
    for (const std::vector<double>& values : table.rows) {
        rows.emplace_back(2, 0.0);  // no times
        for (const char* name_of :
             {"strain_11", "strain_22", "strain_33", "gamma_12", "gamma_13", "gamma_23",
              "stress_11", "stress_22", "stress_33", "stress_12", "stress_13", "stress_23"})
            rows.back().push_back(values[table.at(name_of)]);
        rows.back().resize(28, 0.0);
    }
    return rows;
}

Table without_times(Table rows) {
    for (auto& row : rows) row[0] = row[1] = 0.0;
    return rows;
}

constexpr auto E = element::Control::strain, S = element::Control::stress;
const element::GritLawOptions closely{.tolerance = 1e-5};

TEST(IncrementalDriverOedometer, IsTheReferenceTheUmatAndTheElementLibrary) {
    const Table rows = of_files(files / "oedometer", "oedometer.out", 2);
    ASSERT_EQ(rows.size(), 1201u);
    EXPECT_LT(difference(rows, of_files(files / "oedometer", "oedometer.out", 2, umat)), same);
    Sand sand = lausitz(10.0, 0.7);
    const element::Controls oedometer{S, E, E, E, E, E};
    const element::Program program{step(oedometer, -190, 400), step(oedometer, 180, 400),
                                   step(oedometer, -380, 400)};
    EXPECT_LT(difference(without_state(rows),
                         strain_and_stress(simulate(sand.law, sand.sample, program))),
              same);
    // verification/data/reference/b_oed_lausitz.csv, its own error 2.3e-6: at the default tolerance, and closer.
    EXPECT_NEAR(rows.back()[2], -0.049555434356, 2e-5 * 0.0496);
    EXPECT_NEAR(rows.back()[9], -189.654216055, 2e-5 * 400.0);
    EXPECT_NEAR(rows.back()[20], 0.617809084142, 2e-6);
    Sand closer = lausitz(10.0, 0.7, closely);
    const element::Record end = simulate(closer.law, closer.sample, program).records.back();
    EXPECT_NEAR(end.strain[0], -0.049555434356, 3e-6 * 0.0496);
    EXPECT_NEAR(end.stress[1], -189.654216055, 3e-6 * 400.0);
    EXPECT_NEAR(end.void_ratio, 0.617809084142, 1e-6);
}

TEST(IncrementalDriverTriaxial, IsTheReferenceTheUmatAndTheElementLibrary) {
    const Table rows = of_files(files / "triaxial", "triaxial.out", 1);
    ASSERT_EQ(rows.size(), 501u);
    EXPECT_LT(difference(rows, of_files(files / "triaxial", "triaxial.out", 1, umat)), same);
    Sand sand = lausitz(100.0, 0.55);
    const element::Controls triaxial{E, S, S, E, E, E};
    const element::Program program{step(triaxial, -0.002, 100), step(triaxial, -0.198, 400)};
    EXPECT_LT(difference(without_state(rows),
                         strain_and_stress(simulate(sand.law, sand.sample, program))),
              same);
    // verification/data/reference/c_txd_lausitz_p100_e0.55.csv: at the default tolerance, and closer.
    EXPECT_NEAR(rows.back()[8], -398.912004047, 1e-4 * 399.0);
    EXPECT_NEAR(rows.back()[20], 0.612734068335, 5e-5);
    Sand closer = lausitz(100.0, 0.55, closely);
    const element::Record end = simulate(closer.law, closer.sample, program).records.back();
    EXPECT_NEAR(end.stress[0], -398.912004047, 1e-4 * 399.0);
    EXPECT_NEAR(end.void_ratio, 0.612734068335, 1e-5);
}

TEST(IncrementalDriverCases, AreThoseOfTheLaboratoryInToml) {
    const auto bare = [](const Table& rows) { return without_times(without_state(rows)); };
    EXPECT_LT(
        difference(bare(of_files(files / "oedometer", "oedometer.out", 2)), of_toml("oedometer")),
        same);
    EXPECT_LT(
        difference(bare(of_files(files / "triaxial", "triaxial.out", 1)), of_toml("triaxial")),
        same);
}

}  // namespace
