// SPDX-License-Identifier: BSD-3-Clause
// The entry points of the VUMAT in double precision: vumat_ (Fortran's), vumat and VUMAT.
#include <cstddef>

#include "adapters/abaqus/vumat_arguments.hpp"

#define GRIT_ENTRY __attribute__((visibility("default")))

extern "C" {

// Reals are double, integers are int; cmname and its hidden length are not looked at. Only nblock is
// read of what some hosts pass as an array there.
GRIT_ENTRY void
vumat_(const int* nblock, const int* ndir, const int* nshr, const int* nstatev,
       const int* /*nfieldv*/, const int* nprops, const int* /*lanneal*/, const double* stepTime,
       const double* totalTime, const double* /*dt*/, const char* /*cmname*/,
       const double* /*coordMp*/, const double* /*charLength*/, const double* props,
       const double* density, const double* strainInc, const double* /*relSpinInc*/,
       const double* /*tempOld*/, const double* /*stretchOld*/, const double* /*defgradOld*/,
       const double* /*fieldOld*/, const double* stressOld, const double* stateOld,
       const double* enerInternOld, const double* enerInelasOld, const double* /*tempNew*/,
       const double* /*stretchNew*/, const double* /*defgradNew*/, const double* /*fieldNew*/,
       double* stressNew, double* stateNew, double* enerInternNew, double* enerInelasNew,
       std::size_t /*length of cmname*/) {
    grit::abaqus::run_vumat({nblock, ndir, nshr, nstatev, nprops, stepTime, totalTime, props,
                             density, strainInc, stressOld, stateOld, enerInternOld, enerInelasOld,
                             stressNew, stateNew, enerInternNew, enerInelasNew});
}

GRIT_ENTRY decltype(vumat_) vumat __attribute__((alias("vumat_")));
GRIT_ENTRY decltype(vumat_) VUMAT __attribute__((alias("vumat_")));
}
