// SPDX-License-Identifier: BSD-3-Clause
#include "umat/api/update_call.hpp"

using namespace grit;

extern "C" {

grit_status grit_sand_options_init(grit_sand_options* options, size_t struct_size) {
    return init_versioned(default_options, options, struct_size) ? GRIT_OK : GRIT_BAD_CALL;
}

grit_status grit_sand_update(const grit_sand* sand, const grit_sand_options* options, ptrdiff_t n,
                             const grit_sand_points* points, grit_sand_report* reports,
                             grit_error* error) {
    SandCall call;
    GRIT_CHECK(read_call("grit_sand_update", sand, options, n, points, call, error));
    GRIT_CHECK(check_update(call, n, error));
    if (n == 0) return GRIT_OK;
    const UpdateRequest request = request_of(*sand, call, n, reports);
    const UpdateOutcome outcome = run(request);
    return outcome.fault == Fault::none ? GRIT_OK : describe(request, outcome, error);
}
}
