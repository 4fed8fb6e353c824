// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>

#include <grit/contact.h>

#include "support/versioned.hpp"

extern "C" grit_status grit_contact_options_init(grit_contact_options* options,
                                                 size_t struct_size) {
    grit_contact_options defaults{};
    defaults.components = 3;
    defaults.penalty_power = 6.0;
    defaults.mass_tolerance = 1e-10;
    return grit::init_versioned(defaults, options, struct_size) ? GRIT_OK : GRIT_BAD_CALL;
}
