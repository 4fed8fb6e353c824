// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/python/errors.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <iterator>

#include "adapters/host/failure.hpp"

namespace grit_python {
namespace {

struct Kind {
    const char* name;
    PyObject* const* base;  // beside Error
    const char* doc;
};

// By status; 0 is what they have in common.
const std::array<Kind, 6> kinds{{
    {"Error", &PyExc_Exception,
     "What Grit reports: the message names value, limit and unit. Attributes: status (GRIT_...), "
     "point "
     "(the first failed point or node, of an index what stands there, not where; -1 if none is "
     "meant)."},
    {"BadCall", &PyExc_ValueError,
     "Fix the call: shape, dtype, option, or input that is not finite."},
    {"BadParameter", &PyExc_ValueError,
     "Fix the material: a parameter is missing or out of range."},
    {"BadState", &PyExc_ValueError, "Fix the state of that point."},
    {"NotConverged", &PyExc_ArithmeticError,
     "Retry with smaller increments. Of updates, attribute reports: step_reduction says how much, "
     "and which points are done. Of element_test, history: what was reached. Of "
     "contact_normals_by_regression, normal: those of the others."},
    {"InternalError", &PyExc_RuntimeError, "Report a bug."},
}};

// Never released: the interpreter may end after this library's statics.
std::array<PyObject*, kinds.size()> types{};

}  // namespace

void add_errors(py::module_& module) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const Kind& kind = kinds[i];
        const py::handle base(*kind.base);
        const py::tuple bases =
            i == 0 ? py::make_tuple(base) : py::make_tuple(py::handle(types[0]), base);
        const std::string name = std::string("grit.") + kind.name;
        types[i] = PyErr_NewExceptionWithDoc(name.c_str(), kind.doc, bases.ptr(), nullptr);
        if (!types[i]) throw py::error_already_set();
        module.attr(kind.name) = py::handle(types[i]);
    }
}

void raise(const grit_error& error, const char* name, const py::object& attribute) {
    const bool known = error.status > 0 && error.status < static_cast<int>(kinds.size());
    const py::handle type =
        types[known ? static_cast<std::size_t>(error.status) : types.size() - 1];
    const py::object exception = type(py::str(error.message));
    exception.attr("status") = error.status;
    exception.attr("point") = error.point;
    if (name) exception.attr(name) = attribute;
    PyErr_SetObject(type.ptr(), exception.ptr());
    throw py::error_already_set();
}

void refuse(const char* format, ...) {
    grit_error error{};
    va_list arguments;
    va_start(arguments, format);
    grit::vfailure(error, GRIT_BAD_CALL, format, arguments);
    va_end(arguments);
    raise(error);
}

void check(grit_status status, const char* what) {
    if (status == GRIT_OK) return;
    grit_error error{};
    error.status = status;
    error.point = -1;
    std::snprintf(error.message, sizeof error.message, "%s: %s", what, grit_status_name(status));
    raise(error);
}

}  // namespace grit_python
