/* SPDX-License-Identifier: BSD-3-Clause */
#pragma once

#if defined(GRIT_BUILDING) && defined(__GNUC__)
#define GRIT_API __attribute__((visibility("default")))
#else
#define GRIT_API
#endif
