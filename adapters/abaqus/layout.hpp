// SPDX-License-Identifier: BSD-3-Clause
// The layout of PROPS and STATEV that a library speaks (docs/umat.md): it is linked with one of them,
// and nothing is recognised while it runs.
#pragma once

#include <grit/radian_layout.h>

#include "adapters/abaqus/umat_arguments.hpp"

namespace grit::abaqus {

struct Layout {
    double angle;            // unit of PROPS(1) and of the mobilised angle [rad]
    const char* angle_unit;  // for messages
    const char* other_unit;  // the one that phi_c may have been given in by mistake
    int h, void_ratio;       // where h begins and where e is in STATEV; the rest is common
    // PROPS(1) ... PROPS(16) of the classic layout; a complaint in error if that cannot be.
    grit_status (*classic)(const double* props, double out[GRIT_CLASSIC_NPROPS], grit_error& error);
};

extern const Layout layout;

// What a library for one host knows of it.
struct Host {
    int order[6];        // where it has 11 22 33 12 13 23 of a UMAT; STATEV is always in this order
    Matrix umat_, umat;  // how it reads what the entries of these names write
};

extern const Host host;

}  // namespace grit::abaqus
