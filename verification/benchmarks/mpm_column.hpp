// SPDX-License-Identifier: BSD-3-Clause
// An axisymmetric column, 1 m x 4 m on rollers, four particles a cell, that was at rest and is pressed
// together: of elastic material, or of Lausitz sand whose increments are about 1e-6 to 1e-5 per step.
#pragma once

#include <cmath>
#include <numbers>

#include <adapters/mpm/case/build_case.hpp>
#include <grit/sand_catalogue.h>

namespace benchmarks {

struct ColumnPlan {
    int cells_r;  // 16 cells_r^2 particles
    bool sand = false;
    int threads = 1;
    grit::mpm::Shape shape = grit::mpm::Shape::cpdi;
    grit::mpm::Scheme scheme = grit::mpm::Scheme::usl;
};

inline grit::mpm::SandPlan lausitz_plan() {
    grit::mpm::SandPlan sand{};
    grit_sand_parameters_init(&sand.parameters, sizeof sand.parameters);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1000.0, &sand.parameters);
    grit_sand_options_init(&sand.options, sizeof sand.options);
    sand.options.tolerance = 1e-3;  // as in a case file that says nothing
    sand.void_ratio = 0.65;
    sand.intergranular_rho = 1.0;
    return sand;
}

inline grit::mpm::BuiltCase column(const ColumnPlan& plan) {
    using namespace grit::mpm;
    const double width = 1.0, height = 4.0, cell = width / plan.cells_r;
    const auto axis = [cell](double length) {
        return AxisPlan{0.0, {{length, static_cast<int>(std::lround(length / cell))}}};
    };
    Case out{};
    out.r = axis(width);
    out.z = axis(height + 2.0 * cell);
    out.settings.shape = plan.shape;
    out.settings.scheme = plan.scheme;
    out.settings.threads = plan.threads;
    out.settings.gravity_z = -out.gravity;
    out.boundary[static_cast<int>(Side::right)] = Boundary::roller;
    out.boundary[static_cast<int>(Side::bottom)] = Boundary::roller;
    BodyPlan body{};
    body.name = "column";
    body.outlines = {{{{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}}};
    body.density = 1600.0;
    body.geostatic = Geostatic{height, 1000.0, {}};
    if (plan.sand) body.material = lausitz_plan();
    else body.material = ElasticPlan{1e7, 0.3};
    out.bodies.push_back(body);
    BuiltCase built = build_case(out);
    Particles& particles = built.simulation->body(0).particles;
    const ParticleView q = particles.view();
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p)  // the first mode
        q[column::v_z][p] = -0.1 * std::sin(0.5 * std::numbers::pi * q[column::z][p] / height);
    return built;
}

}  // namespace benchmarks
