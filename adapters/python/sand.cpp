// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <grit/sand_derivatives.h>
#include <grit/sand_water.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

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

constexpr const char* update_differentiated_doc =
    R"(update of n points, with the same bits, and the derivatives of what it returns along k directions.

    stress_slope            (n, 6, k)   d stress; in: of the start, out: of the end
    state_slope             (n, 8, k)   d state, the same
    parameters              k names or symbols of parameters of the sand, a direction each; or "void_ratio" or None,
                            a direction without a parameter
    strain_increment_slope  (n, 6, k)   d strain_increment; None: it depends on none

slopes(parameters, n) makes those of a start that depends on no parameter. From call to call they are carried along a
path, per unit of a parameter (rad, stress or 1). Six directions of strain are the consistent tangent. At most 32
directions. There is no tangent beside them; all else is as in update.)";

constexpr const char* slopes_doc =
    R"(stress_slope and state_slope of points at the start of a path, for update_differentiated: zeros, and 1 in the row
VOID_RATIO of the direction "void_ratio". (n, 6, k) and (n, 8, k), of one point without n; components 6 or 4.)";

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
        views.tangent = arrays.write_matrix("tangent", tangent, c, c);
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

// A direction each.
using Names = std::vector<std::optional<std::string>>;

std::vector<int> directions_of(const Names& names) {
    std::vector<int> out;
    for (const auto& name : names)
        out.push_back(name ? direction_of(*name) : static_cast<int>(GRIT_SAND_NO_PARAMETER));
    return out;
}

py::array update_differentiated(const Sand& sand, const py::object& strain_increment,
                                const py::object& stress, const py::object& state,
                                const py::object& stress_slope, const py::object& state_slope,
                                const Names& names, const py::object& strain_increment_slope,
                                const py::object& rotation_increment, const py::object& substep,
                                const py::object& index, double tolerance, int evaluation_limit,
                                bool intergranular_strain, bool stress_is_rotated,
                                bool validate_only) {
    Points points(strain_increment, stress, state, py::none(), rotation_increment, substep, index,
                  {false, tolerance, evaluation_limit, intergranular_strain, stress_is_rotated,
                   validate_only});
    refuse_none("stress_slope", stress_slope);
    refuse_none("state_slope", state_slope);
    const std::vector<int> parameters = directions_of(names);
    const auto k = static_cast<py::ssize_t>(parameters.size());
    const int c = points.arrays.components();
    grit_sand_derivatives d{};
    d.struct_size = sizeof d;
    d.count = static_cast<int>(k);
    d.parameters = parameters.data();
    d.strain_increment =
        points.arrays.read_matrix("strain_increment_slope", strain_increment_slope, c, k);
    d.stress = points.arrays.write_matrix("stress_slope", stress_slope, c, k);
    d.state = points.arrays.write_matrix("state_slope", state_slope, GRIT_SAND_STATE_SIZE, k);
    return points.run(validate_only, [&](grit_sand_report* reports, grit_error& error) {
        return grit_sand_update_differentiated(&sand.prepared, &points.options, &d,
                                               points.arrays.taken(), &points.views, reports,
                                               &error);
    });
}

py::tuple slopes(const Sand&, const Names& names, std::optional<py::ssize_t> n, int components) {
    if (components != 6 && components != 4) refuse("components must be 6 or 4, got %d", components);
    if (n && *n < 0) refuse("n must be >= 0, got %td", *n);
    directions_of(names);  // known
    const auto k = static_cast<py::ssize_t>(names.size());
    const auto zeros = [&](py::ssize_t rows) {
        std::vector<py::ssize_t> shape{rows, k};
        if (n) shape.insert(shape.begin(), *n);
        py::array_t<double> all(shape);
        std::fill_n(all.mutable_data(), all.size(), 0.0);
        return all;
    };
    py::array_t<double> stress = zeros(components), state = zeros(GRIT_SAND_STATE_SIZE);
    double* const of_state = state.mutable_data();
    for (py::ssize_t i = 0; i < n.value_or(1); ++i)
        for (py::ssize_t j = 0; j < k; ++j)
            if (names[static_cast<std::size_t>(j)] == "void_ratio")
                of_state[(i * GRIT_SAND_STATE_SIZE + GRIT_SAND_VOID_RATIO) * k + j] = 1.0;
    return py::make_tuple(stress, state);
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
    sand.def(
        "update_differentiated", &update_differentiated, arg("strain_increment"), arg("stress"),
        arg("state"), arg("stress_slope"), arg("state_slope"), py::kw_only(), arg("parameters"),
        arg("strain_increment_slope") = py::none(), arg("rotation_increment") = py::none(),
        arg("substep") = py::none(), arg("index") = py::none(), arg("tolerance") = usual.tolerance,
        arg("evaluation_limit") = usual.evaluation_limit, arg("intergranular_strain") = true,
        arg("stress_is_rotated") = false, arg("validate_only") = false, update_differentiated_doc);
    sand.def("slopes", &slopes, arg("parameters"), arg("n") = py::none(), py::kw_only(),
             arg("components") = 6, slopes_doc);
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
