// SPDX-License-Identifier: BSD-3-Clause
// What the module is made of.
#pragma once

#include <algorithm>
#include <string>

#include <grit/grit.h>
#include <pybind11/pybind11.h>

namespace grit_python {

namespace py = pybind11;

// The prepared material as Python holds it.
struct Sand {
    grit_sand prepared{};
};

// __reduce_ex__ of every class: protocols 0 and 1 would make an instance of pybind11's base, which ends the process.
inline py::object reduce(const py::object& self, int protocol) {
    const py::object base = py::module_::import("builtins").attr("object");
    return base.attr("__reduce_ex__")(self, std::max(protocol, 2));
}

// The number of a parameter by its name or symbol; -1 for "void_ratio": GRIT_SAND_NO_PARAMETER, element::by_void_ratio.
int direction_of(const std::string& name);

void add_sand(py::module_& module);
py::class_<Sand> add_sand_type(py::module_& module);
void add_sand_operators(py::class_<Sand>& sand);
void add_contact(py::module_& module);
void add_contact_normals(py::module_& module);
void add_contact_distance(py::module_& module);
void add_penalty(py::module_& module);
void add_element(py::module_& module);
void tell_signatures(const py::module_& module);  // of all that was added

}  // namespace grit_python
