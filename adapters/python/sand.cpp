// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include <grit/sand_water.h>
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
    tolerance           of the stress, relative, [1e-12, 0.1]; that of grit_sand_options_init
    intergranular_strain  False: basic hypoplasticity
    stress_is_rotated   the host has turned the stress by Q already
    validate_only       check all and change nothing

Components 11 22 33 12 13 23, or 11 22 33 12. One point goes without n. Arrays are float64 of any
strides that are multiples of 8 bytes; they are never copied (rotations are, where they have gaps).

Returns the reports (m,), a structured array: status, flags, substeps, evaluations, error_estimate,
step_reduction. Raises BadCall or BadState and changes nothing, if any shape, dtype or value is bad;
NotConverged (attribute reports) if some points need smaller increments: they are left as they were, the
others are done.)";

constexpr const char* update_undrained_doc =
    R"(update of n undrained points: water fills the pores, K_w.

    pore_pressure       (n,), (1,) of one point  [stress] p_w, compression +; in: start, out: end
    total_stress        as stress         out: stress - p, p = max(p_w, -largest_tension) [stress]
    bulk_modulus        K_w of the water [stress]; 0: drained, p_w stays
    porosity            constant n in (0, 1]; 1: K_w is that of the mixture; 0: e/(1 + e) of the point
    largest_tension     of the water, beyond which it cavitates [stress]

stress is effective, and tangent that of the total stress, with K_w/n on its normal entries unless the water
has cavitated, which the flag CAVITATED says. p_w changes by -K_w ln(e/e_0), or by -(K_w/n) tr strain_increment;
below -largest_tension it says how far a cavity must close. All else is as in update.)";

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

// What both updates take by keyword.
struct Settings {
    bool continuum;
    double tolerance;
    int evaluation_limit;
    bool intergranular_strain, stress_is_rotated, validate_only;
};

void refuse_none(const char* name, const py::object& object) {
    if (object.is_none()) refuse("%s must be a NumPy array of float64, got None", name);
}

// The arrays of an update but its water.
struct Points {
    Arrays arrays;
    grit_sand_points views{};
    grit_sand_options options{};

    Points(const py::object& strain_increment, const py::object& stress, const py::object& state,
           const py::object& tangent, const py::object& rotation_increment,
           const py::object& substep, const py::object& index, const Settings& settings)
        : arrays("strain_increment", strain_increment, {6, 4}),
          options(options_of(!tangent.is_none(), settings.continuum, settings.tolerance,
                             settings.evaluation_limit, settings.intergranular_strain,
                             settings.stress_is_rotated)) {
        const int c = arrays.components();
        refuse_none("stress", stress);
        refuse_none("state", state);
        views.struct_size = sizeof views;
        views.components = c;
        views.strain_increment = arrays.read("strain_increment", strain_increment, c);
        views.stress = arrays.write("stress", stress, c);
        views.state = arrays.write("state", state, GRIT_SAND_STATE_SIZE);
        views.tangent = arrays.write_matrix("tangent", tangent, c);
        views.rotation_increment = arrays.read_rotation("rotation_increment", rotation_increment);
        views.substep = arrays.write("substep", substep, 0);
        views.index = arrays.read_index(index);
    }

    // call(reports, error); after a look at all points, so that bad input of one changes no other.
    template <class Call> py::array run(bool validate_only, const Call& call) {
        arrays.check_overlap();
        py::array_t<grit_sand_report> reports(arrays.taken());
        grit_sand_report* report = reports.mutable_data();
        std::fill_n(report, arrays.taken(), grit_sand_report{});
        grit_error error{};
        grit_status status = GRIT_OK;
        {
            const py::gil_scoped_release others_may_run;
            options.validate_only = 1;
            status = call(report, error);
            options.validate_only = 0;
            if (status == GRIT_OK && !validate_only) status = call(report, error);
        }
        if (status != GRIT_OK) raise(error, "reports", reports);
        return reports;
    }
};

py::array update(const Sand& sand, const py::object& strain_increment, const py::object& stress,
                 const py::object& state, const py::object& tangent,
                 const py::object& rotation_increment, const py::object& substep,
                 const py::object& index, bool continuum, double tolerance, int evaluation_limit,
                 bool intergranular_strain, bool stress_is_rotated, bool validate_only) {
    Points points(strain_increment, stress, state, tangent, rotation_increment, substep, index,
                  {continuum, tolerance, evaluation_limit, intergranular_strain, stress_is_rotated,
                   validate_only});
    return points.run(validate_only, [&](grit_sand_report* reports, grit_error& error) {
        return grit_sand_update(&sand.prepared, &points.options, points.arrays.taken(),
                                &points.views, reports, &error);
    });
}

