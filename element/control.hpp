// SPDX-License-Identifier: BSD-3-Clause
// What a step prescribes: six linear equations for increments of stress and strain.
#pragma once

#include <array>

#include "element/vectors.hpp"

namespace element {

// Row r:  sum_j stress(r, j) d sigma_j + strain(r, j) d eps_j = c_r.
// Rows may mix both; c is in the unit of the row.
struct Restrictions {
    Matrix6 stress = Matrix6::Zero();
    Matrix6 strain = Matrix6::Zero();
};

enum class Control { strain, stress };
using Controls = std::array<Control, 6>;

// Variables that rows may speak of instead of components; shear components stay as they are.
//   roscoe            p = -(s1+s2+s3)/3, q = -s1+(s2+s3)/2, z = s3-s2;
//                     conjugate strains -(e1+e2+e3), -2/3 e1+(e2+e3)/3, (e3-e2)/2
//   roscoe_isomorph   P = sqrt3 p, Q = sqrt(2/3) q, Z = z/sqrt2 and the same of strain
//   rendulic          -s1, -(s2+s3)/sqrt2, (s3-s2)/sqrt2 and the same of strain
// (A. Niemunis, incrementalDriver: p and q compression positive, work-conjugate.)
enum class Variables { cartesian, roscoe, roscoe_isomorph, rendulic };

// Row r prescribes the stress or the strain variable number r.
Restrictions mixed_control(const Controls& controls, Variables variables = Variables::cartesian);

// Value of the six variables: stress_variables(v) * sigma, strain_variables(v) * eps.
Matrix6 stress_variables(Variables variables);
Matrix6 strain_variables(Variables variables);

}  // namespace element
