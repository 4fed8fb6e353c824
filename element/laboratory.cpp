// SPDX-License-Identifier: BSD-3-Clause
#include "element/laboratory.hpp"

namespace element {
namespace {

constexpr Control E = Control::strain, S = Control::stress;  // prescribed

Step linear(const Controls& controls, double first, Variables variables = Variables::cartesian) {
    Linear kind;
    kind.rows = mixed_control(controls, variables);
    kind.change[0] = first;
    Step step;
    step.kind = kind;
    return step;
}

// The prescribed component is number 4.
Step shear(const Controls& controls, double gamma) {
    Linear kind;
    kind.rows = mixed_control(controls);
    kind.change[3] = gamma;
    Step step;
    step.kind = kind;
    return step;
}

Step lasting(Step step, double duration) {
    step.duration = duration;
    return step;
}

Step undrained(Step step) {
    step.undrained = true;
    return step;
}

}  // namespace

Step component_control(const Controls& controls, const Vector6& change) {
    Linear kind;
    kind.rows = mixed_control(controls);
    kind.change = change;
    Step step;
    step.kind = kind;
    return step;
}

Step isotropic_stress(double change_of_each) {
    return component_control({S, S, S, E, E, E}, change_of_each * unit_tensor());
}

Step isotropic_strain(double volumetric_strain) {
    return component_control({E, E, E, E, E, E}, volumetric_strain / 3.0 * unit_tensor());
}

Step oedometer_strain(double axial_strain) { return linear({E, E, E, E, E, E}, axial_strain); }

Step oedometer_stress(double change_of_axial_stress) {
    return linear({S, E, E, E, E, E}, change_of_axial_stress);
}

Step triaxial_drained(double axial_strain) { return linear({E, S, S, E, E, E}, axial_strain); }

Step triaxial_drained_stress(double change_of_axial_stress) {
    return linear({S, S, S, E, E, E}, change_of_axial_stress);
}

Step triaxial_undrained(double axial_strain) { return undrained(triaxial_drained(axial_strain)); }

Step triaxial_undrained_stress(double change_of_axial_total_stress) {
    return undrained(triaxial_drained_stress(change_of_axial_total_stress));
}

Step triaxial_constant_p(double axial_strain) {
    Linear kind;
    kind.rows = mixed_control({E, S, S, E, E, E});
    kind.rows.stress.row(1) = stress_variables(Variables::roscoe).row(0);  // p
    kind.rows.stress.row(2) = stress_variables(Variables::roscoe).row(2);  // s33 - s22
    kind.change[0] = axial_strain;
    Step step;
    step.kind = kind;
    return step;
}

Step constant_volume_triaxial(double axial_strain) {
    Vector6 change = Vector6::Zero();
    change.head<3>() << axial_strain, -0.5 * axial_strain, -0.5 * axial_strain;
    return component_control({E, E, E, E, E, E}, change);
}

Step biaxial_drained(double axial_strain) { return linear({E, S, E, E, E, E}, axial_strain); }

Step true_triaxial(const Vector6& stress_change) {
    return component_control({S, S, S, E, E, E}, stress_change);
}

Step simple_shear_constant_stress(double gamma) { return shear({E, S, E, E, E, E}, gamma); }

Step simple_shear_constant_volume(double gamma) { return shear({E, E, E, E, E, E}, gamma); }

Step relaxation(double duration) { return lasting(linear({E, E, E, E, E, E}, 0.0), duration); }

Step creep(double duration) { return lasting(linear({S, S, S, S, S, S}, 0.0), duration); }

Step drainage() {
    Step step = creep(0.0);
    step.drains = true;
    return step;
}

}  // namespace element