py::array update_undrained(const Sand& sand, const py::object& strain_increment,
                           const py::object& stress, const py::object& state,
                           const py::object& pore_pressure, double bulk_modulus, double porosity,
                           double largest_tension, const py::object& total_stress,
                           const py::object& tangent, const py::object& rotation_increment,
                           const py::object& substep, const py::object& index, bool continuum,
                           double tolerance, int evaluation_limit, bool intergranular_strain,
                           bool stress_is_rotated, bool validate_only) {
    Points points(strain_increment, stress, state, tangent, rotation_increment, substep, index,
                  {continuum, tolerance, evaluation_limit, intergranular_strain, stress_is_rotated,
                   validate_only});
    refuse_none("pore_pressure", pore_pressure);
    grit_sand_water water{};
    check(grit_sand_water_init(&water, sizeof water), "grit_sand_water_init");
    water.bulk_modulus = bulk_modulus;
    water.porosity = porosity;
    water.largest_tension = largest_tension;
    water.pore_pressure = points.arrays.write("pore_pressure", pore_pressure, 0);
    water.total_stress =
        points.arrays.write("total_stress", total_stress, points.arrays.components());
    return points.run(validate_only, [&](grit_sand_report* reports, grit_error& error) {
        return grit_sand_update_undrained(&sand.prepared, &points.options, &water,
                                          points.arrays.taken(), &points.views, reports, &error);
    });
}

}  // namespace

void add_sand(py::module_& module) {
    using py::arg;
    PYBIND11_NUMPY_DTYPE(grit_sand_report, status, flags, substeps, evaluations, error_estimate,
                         step_reduction);
    grit_sand_options usual{};
    check(grit_sand_options_init(&usual, sizeof usual), "grit_sand_options_init");
    py::class_<Sand> sand = add_sand_type(module);
    sand.def("update", &update, arg("strain_increment"), arg("stress"), arg("state"), py::kw_only(),
             arg("tangent") = py::none(), arg("rotation_increment") = py::none(),
             arg("substep") = py::none(), arg("index") = py::none(), arg("continuum") = false,
             arg("tolerance") = usual.tolerance, arg("evaluation_limit") = usual.evaluation_limit,
             arg("intergranular_strain") = true, arg("stress_is_rotated") = false,
             arg("validate_only") = false, update_doc);
    sand.def(
        "update_undrained", &update_undrained, arg("strain_increment"), arg("stress"), arg("state"),
        arg("pore_pressure"), py::kw_only(), arg("bulk_modulus"), arg("porosity") = 0.0,
        arg("largest_tension") = std::numeric_limits<double>::infinity(),
        arg("total_stress") = py::none(), arg("tangent") = py::none(),
        arg("rotation_increment") = py::none(), arg("substep") = py::none(),
        arg("index") = py::none(), arg("continuum") = false, arg("tolerance") = usual.tolerance,
        arg("evaluation_limit") = usual.evaluation_limit, arg("intergranular_strain") = true,
        arg("stress_is_rotated") = false, arg("validate_only") = false, update_undrained_doc);
    add_sand_operators(sand);
    module.attr("STATE_SIZE") = static_cast<int>(GRIT_SAND_STATE_SIZE);
    module.attr("VOID_RATIO") = static_cast<int>(GRIT_SAND_VOID_RATIO);
    module.attr("SEPARATION") = static_cast<int>(GRIT_SAND_SEPARATION);
    module.attr("STRESS_FREE") = static_cast<int>(GRIT_SAND_STRESS_FREE);
    module.attr("VOID_CLAMPED") = static_cast<int>(GRIT_SAND_VOID_CLAMPED);
    module.attr("OUTSIDE_CONE") = static_cast<int>(GRIT_SAND_OUTSIDE_CONE);
    module.attr("H_CLAMPED") = static_cast<int>(GRIT_SAND_H_CLAMPED);
    module.attr("CAVITATED") = static_cast<int>(GRIT_SAND_CAVITATED);
}

}  // namespace grit_python
