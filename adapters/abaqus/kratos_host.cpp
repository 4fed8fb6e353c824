// SPDX-License-Identifier: BSD-3-Clause
// Kratos hands its own vectors to a UMAT as they are: 11 22 33 12 23 13. It looks up umat_ where
// IS_FORTRAN_UDSM is true and umat, which is to be C, where it is not: DDSDDE is read by rows then.
#include "adapters/abaqus/layout.hpp"

namespace grit::abaqus {

const Host host = {{0, 1, 2, 3, 5, 4}, Matrix::columns, Matrix::rows};

}  // namespace grit::abaqus
