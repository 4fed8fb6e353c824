/* SPDX-License-Identifier: BSD-3-Clause
 * Views: the host's own memory, described by a base pointer and strides counted in doubles.
 *
 *   component c of point i  =  base[i * point_stride + c * component_stride]
 *
 * Array of structures: point_stride 6, component_stride 1. Structure of arrays: point_stride 1,
 * component_stride n. A point_stride of 0 gives every point the same input (never an output). */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct grit_view {
    const double* base;
    ptrdiff_t point_stride;
    ptrdiff_t component_stride;
} grit_view;

typedef struct grit_mutable_view {
    double* base;
    ptrdiff_t point_stride;
    ptrdiff_t component_stride;
} grit_mutable_view;

/* entry (r, c) of point i = base[i * point_stride + r * row_stride + c * column_stride];
 * Fortran's column-major 6 x 6 matrix is row_stride 1, column_stride 6. */
typedef struct grit_matrix_view {
    const double* base;
    ptrdiff_t point_stride;
    ptrdiff_t row_stride;
    ptrdiff_t column_stride;
} grit_matrix_view;

typedef struct grit_mutable_matrix_view {
    double* base;
    ptrdiff_t point_stride;
    ptrdiff_t row_stride;
    ptrdiff_t column_stride;
} grit_mutable_matrix_view;

static inline grit_view grit_view_of(const double* base, ptrdiff_t point_stride,
                                     ptrdiff_t component_stride) {
    grit_view view;
    view.base = base;
    view.point_stride = point_stride;
    view.component_stride = component_stride;
    return view;
}

static inline grit_mutable_view grit_mutable_view_of(double* base, ptrdiff_t point_stride,
                                                     ptrdiff_t component_stride) {
    grit_mutable_view view;
    view.base = base;
    view.point_stride = point_stride;
    view.component_stride = component_stride;
    return view;
}

static inline grit_matrix_view grit_matrix_view_of(const double* base, ptrdiff_t point_stride,
                                                   ptrdiff_t row_stride, ptrdiff_t column_stride) {
    grit_matrix_view view;
    view.base = base;
    view.point_stride = point_stride;
    view.row_stride = row_stride;
    view.column_stride = column_stride;
    return view;
}

static inline grit_mutable_matrix_view grit_mutable_matrix_view_of(double* base,
                                                                   ptrdiff_t point_stride,
                                                                   ptrdiff_t row_stride,
                                                                   ptrdiff_t column_stride) {
    grit_mutable_matrix_view view;
    view.base = base;
    view.point_stride = point_stride;
    view.row_stride = row_stride;
    view.column_stride = column_stride;
    return view;
}

#ifdef __cplusplus
}
#endif
