/* SPDX-License-Identifier: BSD-3-Clause
 * Sands with published parameters. */
#pragma once

#include <grit/sand.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct grit_sand_record {
    const char* name; /* key for grit_sand_record_find, e.g. "lausitz" */
    const char* title;
    const char* status; /* "A" two independent sources agree, "B" one source or a conflict */
    const char* source; /* where the numbers were published */
    const char* note;   /* what a user must know, may be empty */
} grit_sand_record;

GRIT_API int grit_sand_record_count(void);
/* Record index = 0 ... count - 1, null otherwise. */
GRIT_API const grit_sand_record* grit_sand_record_at(int index);
/* Index of a name, -1 if there is none. */
GRIT_API int grit_sand_record_find(const char* name);
/* Parameters of a record, stresses in kPa times stress_scale (1000 gives Pa, 0.001 MPa). */
GRIT_API grit_status grit_sand_record_parameters(int index, double stress_scale,
                                                 grit_sand_parameters* parameters);

#ifdef __cplusplus
}
#endif
