// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/layout.hpp"

namespace grit::abaqus {

const Host host = {{0, 1, 2, 3, 4, 5}, Matrix::columns, Matrix::columns};

}  // namespace grit::abaqus
