// SPDX-License-Identifier: BSD-3-Clause
// Steps in the words of a laboratory. The sample's axis is 11; simple shear is in 12 with 22 normal
// to the plane of shear. Changes are over the whole step, tension positive: compression is negative.
// Set increments, duration, exit and so on in the step returned.
#pragma once

#include "element/step.hpp"

namespace element {

Step component_control(const Controls& controls, const Vector6& change);

Step isotropic_stress(double change_of_each);     // s11 = s22 = s33 by stress
Step isotropic_strain(double volumetric_strain);  // a third each
Step oedometer_strain(double axial_strain);       // lateral strain 0; K0 consolidation
Step oedometer_stress(double change_of_axial_stress);
Step triaxial_drained(double axial_strain);  // radial stress constant
Step triaxial_drained_stress(double change_of_axial_stress);
Step triaxial_undrained(double axial_strain);  // radial total stress constant, pore pressure
Step triaxial_undrained_stress(double change_of_axial_total_stress);
Step triaxial_constant_p(double axial_strain);       // effective mean stress constant, s22 = s33
Step constant_volume_triaxial(double axial_strain);  // strains alone, no pore pressure
Step biaxial_drained(double axial_strain);           // strain 33 zero, stress 22 constant
Step true_triaxial(const Vector6& stress_change);    // three principal stresses
Step simple_shear_constant_stress(double gamma);     // s22 constant, strain 11 and 33 zero
Step simple_shear_constant_volume(double gamma);
Step relaxation(double duration);  // strain held
Step creep(double duration);       // stress held
Step drainage();                   // total stress held, pore pressure to zero

}  // namespace element
