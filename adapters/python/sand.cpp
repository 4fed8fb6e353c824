// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include <pybind11/numpy.h>

#include "adapters/python/arrays.hpp"
#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"

namespace grit_python {
namespace {

constexpr const char* update_doc = R"(Integrate n points over their strain increments, in place.

    strain_increment    (n, 6) or (n, 4)  [-] logarithmic, extension +, engineering shear
    stress              the same          [stress] Cauchy, tension +; in: start, out: end
    state               (n, 8)            h (6) [-], void ratio e [-], separation w [-]; in, out
    tangent             (n, c, c)         out: d stress / d strain [stress], not symmetric
    rotation_increment  (n, 3, 3)         Q, proper orthogonal: turns h and stress first
    substep             (n,)              advice for the next call [strain], 0 for none; in, out
    index               (m,) int64        the points to be taken; the others are left alone
    continuum           the continuum tangent M instead of the consistent one
    tolerance           of the stress, relative, [1e-12, 0.1], 3e-5
    intergranular_strain  False: basic hypoplasticity
    stress_is_rotated   the host has turned the stress by Q already
    validate_only       check all and change nothing

Components 11 22 33 12 13 23, or 11 22 33 12. One point goes without n. Arrays are float64 of any
strides that are multiples of 8 bytes; they are never copied (rotations are, where they have gaps).

Returns the reports (m,), a structured array: status, flags, substeps, evaluations, error_estimate,
step_reduction. Raises BadCall or BadState and changes nothing, if any shape, dtype or value is bad;
NotConverged (attribute reports) if some points need smaller increments: they are left as they were, the
others are done.)";

grit_sand_options options_of(bool tangent, bool continuum, double tolerance, int evaluation_limit,
                             bool intergranular_strain, bool stress_is_rotated) {
    grit_sand_options options{};
    check(grit_sand_options_init(&options, sizeof options), "grit_sand_options_init");
    options.tolerance = tolerance;
    options.evaluation_limit = evaluation_limit;
    options.intergranular_off = !intergranular_strain;
    options.stress_is_rotated = stress_is_rotated;
    if (tangent) options.tangent = continuum ? GRIT_TANGENT_CONTINUUM : GRIT_TANGENT_CONSISTENT;
    return options;
}

py::array update(const Sand& sand, const py::object& strain_increment, const py::object& stress,
                 const py::object& state, const py::object& tangent,
                 const py::object& rotation_increment, const py::object& substep,
                 const py::object& index, bool continuum, double tolerance, int evaluation_limit,
                 bool intergranular_strain, bool stress_is_rotated, bool validate_only) {
    Arrays arrays("strain_increment", strain_increment, {6, 4});
    const int c = arrays.components();
    for (const auto& [name, object] : {std::pair{"stress", &stress}, {"state", &state}})
        if (object->is_none()) refuse("%s must be a NumPy array of float64, got None", name);
    grit_sand_points points{};
    points.struct_size = sizeof points;
    points.components = c;
    points.strain_increment = arrays.read("strain_increment", strain_increment, c);
    points.stress = arrays.write("stress", stress, c);
    points.state = arrays.write("state", state, GRIT_SAND_STATE_SIZE);
    points.tangent = arrays.write_matrix("tangent", tangent, c);
    points.rotation_increment = arrays.read_rotation("rotation_increment", rotation_increment);
    points.substep = arrays.write("substep", substep, 0);
    points.index = arrays.read_index(index);
    arrays.check_overlap();
    grit_sand_options options =
        options_of(!tangent.is_none(), continuum, tolerance, evaluation_limit, intergranular_strain,
                   stress_is_rotated);
    py::array_t<grit_sand_report> reports(arrays.taken());
    grit_sand_report* report = reports.mutable_data();
    std::fill_n(report, arrays.taken(), grit_sand_report{});
    grit_error error{};
    grit_status status = GRIT_OK;
    {
        const py::gil_scoped_release others_may_run;
        options.validate_only = 1;  // so that bad input of one point changes no other
        status =
            grit_sand_update(&sand.prepared, &options, arrays.taken(), &points, report, &error);
        options.validate_only = 0;
        if (status == GRIT_OK && !validate_only)
            status =
                grit_sand_update(&sand.prepared, &options, arrays.taken(), &points, report, &error);
    }
    if (status != GRIT_OK) raise(error, "reports", reports);
    return reports;
}

}  // namespace

void add_sand(py::module_& module) {
    using py::arg;
    PYBIND11_NUMPY_DTYPE(grit_sand_report, status, flags, substeps, evaluations, error_estimate,
                         step_reduction);
    py::class_<Sand> sand = add_sand_type(module);
    sand.def("update", &update, arg("strain_increment"), arg("stress"), arg("state"), py::kw_only(),
             arg("tangent") = py::none(), arg("rotation_increment") = py::none(),
             arg("substep") = py::none(), arg("index") = py::none(), arg("continuum") = false,
             arg("tolerance") = GRIT_SAND_DEFAULT_TOLERANCE, arg("evaluation_limit") = 20000,
             arg("intergranular_strain") = true, arg("stress_is_rotated") = false,
             arg("validate_only") = false, update_doc);
    add_sand_operators(sand);
    module.attr("STATE_SIZE") = static_cast<int>(GRIT_SAND_STATE_SIZE);
    module.attr("VOID_RATIO") = static_cast<int>(GRIT_SAND_VOID_RATIO);
    module.attr("SEPARATION") = static_cast<int>(GRIT_SAND_SEPARATION);
    module.attr("STRESS_FREE") = static_cast<int>(GRIT_SAND_STRESS_FREE);
    module.attr("VOID_CLAMPED") = static_cast<int>(GRIT_SAND_VOID_CLAMPED);
    module.attr("OUTSIDE_CONE") = static_cast<int>(GRIT_SAND_OUTSIDE_CONE);
    module.attr("H_CLAMPED") = static_cast<int>(GRIT_SAND_H_CLAMPED);
}

}  // namespace grit_python
