// SPDX-License-Identifier: BSD-3-Clause
// Kratos hands its own vectors to a UMAT as they are: 11 22 33 12 23 13.
#include "adapters/abaqus/layout.hpp"

namespace grit::abaqus {

const int host_order[6] = {0, 1, 2, 3, 5, 4};

}  // namespace grit::abaqus
