// SPDX-License-Identifier: BSD-3-Clause
#include <grit/status.h>
#include <grit/version.h>

extern "C" {

int grit_version(void) {
    return 10000 * GRIT_VERSION_MAJOR + 100 * GRIT_VERSION_MINOR + GRIT_VERSION_PATCH;
}

const char* grit_status_name(grit_status status) {
    switch (status) {
        case GRIT_OK: return "ok";
        case GRIT_BAD_CALL: return "bad call";
        case GRIT_BAD_PARAMETER: return "bad parameter";
        case GRIT_BAD_STATE: return "bad state";
        case GRIT_NOT_CONVERGED: return "not converged";
        case GRIT_INTERNAL: return "internal error";
        default: return "unknown status";
    }
}
}
