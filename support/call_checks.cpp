// SPDX-License-Identifier: BSD-3-Clause
#include "support/call_checks.hpp"

namespace grit {

void word(grit_error* error, std::ptrdiff_t point, Named about, const char* format, ...) {
    if (!error) return;
    char wrong[sizeof error->message];
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(wrong, sizeof wrong, format, arguments);
    va_end(arguments);
    if (!about.owner) failure(error, GRIT_BAD_CALL, point, "%s%s", about.name, wrong);
    else if (!about.numbered)
        failure(error, GRIT_BAD_CALL, point, "%s: %s%s", about.owner, about.name, wrong);
    else
        failure(error, GRIT_BAD_CALL, point, "%s %td: %s%s", about.owner, about.number, about.name,
                wrong);
}

}  // namespace grit
