// SPDX-License-Identifier: BSD-3-Clause
// Small cases.
#pragma once

#include <string>

#include <adapters/mpm/case/case.hpp>

#include "../../catalogue.hpp"

namespace mpm_test {

using namespace grit::mpm;

inline BodyPlan elastic_box(const std::string& name, double r0, double r1, double z0, double z1) {
    BodyPlan out{};
    out.name = name;
    out.outlines = {Outline{{{r0, z0}, {r1, z0}, {r1, z1}, {r0, z1}}}};
    out.particles_r = out.particles_z = 2;
    out.density = 1000.0;
    out.material = ElasticPlan{1e6, 0.3};
    return out;
}

inline SandPlan lausitz_plan(double void_ratio) {
    SandPlan out{};
    out.parameters = catalogue_parameters("lausitz", 1000.0);
    out.options = options_with_tolerance(1e-3);
    out.void_ratio = void_ratio;
    return out;
}

// A column of radius 0.2 and height 1 in a tube, on a roller, with gravity; one stage of 0.1 s.
inline Case column_case() {
    Case out;
    out.name = "column";
    out.r = {0.0, {{0.2, 4, 1.0}}};
    out.z = {0.0, {{1.2, 24, 1.0}}};
    out.boundary[static_cast<int>(Side::right)] = Boundary::roller;
    out.boundary[static_cast<int>(Side::bottom)] = Boundary::roller;
    out.bodies = {elastic_box("column", 0.0, 0.2, 0.0, 1.0)};
    out.stages = {StagePlan{.name = "stage", .end = {.time = 0.1}}};
    out.history.body = "column";
    return out;
}

// The column under 10 kPa, which come within 0.1 s.
inline Case pressed_column_case() {
    Case out = column_case();
    out.tractions = {{.body = "column",
                      .edge = Edge::top,
                      .direction = {0.0, -1.0},
                      .stress = TimeTable{{0.0, 0.1}, {0.0, 1e4}}}};
    return out;
}

}  // namespace mpm_test
