// SPDX-License-Identifier: BSD-3-Clause
// The arguments of a UMAT that the sand looks at. Any of the optional ones may be null: hosts differ.
#pragma once

namespace grit::abaqus {

// How a host reads DDSDDE; symmetric: by columns, and it symmetrises (docs/adr/0006).
enum class Matrix { columns, rows, symmetric };

struct UmatArguments {
    // in and out
    double* stress;  // [ntens]
    double* statev;  // [nstatv]
    double* ddsdde;  // [ntens x ntens], optional
    double* sse;     // optional
    double* pnewdt;  // optional
    // in
    const double* dstran;   // [ntens]
    const double* drot;     // [3 x 3] column-major, optional
    const double* props;    // [nprops]
    const int *ndi, *nshr;  // optional
    const int *ntens, *nstatv, *nprops;
    const int *noel, *npt;  // optional, for messages
    Matrix matrix;          // of DDSDDE
};

// The whole call: an update, or a complaint and PNEWDT.
void run_umat(const UmatArguments& call);

}  // namespace grit::abaqus
