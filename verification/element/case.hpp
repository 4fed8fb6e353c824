// SPDX-License-Identifier: BSD-3-Clause
// What an element test is. Stresses in kPa, angles in rad, tension positive, Voigt order
// 11 22 33 12 13 23 with engineering shear, strains logarithmic.
#pragma once

#include <optional>
#include <string>

#include <grit/grit.h>

#include "element/control.hpp"

namespace element {

enum class IntergranularStrain {
    off,       // basic hypoplasticity
    zero,      // h = 0: no memory
    mobilised  // |h| = R as left by isotropic compression
};

struct Start {
    double pressure = 100.0;                   // p, isotropic [kPa]
    std::optional<double> void_ratio;          // e at that pressure [-], or ...
    std::optional<double> void_ratio_at_zero;  // ... e_0 at zero pressure [-]
    IntergranularStrain intergranular_strain = IntergranularStrain::mobilised;
};

// A straight path: each component has either its strain or its stress prescribed.
struct Loading {
    Controls control{};
    Vector6 change = Vector6::Zero();  // of the prescribed strain [-] or stress [kPa]
    int increments = 400;
    double first_share = 0.0;  // of the path in the first increment, growing geometrically; 0: even
};

struct Numerics {
    double tolerance = 1e-6;  // of grit_sand_update, and of the prescribed stress, relative
    int evaluation_limit = 20000;
};

struct Case {
    std::string name;   // of the files it writes
    std::string title;  // for people
    std::string sand;   // name of the sand, for people
    grit_sand_parameters parameters{};
    Start start;
    Loading loading;
    Numerics numerics;
};

// Axial strain prescribed along 11, radial stress constant: drained triaxial compression or,
// with a positive strain, extension.
inline Loading drained_triaxial(double axial_strain) {
    Loading loading;
    loading.control[1] = loading.control[2] = Control::stress;
    loading.change[0] = axial_strain;
    return loading;
}

}  // namespace element
