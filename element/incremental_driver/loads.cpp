// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/loads.hpp"

#include "element/incremental_driver/components.hpp"
#include "element/incremental_driver/restriction.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

using element::Control;
using element::text;

double read_amplitude(Lines& lines) {
    return Fields(lines, lines.next("the amplitude of the perturbations"))
        .single("the amplitude of the perturbations");
}

element::Kind read_perturbations(Lines& lines, Control control) {
    const element::Variables variables = read_variables(lines);
    element::Controls controls;
    controls.fill(control);
    element::Perturbations out;
    out.rows = mixed_control(controls, variables);
    const double amplitude = read_amplitude(lines);
    out.first[0] = amplitude;
    out.second[1] = amplitude;
    return out;
}

}  // namespace

element::Kind read_linear(Lines& lines) {
    const element::Variables variables = read_variables(lines);
    element::Linear out;
    element::Controls controls;
    for (int i = 0; i < 6; ++i) {
        Fields fields = component_line(lines, i);
        controls[static_cast<std::size_t>(i)] = read_control(fields);
        out.change[i] = fields.real(text("the change of component %d", i + 1));
    }
    out.rows = mixed_control(controls, variables);
    return out;
}

element::Kind read_circulating(Lines& lines) {
    const element::Variables variables = read_variables(lines);
    element::Circulating out;
    element::Controls controls;
    for (int i = 0; i < 6; ++i) {
        Fields fields = component_line(lines, i);
        controls[static_cast<std::size_t>(i)] = read_control(fields);
        out.amplitude[i] = fields.real(text("the amplitude of component %d", i + 1));
        out.phase[i] = fields.real(text("the phase of component %d", i + 1));
        out.drift[i] = fields.real(text("the change of component %d", i + 1));
    }
    out.rows = mixed_control(controls, variables);
    out.rate_at_midpoint = true;
    return out;
}

element::Kind read_deformation_gradient(Lines& lines) {
    constexpr const char* names[] = {"F11", "F22", "F33", "F12", "F21", "F13", "F31", "F23", "F32"};
    element::DeformationGradient out;
    int last = 0;
    for (const char* name : names) {
        const Line& line = lines.next(name);
        out.F(name[1] - '1', name[2] - '1') = Fields(lines, line).single(name);
        last = line.number;
    }
    // F = 1 + x (F_end - 1) must stay invertible all the way; sampled, for det is a cubic of x.
    constexpr int samples = 1000;
    const element::Matrix3 change = out.F - element::Matrix3::Identity();
    for (int i = 1; i <= samples; ++i) {
        const double x = static_cast<double>(i) / samples;
        const double J = (element::Matrix3::Identity() + x * change).determinant();
        if (!(J > 0.0))
            lines.fail(last,
                       text("det F must be > 0 on the way from 1 to F, got %g at %g of it", J, x));
    }
    out.path = element::DeformationGradient::Path::linear;
    out.increments = element::DeformationGradient::Increments::hughes_winget;
    return out;
}

element::Kind read_restrictions(Lines& lines) {
    element::Linear out;
    for (int r = 0; r < 6; ++r) {
        const Line& line = lines.next(text("restriction %d of 6", r + 1));
        const Restriction restriction = read_restriction(lines, line);
        out.rows.stress.row(r) = restriction.stress;
        out.rows.strain.row(r) = restriction.strain;
        out.change[r] = restriction.change;
    }
    return out;
}

element::Kind read_stress_perturbations(Lines& lines) {
    return read_perturbations(lines, Control::stress);
}

element::Kind read_strain_perturbations(Lines& lines) {
    return read_perturbations(lines, Control::strain);
}

element::Kind read_random_walk(Lines& lines) {
    const element::Linear given = std::get<element::Linear>(read_linear(lines));
    element::RandomWalk out;
    out.rows = given.rows;
    out.amplitude = given.change.cwiseAbs();
    return out;
}

}  // namespace incremental_driver
