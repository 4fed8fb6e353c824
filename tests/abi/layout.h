/* SPDX-License-Identifier: BSD-3-Clause
 * Values, sizes and places as callers have compiled them in. A change here is a change of the ABI:
 * append only, and only to structs that start with struct_size. */
#pragma once

#include <stddef.h>

#include <grit/grit.h>

#define VALUE(name, number) _Static_assert((name) == (number), "value of " #name)
#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), "size of " #type)
#define PLACE(type, member, bytes)                                                                 \
    _Static_assert(offsetof(type, member) == (bytes), "place of " #type "." #member)
