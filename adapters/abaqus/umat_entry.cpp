// SPDX-License-Identifier: BSD-3-Clause
// The entry points of the UMAT under the names that hosts look up: umat_ (Fortran's, of Abaqus, MOOSE and
// Kratos), umat, UMAT, and SAND for CalculiX, which writes names in upper case.
#include <cstddef>

#include "adapters/abaqus/layout.hpp"

#define GRIT_ENTRY __attribute__((visibility("default")))

// Reals are double, integers are int. The name of the material and its hidden length are never looked
// at, for one host passes a single character and no length.
// clang-format off
#define GRIT_UMAT_PARAMETERS \
    double *STRESS, double *STATEV, double *DDSDDE, double *SSE, double * /*SPD*/, double * /*SCD*/, \
    double * /*RPL*/, double * /*DDSDDT*/, double * /*DRPLDE*/, double * /*DRPLDT*/, \
    const double * /*STRAN*/, const double *DSTRAN, const double * /*TIME*/, \
    const double * /*DTIME*/, const double * /*TEMP*/, const double * /*DTEMP*/, \
    const double * /*PREDEF*/, const double * /*DPRED*/, const char * /*CMNAME*/, \
    const int *NDI, const int *NSHR, const int *NTENS, const int *NSTATV, const double *PROPS, \
    const int *NPROPS, const double * /*COORDS*/, [[maybe_unused]] const double *DROT, \
    double *PNEWDT, const double * /*CELENT*/, const double * /*DFGRD0*/, \
    const double * /*DFGRD1*/, const int *NOEL, const int *NPT, const int * /*LAYER*/, \
    const int * /*KSPT*/, const int * /*KSTEP*/, const int * /*KINC*/, \
    std::size_t /*length of CMNAME*/
// clang-format on

extern "C" {

GRIT_ENTRY void umat_(GRIT_UMAT_PARAMETERS) {
    grit::abaqus::run_umat({STRESS, STATEV, DDSDDE, SSE, PNEWDT, DSTRAN, DROT, PROPS, NDI, NSHR,
                            NTENS, NSTATV, NPROPS, NOEL, NPT, grit::abaqus::host.umat_});
}

GRIT_ENTRY void umat(GRIT_UMAT_PARAMETERS) {
    grit::abaqus::run_umat({STRESS, STATEV, DDSDDE, SSE, PNEWDT, DSTRAN, DROT, PROPS, NDI, NSHR,
                            NTENS, NSTATV, NPROPS, NOEL, NPT, grit::abaqus::host.umat});
}

GRIT_ENTRY decltype(umat) UMAT __attribute__((alias("umat")));

// CalculiX: STRESS and DSTRAN come in axes that do not turn with the material, so h stays too, whatever
// DROT says; and DDSDDE is symmetrised (docs/adr/0006).
GRIT_ENTRY void SAND(GRIT_UMAT_PARAMETERS) {
    grit::abaqus::run_umat({STRESS, STATEV, DDSDDE, SSE, PNEWDT, DSTRAN, nullptr, PROPS, NDI, NSHR,
                            NTENS, NSTATV, NPROPS, NOEL, NPT, grit::abaqus::Matrix::symmetric});
}
}
