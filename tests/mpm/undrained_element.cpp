// SPDX-License-Identifier: BSD-3-Clause
// A cell of the driver against the element test, which holds the total stress beside the sample.
#include <gtest/gtest.h>

#include <cmath>

#include <element/grit_law.hpp>
#include <element/laboratory.hpp>
#include <element/simulate.hpp>

#include "support/lausitz.hpp"
#include "support/wet_cell.hpp"

namespace {

using namespace mpm_test;

// Biaxial, 11 along r by strain, 22 along z by total stress, nothing along 33 [Pa].
element::Step biaxial(double strain, int increments) {
    element::Step step = element::biaxial_drained(strain);
    step.increments = increments;
    return step;
}

// Cycles until the grains bear next to nothing, then one way until they press again.
element::Program to_liquefaction_and_back() {
    element::Program out;
    const double amplitude = 1e-3;
    out.push_back(biaxial(-amplitude, 20));
    for (int half = 0; half < 15; ++half)
        out.push_back(biaxial((half % 2 ? -2.0 : 2.0) * amplitude, 40));
    out.push_back(biaxial(-1.0, 4000));
    return out;
}

TEST(UndrainedSand, OfACellIsThatOfTheElementTestToLiquefactionAndBack) {
    constexpr double dt = 1e-4, p_0 = 1e5, p_w0 = 5e4;
    SandPlan plan = lausitz_plan(0.7);
    plan.options = options_with_tolerance(1e-6);
    WetCell cell(p_0, p_w0, plan, 0.25, 4);
    ASSERT_EQ(cell.count(), 1);
    ParticleView q = cell.particles();
    const PoreWater& water = *cell.simulation->body(0).water;

    element::GritLawOptions options;
    options.tolerance = 1e-6;
    options.water_bulk_modulus = water.bulk_modulus;
    options.largest_tension = water.largest_tension;
    const element::GritLaw law(plan.parameters, options);
    element::Sample sample;
    sample.point =
        law.start(-p_0 * element::unit_tensor(), q[Sand::state + GRIT_SAND_VOID_RATIO][0], p_w0);
    for (int k = 0; k < 6; ++k)
        sample.point.state[static_cast<std::size_t>(k)] = q[Sand::state + k][0];
    const element::History test = element::simulate(law, sample, to_liquefaction_and_back());
    ASSERT_FALSE(test.failure) << test.failure->message;

    double strain[2] = {}, least = p_0, end = 0.0, worst_p_w = 0.0, worst_stress = 0.0;
    for (std::size_t i = 1; i < test.records.size(); ++i) {
        const element::Record& r = test.records[i];
        // The nodes at 0 are held, those at 1 m have the particle's velocity: it is the gradient.
        for (const int k : {0, 1}) {
            const double wanted = r.strain[k] - strain[k];  // of the middle of the step
            q[k == 0 ? column::v_r : column::v_z][0] = wanted / (1.0 - 0.5 * wanted) / dt;
        }
        const double F[2] = {q[column::F_rr][0], q[column::F_zz][0]};
        cell.simulation->step();
        q = cell.particles();
        for (const int k : {0, 1}) {
            const double L = q[k == 0 ? column::F_rr : column::F_zz][0] / F[k] - 1.0;
            strain[k] += L / (1.0 + 0.5 * L);
        }
        worst_p_w = std::fmax(worst_p_w, std::fabs(q[water.first][0] / r.pore_pressure - 1.0));
        for (int k = 0; k < 3; ++k)
            worst_stress =
                std::fmax(worst_stress, std::fabs(q[column::S_rr + k][0] - r.effective_stress[k]));
        end = -r.effective_stress.head<3>().sum() / 3.0;
        least = std::fmin(least, end);
    }
    EXPECT_LE(worst_p_w, 1e-6);
    EXPECT_LE(worst_stress, 1e-6 * p_0);
    EXPECT_LT(least, 0.02 * p_0);
    EXPECT_GT(end, 0.5 * p_0);
}

}  // namespace
