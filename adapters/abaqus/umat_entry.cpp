// SPDX-License-Identifier: BSD-3-Clause
// The entry points of the UMAT, one function under the names that hosts look up: umat_ (Fortran's, of
// Abaqus, MOOSE and Kratos), umat, UMAT, and SAND for CalculiX, which writes names in upper case.
#include <cstddef>

#include "adapters/abaqus/umat_arguments.hpp"

#define GRIT_ENTRY __attribute__((visibility("default")))

extern "C" {

// Reals are double, integers are int. The name of the material and its hidden length are never looked
// at, for one host passes a single character and no length.
GRIT_ENTRY void umat_(double* STRESS, double* STATEV, double* DDSDDE, double* SSE, double* /*SPD*/,
                      double* /*SCD*/, double* /*RPL*/, double* /*DDSDDT*/, double* /*DRPLDE*/,
                      double* /*DRPLDT*/, const double* /*STRAN*/, const double* DSTRAN,
                      const double* /*TIME*/, const double* /*DTIME*/, const double* /*TEMP*/,
                      const double* /*DTEMP*/, const double* /*PREDEF*/, const double* /*DPRED*/,
                      const char* /*CMNAME*/, const int* NDI, const int* NSHR, const int* NTENS,
                      const int* NSTATV, const double* PROPS, const int* NPROPS,
                      const double* /*COORDS*/, const double* DROT, double* PNEWDT,
                      const double* /*CELENT*/, const double* /*DFGRD0*/, const double* /*DFGRD1*/,
                      const int* NOEL, const int* NPT, const int* /*LAYER*/, const int* /*KSPT*/,
                      const int* /*KSTEP*/, const int* /*KINC*/, std::size_t /*length of CMNAME*/) {
    grit::abaqus::run_umat({STRESS, STATEV, DDSDDE, SSE, PNEWDT, DSTRAN, DROT, PROPS, NDI, NSHR,
                            NTENS, NSTATV, NPROPS, NOEL, NPT});
}

GRIT_ENTRY decltype(umat_) umat __attribute__((alias("umat_")));
GRIT_ENTRY decltype(umat_) UMAT __attribute__((alias("umat_")));
GRIT_ENTRY decltype(umat_) SAND __attribute__((alias("umat_")));
}
