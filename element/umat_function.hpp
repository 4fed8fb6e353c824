// SPDX-License-Identifier: BSD-3-Clause
// The argument list of a UMAT as Abaqus/Standard calls it.
#pragma once

#include <cstddef>

namespace element {

using UmatFunction = void (*)(double* stress, double* statev, double* ddsdde, double* sse,
                              double* spd, double* scd, double* rpl, double* ddsddt, double* drplde,
                              double* drpldt, double* stran, double* dstran, double* time,
                              double* dtime, double* temp, double* dtemp, double* predef,
                              double* dpred, char* cmname, int* ndi, int* nshr, int* ntens,
                              int* nstatv, double* props, int* nprops, double* coords, double* drot,
                              double* pnewdt, double* celent, double* dfgrd0, double* dfgrd1,
                              int* noel, int* npt, int* layer, int* kspt, int* kstep, int* kinc,
                              std::size_t cmname_length);

}  // namespace element
