// SPDX-License-Identifier: BSD-3-Clause
// Undrained sand that moves as it is told.
#pragma once

#include <memory>

#include <adapters/mpm/case/build_case.hpp>

#include "support/plans.hpp"

namespace mpm_test {

using namespace grit::mpm;

// The quarter of a block around r = z = 0, of this size, in a cell of 1 m with so many particles along each side; so
// heavy that nothing stops it.
struct WetCell {
    std::unique_ptr<Simulation> simulation;
    WetCell(double mean_pressure, double p_w, const SandPlan& sand = lausitz_plan(0.85),
            double size = 1.0, int particles_each_way = 2) {
        Case plan = column_case();
        plan.settings.axisymmetric = false;
        plan.settings.largest_step = 1e-4;
        plan.r = {-1.0, {{1.0, 2, 1.0}}};
        plan.z = {-1.0, {{1.0, 2, 1.0}}};
        for (Boundary& boundary : plan.boundary) boundary = Boundary::free;
        BodyPlan& body = plan.bodies[0];
        body.outlines = {Outline{{{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}}}};
        body.particles_r = body.particles_z = particles_each_way;
        body.material = sand;
        body.water = WaterPlan{.grain_density = 1e12};
        simulation = std::move(build_case(plan).simulation);
        simulation->fix_below(0, 0.0);
        simulation->fix_below(1, 0.0);
        const ParticleView q = particles();
        for (std::ptrdiff_t p = 0; p < count(); ++p) {
            for (const int c : {column::S_rr, column::S_zz, column::S_tt}) q[c][p] = -mean_pressure;
            q[simulation->body(0).water->first][p] = p_w;
        }
    }
    std::ptrdiff_t count() const { return simulation->body(0).particles.size(); }
    ParticleView particles() { return simulation->body(0).particles.view(); }
    void set_rates(double v_r, double v_z) {
        const ParticleView q = particles();
        for (std::ptrdiff_t p = 0; p < count(); ++p) {
            q[column::v_r][p] = v_r * q[column::r][p];
            q[column::v_z][p] = v_z * q[column::z][p];
        }
    }
};

}  // namespace mpm_test
