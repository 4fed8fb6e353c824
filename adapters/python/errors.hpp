// SPDX-License-Identifier: BSD-3-Clause
// Python exceptions that carry Grit's message: Error, and one below it per status.
#pragma once

#include <grit/grit.h>
#include <pybind11/pybind11.h>

namespace grit_python {

namespace py = pybind11;

void add_errors(py::module_& module);

// Raises the exception of error.status with attributes status, point, and `name` if it is not null.
[[noreturn]] void raise(const grit_error& error, const char* name = nullptr,
                        const py::object& attribute = py::none());
// GRIT_BAD_CALL, printf-like.
[[noreturn]] void refuse(const char* format, ...) __attribute__((format(printf, 1, 2)));

inline void check(grit_status status, const grit_error& error) {
    if (status != GRIT_OK) raise(error);
}
// For functions that write no message.
void check(grit_status status, const char* what);

}  // namespace grit_python
