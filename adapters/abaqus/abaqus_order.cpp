// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/layout.hpp"

namespace grit::abaqus {

const int host_order[6] = {0, 1, 2, 3, 4, 5};

}  // namespace grit::abaqus
