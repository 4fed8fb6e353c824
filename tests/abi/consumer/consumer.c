/* SPDX-License-Identifier: BSD-3-Clause
 * The least a stranger does: link, and ask for a sand. */
#include <grit/grit.h>

int main(void) {
    grit_sand_parameters parameters;
    grit_sand sand;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    if (grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &parameters)) return 1;
    if (grit_sand_prepare(&parameters, &sand, NULL)) return 2;
    return grit_version() ==
                   10000 * GRIT_VERSION_MAJOR + 100 * GRIT_VERSION_MINOR + GRIT_VERSION_PATCH
               ? 0
               : 3;
}
