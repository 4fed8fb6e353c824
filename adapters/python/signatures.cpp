// SPDX-License-Identifier: BSD-3-Clause
// Signatures as inspect.signature(), help() and editors read them: "name(self, a, b=1.0)" and a line "--" at the head of a docstring.
// pybind11 writes "name(self: grit.Sand, a: float, b: float = 1.0) -> float" there.
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/python/parts.hpp"

namespace grit_python {
namespace {

// "a: list[str], b: float = 1.0" in its parts, by the commas that no bracket or quote holds.
std::vector<std::string> arguments_of(std::string_view text) {
    std::vector<std::string> out(1);
    int depth = 0;
    bool quoted = false;
    for (const char c : text) {
        quoted = quoted != (c == '\'');
        if (!quoted) depth += std::strchr("([{<", c) ? 1 : std::strchr(")]}>", c) ? -1 : 0;
        if (c == ',' && depth == 0 && !quoted) out.emplace_back();
        else if (!(out.back().empty() && c == ' ')) out.back() += c;
    }
    if (out.back().empty()) out.pop_back();
    return out;
}

// "b: float = 1.0" without its type; infinity as a number that Python reads.
std::string bare(const std::string& argument) {
    const std::size_t colon = argument.find(':'), equal = argument.find(" = ");
    const std::string name = argument.substr(0, std::min(colon, equal));
    if (equal == std::string::npos) return name;
    const std::string value = argument.substr(equal + 3);
    return name + "=" + (value == "inf" ? "1e999" : value);
}

void tell(PyCFunctionObject& function) {
    const char*& doc = function.m_ml->ml_doc;
    if (!doc) return;
    const std::string text = doc;
    const std::size_t open = text.find('('), arrow = text.find(") -> "), end = text.find('\n');
    if (open == std::string::npos || arrow == std::string::npos || arrow > end) return;
    std::string out = text.substr(0, open + 1);
    for (const std::string& argument : arguments_of({&text[open + 1], arrow - open - 1}))
        out += (out.back() == '(' ? "" : ", ") + bare(argument);
    out += ")\n--\n\n";
    const std::size_t begin = text.find_first_not_of('\n', end);
    if (begin != std::string::npos) out += text.substr(begin);
    std::free(const_cast<char*>(doc));  // as pybind11 does, which has it from strdup
    doc = strdup(out.c_str());
}

void tell_all(const py::dict& names) {
    for (const auto& [name, value] : names) {
        const bool is_static = PyObject_TypeCheck(value.ptr(), &PyStaticMethod_Type);
        const py::object held = is_static ? py::object(value.attr("__func__"))
                                          : py::reinterpret_borrow<py::object>(value);
        const py::handle function = py::detail::get_function(held);
        if (function && PyCFunction_Check(function.ptr()))
            tell(*reinterpret_cast<PyCFunctionObject*>(function.ptr()));
        else if (PyType_Check(value.ptr()) && !PyExceptionClass_Check(value.ptr()))
            tell_all(py::dict(value.attr("__dict__")));
    }
}

}  // namespace

void tell_signatures(const py::module_& module) {
    tell_all(module.attr("__dict__"));
    tell_all(module.attr("stage").attr("__dict__"));
}

}  // namespace grit_python
