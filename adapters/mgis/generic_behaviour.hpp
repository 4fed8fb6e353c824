// SPDX-License-Identifier: BSD-3-Clause
// The structures that a host of MGIS hands to a "generic" behaviour: version 1 of that interface, its
// names and its layout as published by MGIS. Tensors come in Mandel's components, shear times sqrt 2.
#pragma once

extern "C" {

// At the start of the increment: for reading only.
struct mfront_gb_InitialState {
    const double* gradients;             // strain [components]
    const double* thermodynamic_forces;  // stress [components]
    const double* mass_density;          // [1], may be null
    const double* material_properties;
    const double* internal_state_variables;
    const double* stored_energy;      // [1], may be null
    const double* dissipated_energy;  // [1], may be null
    const double* external_state_variables;
};

// At its end.
struct mfront_gb_State {
    const double* gradients;
    double* thermodynamic_forces;
    const double* mass_density;
    const double* material_properties;
    double* internal_state_variables;
    double* stored_energy;
    double* dissipated_energy;
    const double* external_state_variables;
};

struct mfront_gb_BehaviourData {
    char* error_message;  // room for 512 bytes, or null
    double dt;
    double* K;               // in: K[0] says what to compute; out: the operator, row-major
    double* rdt;             // factor on the next time step, or null
    double* speed_of_sound;  // written where K[0] asks for it
    mfront_gb_InitialState s0;
    mfront_gb_State s1;
};
}

namespace grit::mgis {

constexpr int error_message_size = 512;

// What a behaviour returns. 0, "unreliable", is never returned here.
enum : int { failed = -1, reliable = 1 };

}  // namespace grit::mgis
