// SPDX-License-Identifier: BSD-3-Clause
// The arguments of a VUMAT that the sand looks at: arrays over a block of points, component by
// component, x(nblock, ...). Stress and strain in the order 11 22 33 12 23 31, tensor shear.
#pragma once

namespace grit::abaqus {

struct VumatArguments {
    const int *nblock, *ndir, *nshr, *nstatev, *nprops;
    const double *step_time, *total_time;  // optional
    const double* props;
    const double* density;  // [nblock], optional: without it no energies
    const double* strain_inc;
    const double* stress_old;
    const double* state_old;
    const double *ener_intern_old, *ener_inelas_old;  // [nblock], optional
    double* stress_new;
    double* state_new;
    double *ener_intern_new, *ener_inelas_new;  // [nblock], optional
};

// The whole block: an update, or a complaint.
void run_vumat(const VumatArguments& call);

}  // namespace grit::abaqus
