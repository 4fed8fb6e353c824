// SPDX-License-Identifier: BSD-3-Clause
// What a sand is made from, and copies of it: parameters are all that a copy or a pickle needs.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <grit/radian_layout.h>

#include "adapters/python/arrays.hpp"
#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"
#include "element/nearest.hpp"
#include "element/sand_names.hpp"

namespace grit_python {
namespace {

constexpr const char* sand_doc = R"(A sand, prepared: immutable, may be used from several threads.

    Sand("lausitz")                     published parameters, stresses in kPa
    Sand("lausitz", stress_scale=1000)  the same in Pa
    Sand(critical_friction_angle=..., granulate_hardness=..., ...)

Parameters by name or symbol, a name before them gives the values to start from: critical_friction_angle
phi_c [rad], granulate_hardness h_s [stress], stiffness_exponent n, densest_void_ratio e_d0,
critical_void_ratio e_c0, loosest_void_ratio e_i0, pyknotropy_exponent alpha, stiffness_void_exponent
beta, pressure_shift p_t [stress]; and all of the intergranular strain or none: reversal_stiffness m_R,
transverse_stiffness m_T, elastic_strain_radius R, evolution_exponent beta_r,
stiffness_interpolation_exponent chi. Any consistent units: stresses take the unit of h_s.
Raises BadParameter with name, value, limit and unit. sands() lists the names.)";

std::vector<std::string> names_of_parameters() {
    std::vector<std::string> out;
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        out.emplace_back(grit_sand_parameter_describe(i)->name);
    return out;
}

// By its name or symbol; -1: there is none.
int parameter_of(const std::string& name) {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info* const info = grit_sand_parameter_describe(i);
        if (name == info->name || name == info->symbol) return i;
    }
    return -1;
}

template <class Value> Value cast_of(const char* name, const char* what, const py::handle& given) {
    try {
        return given.cast<Value>();
    } catch (const py::cast_error&) {
        refuse("%s must be %s, got %s", name, what, Py_TYPE(given.ptr())->tp_name);
    }
}

Sand prepared(const grit_sand_parameters& parameters) {
    Sand out;
    grit_error error{};
    check(grit_sand_prepare(&parameters, &out.prepared, &error), error);
    return out;
}

Sand make(const py::object& name, double stress_scale, const py::kwargs& given) {
    grit_sand_parameters parameters{};
    check(grit_sand_parameters_init(&parameters, sizeof parameters), "grit_sand_parameters_init");
    if (name.is_none()) {
        if (stress_scale != 1.0)
            refuse("stress_scale is that of a published sand, and no name was given; got %g",
                   stress_scale);
    } else {
        const std::string key = cast_of<std::string>("name", "a string", name);
        const int record = grit_sand_record_find(key.c_str());
        if (record < 0)
            refuse("there is no sand \"%s\"%s", key.c_str(),
                   element::suggestion(key, element::sand_names()).c_str());
        if (!(stress_scale > 0.0) || !std::isfinite(stress_scale))
            refuse("stress_scale must be > 0, got %g", stress_scale);
        check(grit_sand_record_parameters(record, stress_scale, &parameters), key.c_str());
    }
    for (const auto& [key, value] : given) {
        const std::string wanted = py::str(key);
        const int at = parameter_of(wanted);
        if (at < 0) {
            const std::string best = element::nearest(wanted, names_of_parameters());
            refuse("a sand has no parameter \"%s\"%s%s", wanted.c_str(),
                   best.empty() ? ": help(grit.Sand) tells them" : "; nearest: ", best.c_str());
        }
        check(grit_sand_parameter_set(&parameters, at,
                                      cast_of<double>(wanted.c_str(), "a number", value)),
              wanted.c_str());
    }
    return prepared(parameters);
}

// Of the PROPS of a host: what they have beyond the parameters is of its material, not of the sand.
Sand of_props(const py::object& props, const std::string& layout) {
    if (layout != "classic" && layout != "radian")
        refuse("layout must be \"classic\" or \"radian\", got \"%s\"", layout.c_str());
    const Numbers given = several("props", props);
    if (given.size() < GRIT_CLASSIC_WATER_STIFFNESS)
        refuse("props must have %d numbers at least, got %td", GRIT_CLASSIC_WATER_STIFFNESS,
               given.size());
    double own[GRIT_CLASSIC_NPROPS] = {}, classic[GRIT_CLASSIC_NPROPS];
    std::copy_n(given.data(), std::min<py::ssize_t>(given.size(), GRIT_CLASSIC_NPROPS), own);
    if (layout == "radian") grit_radian_to_classic(own, classic);
    grit_sand_parameters parameters{};
    grit_classic_parameters(layout == "radian" ? classic : own, &parameters);
    return prepared(parameters);
}

py::dict parameters_of(const Sand& sand) {
    grit_sand_parameters parameters{};
    check(grit_sand_parameters_init(&parameters, sizeof parameters), "grit_sand_parameters_init");
    check(grit_sand_parameters_of(&sand.prepared, &parameters), "grit_sand_parameters_of");
    py::dict out;
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        double value = 0.0;
        check(grit_sand_parameter_get(&parameters, i, &value), "grit_sand_parameter_get");
        if (!std::isnan(value)) out[grit_sand_parameter_describe(i)->name] = value;
    }
    return out;
}

py::dict sands() {
    py::dict out;
    for (int i = 0; i < grit_sand_record_count(); ++i) {
        const grit_sand_record* record = grit_sand_record_at(i);
        py::dict each;
        each["title"] = record->title;
        each["status"] = record->status;
        each["source"] = record->source;
        each["note"] = record->note;
        out[record->name] = each;
    }
    return out;
}

// As it would be made; floats are written so that they are read as the same.
py::str repr_of(const Sand& sand) {
    std::string text;
    for (const auto& [key, value] : parameters_of(sand)) {
        if (!text.empty()) text += ", ";
        text += std::string(py::str(key)) + "=" + std::string(py::repr(value));
    }
    return "grit.Sand(" + text + ")";
}

Sand restored(const py::dict& parameters) {
    return make(py::none(), 1.0, py::reinterpret_borrow<py::kwargs>(parameters));
}

}  // namespace

int direction_of(const std::string& name) {
    if (name == "void_ratio") return -1;
    const int at = parameter_of(name);
    if (at < 0) refuse("parameters: %s is none of this sand", name.c_str());
    return at;
}

py::class_<Sand> add_sand_type(py::module_& module) {
    using py::arg;
    py::class_<Sand> sand(module, "Sand", sand_doc);
    sand.attr("__module__") = "grit";  // where pickles look for it
    sand.def(py::init(&make), arg("name") = py::none(), arg("stress_scale") = 1.0);
    sand.def(py::pickle(&parameters_of, &restored));
    sand.def("__reduce_ex__", &reduce);
    sand.def("__repr__", &repr_of);
    sand.def_static("from_props", &of_props, arg("props"), arg("layout") = "classic",
                    "The sand of a UMAT's PROPS, 14 numbers or more (docs/umat.md), in its unit of "
                    "stress. layout: \"classic\", "
                    "phi_c in degrees and p_t second, or \"radian\".");
    sand.def_property_readonly("parameters", &parameters_of,
                               "Parameters by name: angle [rad], stresses in the unit given.");
    module.def(
        "sands", &sands,
        "Sands with published parameters: name -> title, status (\"A\": two independent sources "
        "agree, \"B\": one, or a conflict), source, note.");
    return sand;
}

}  // namespace grit_python
