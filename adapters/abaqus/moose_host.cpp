// SPDX-License-Identifier: BSD-3-Clause
// MOOSE looks up umat_ and reads DDSDDE by rows, which only a law with a symmetric one does not notice.
#include "adapters/abaqus/layout.hpp"

namespace grit::abaqus {

const Host host = {{0, 1, 2, 3, 4, 5}, Matrix::rows, Matrix::rows};

}  // namespace grit::abaqus
