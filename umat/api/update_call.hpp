// SPDX-License-Identifier: BSD-3-Clause
// An update of many points at the C border: what is asked of a call, the instruction set, the words of a failure.
#pragma once

#include "umat/api/call.hpp"
#include "umat/batch/request.hpp"

namespace grit {

grit_status check_update(const SandCall& call, std::ptrdiff_t n, grit_error* error);

// reports may be null.
UpdateRequest request_of(const grit_sand& sand, const SandCall& call, std::ptrdiff_t n,
                         grit_sand_report* reports);

UpdateOutcome run(const UpdateRequest& request);

// Say in words what was found at a point, from the same numbers the kernel saw.
grit_status describe(const UpdateRequest& request, const UpdateOutcome& found, grit_error* error);

}  // namespace grit
