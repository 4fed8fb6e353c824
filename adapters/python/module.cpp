// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>

#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"
#include "support/version/commit.hpp"

PYBIND11_MODULE(_grit, module) {
    module.attr("__doc__") = "The compiled part of grit.";
    const int version = grit_version();
    module.attr("__version__") = std::to_string(version / 10000) + "." +
                                 std::to_string(version / 100 % 100) + "." +
                                 std::to_string(version % 100);
    module.attr("__commit__") = grit::commit();
    grit_python::add_errors(module);
    grit_python::add_sand(module);
    grit_python::add_contact(module);
    grit_python::add_contact_normals(module);
    grit_python::add_contact_distance(module);
    grit_python::add_penalty(module);
    grit_python::add_element(module);
    grit_python::tell_signatures(module);
}
