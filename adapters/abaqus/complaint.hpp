// SPDX-License-Identifier: BSD-3-Clause
// How a failed call speaks: PNEWDT for the host, one line on stderr for its user.
#pragma once

#include <grit/status.h>

#include "adapters/abaqus/umat_arguments.hpp"

namespace grit::abaqus {

// PNEWDT where the cause does not say how much smaller an increment must be.
constexpr double default_reduction = 0.25;

// Ask for a smaller increment. The line is left out where the host learns by PNEWDT all there is to
// know, that is when the sand has not converged: hosts iterate through such increments by the thousand.
void fail(const UmatArguments& call, const grit_error& why, double step_reduction);

// Fill error in the manner of the library.
__attribute__((format(printf, 3, 4))) grit_status failure(grit_error& error, grit_status status,
                                                          const char* format, ...);

}  // namespace grit::abaqus
