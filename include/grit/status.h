/* SPDX-License-Identifier: BSD-3-Clause
 * What every Grit function returns, and where it writes down what went wrong. */
#pragma once

#include <stddef.h>

#include <grit/export.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A status says what the caller can do about it. */
typedef int grit_status;

enum {
    GRIT_OK = 0,
    GRIT_BAD_CALL = 1,      /* fix the call: null pointer, wrong size, unknown option */
    GRIT_BAD_PARAMETER = 2, /* fix the material: a parameter is missing or out of range */
    GRIT_BAD_STATE = 3,     /* fix the state of that point: not finite, e <= 0, |h| > R */
    GRIT_NOT_CONVERGED = 4, /* retry with a smaller increment: step_reduction suggests how much */
    GRIT_INTERNAL = 5       /* report a bug */
};

enum { GRIT_MESSAGE_SIZE = 256 };

/* Caller-owned; optional in every call that takes one (null: only the status is returned).
 * Written on failure only. point: the first failed point or node, of an index list what stands there, not where;
 * -1 if none is meant. */
typedef struct grit_error {
    grit_status status;
    int reserved;
    ptrdiff_t point;
    char message[GRIT_MESSAGE_SIZE]; /* names value, limit and unit; always terminated */
} grit_error;

/* A short English name of a status ("not converged"), never null. */
GRIT_API const char* grit_status_name(grit_status status);

#ifdef __cplusplus
}
#endif
