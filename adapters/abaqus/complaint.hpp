// SPDX-License-Identifier: BSD-3-Clause
// How a failed call speaks to its user: one line on stderr, once in the life of the process, and once more
// where an increment was too large. A host repeats its calls by the thousand, and the first failure is
// the one to look at.
#pragma once

#include <grit/status.h>

namespace grit::abaqus {

// "Grit UMAT: element 12, point 3: ...", or what else where says; nothing if a line was written before.
// The message is the library's: a number of the point at its head is dropped.
__attribute__((format(printf, 2, 3))) void complain(const grit_error& why, const char* where, ...);

}  // namespace grit::abaqus
