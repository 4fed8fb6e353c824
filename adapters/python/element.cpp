// SPDX-License-Identifier: BSD-3-Clause
// Single-element tests through the library grit_element.
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "adapters/python/arrays.hpp"
#include "adapters/python/errors.hpp"
#include "adapters/python/parts.hpp"
#include "element/check.hpp"
#include "element/errors.hpp"
#include "element/grit_law.hpp"
#include "element/laboratory.hpp"
#include "element/simulate.hpp"
#include "element/start.hpp"

namespace grit_python {
namespace {

constexpr const char* element_doc = R"(Run stages of a laboratory test on one sample of sand.

    stages       a list of what the functions of grit.stage return, one after the other, or one of them
    stress       (6,) [stress] effective at the start, tension +
    void_ratio   e [-] at the start
    direction    (6,) strain that the sample remembers: h = rho R along it; None: h = 0
    tolerance    of the stress, relative; that of Sand.update
    intergranular_strain  False: basic hypoplasticity; None: as the sand has parameters for it
    parameters   names or symbols of parameters of the sand, and "void_ratio" for that at the start: derivatives by
                 these (k) are wanted
    stress_slope, void_ratio_slope  (6, k), (k,) of the start, where it depends on them

Without more than stress and void ratio it is the sample of a case file of grit element that gives no
more: h as isotropic compression leaves it.

Returns a dict of arrays with a row for the start and one per increment: stage, increment (m,), strain
(m, 6) logarithmic, extension +, stress (m, 6) effective, total_stress (m, 6), state (m, 8), void_ratio,
pore_pressure (m,) excess, compression + [stress]; with parameters also the exact derivatives strain_slope,
stress_slope, total_stress_slope (m, 6, k), state_slope (m, 8, k), void_ratio_slope, pore_pressure_slope (m, k),
of the steps taken. Raises BadCall if the test makes no sense, and
NotConverged, whose attribute history is as far as it came; so has KeyboardInterrupt.)";

template <class Get>
py::array rows(const std::vector<element::Record>& records, int width, Get get) {
    const auto m = static_cast<py::ssize_t>(records.size());
    py::array_t<double> out({m, static_cast<py::ssize_t>(width)});
    for (py::ssize_t i = 0; i < m; ++i)
        for (int j = 0; j < width; ++j)
            out.mutable_at(i, j) = get(records[static_cast<std::size_t>(i)], j);
    return out;
}

template <class T, class Get>
py::array column(const std::vector<element::Record>& records, Get get) {
    py::array_t<T> out(static_cast<py::ssize_t>(records.size()));
    for (std::size_t i = 0; i < records.size(); ++i)
        out.mutable_at(static_cast<py::ssize_t>(i)) = get(records[i]);
    return out;
}

py::dict arrays_of(const std::vector<element::Record>& records) {
    using element::Record;
    py::dict out;
    out["stage"] = column<long>(records, [](const Record& r) { return r.step; });
    out["increment"] = column<long>(records, [](const Record& r) { return long{r.increment}; });
    out["strain"] = rows(records, 6, [](const Record& r, int j) { return r.strain[j]; });
    out["stress"] = rows(records, 6, [](const Record& r, int j) { return r.effective_stress[j]; });
    out["total_stress"] =
        rows(records, 6, [](const Record& r, int j) { return r.total_stress[j]; });
    out["state"] = rows(records, GRIT_SAND_STATE_SIZE, [](const Record& r, int j) {
        return r.state[static_cast<std::size_t>(j)];
    });
    out["void_ratio"] = column<double>(records, [](const Record& r) { return r.void_ratio; });
    out["pore_pressure"] = column<double>(records, [](const Record& r) { return r.pore_pressure; });
    return out;
}

template <class Get>
py::array slopes(const std::vector<element::Record>& records, py::ssize_t width, Get get) {
    const auto m = static_cast<py::ssize_t>(records.size());
    const py::ssize_t k = get(records.front()).cols();
    py::array_t<double> out({m, width, k});
    for (py::ssize_t i = 0; i < m; ++i) {
        const element::MatrixX of = get(records[static_cast<std::size_t>(i)]);
        for (py::ssize_t r = 0; r < width; ++r)
            for (py::ssize_t c = 0; c < k; ++c) out.mutable_at(i, r, c) = of(r, c);
    }
    return out;
}

void add_slopes(py::dict& out, const std::vector<element::Record>& records) {
    using element::Record;
    if (records.empty()) return;
    const auto one = [&](auto get) {
        const py::array all = slopes(records, 1, get);
        return all.attr("reshape")(all.shape(0), all.shape(2));
    };
    out["strain_slope"] =
        slopes(records, 6, [](const Record& r) -> element::MatrixX { return r.slopes.strain; });
    out["stress_slope"] = slopes(
        records, 6, [](const Record& r) -> element::MatrixX { return r.slopes.effective_stress; });
    out["total_stress_slope"] = slopes(
        records, 6, [](const Record& r) -> element::MatrixX { return r.slopes.total_stress; });
    out["state_slope"] = slopes(records, GRIT_SAND_STATE_SIZE,
                                [](const Record& r) -> element::MatrixX { return r.slopes.state; });
    out["void_ratio_slope"] =
        one([](const Record& r) -> element::MatrixX { return r.slopes.void_ratio; });
    out["pore_pressure_slope"] =
        one([](const Record& r) -> element::MatrixX { return r.slopes.pore_pressure; });
}

element::Vector6 vector_of(const char* name, const py::object& given) {
    return Eigen::Map<const element::Vector6>(few(name, given, 6).data());
}

// What the functions of grit.stage return, and how it was made.
struct Stage {
    element::Step step;
    const char* name;
    py::tuple arguments;
};

Stage staged(const char* name, element::Step step, const py::tuple& first, int increments,
             double first_share) {
    step.increments = increments;
    step.first_share = first_share;
    return {std::move(step), name, first + py::make_tuple(increments, first_share)};
}

// Its function and arguments, which make it again wherever it is sent.
py::tuple reduce_stage(const Stage& stage, int) {
    return py::make_tuple(py::module_::import("grit").attr("_stage"),
                          py::make_tuple(stage.name, stage.arguments));
}

// __new__ of a class without a constructor, which would leave memory as it is.
PyObject* make_none(PyTypeObject*, PyObject*, PyObject*) {
    PyErr_SetString(PyExc_TypeError, "a Stage is made by the functions of grit.stage");
    return nullptr;
}

// A list of stages, or one alone.
std::vector<element::Step> steps_of(const py::object& stages) {
    std::vector<element::Step> out;
    try {
        if (py::isinstance<Stage>(stages)) out = {stages.cast<const Stage&>().step};
        else
            for (const py::handle each : stages) out.push_back(each.cast<const Stage&>().step);
    } catch (const py::error_already_set&) {
        refuse("stages must be a list of what the functions of grit.stage return, got %s",
               py::repr(stages).cast<std::string>().substr(0, 200).c_str());
    } catch (const py::cast_error&) {
        refuse("stages must be a list of what the functions of grit.stage return, got %s",
               py::repr(stages).cast<std::string>().substr(0, 200).c_str());
    }
    bool pore_pressure = false;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto after = element::pore_pressure_after(out[i], pore_pressure);
        if (!after)
            refuse("stage %zu begins with the pore pressure of an undrained stage: let it out by "
                   "stage.drain() before",
                   i + 1);
        pore_pressure = *after;
    }
    return out;
}

// Asks the interpreter for signals now and then, as it cannot while the library runs.
class Interruption {
  public:
    bool came() {
        const auto now = Clock::now();
        if (now < next) return false;
        next = now + std::chrono::milliseconds(100);
        const py::gil_scoped_acquire interpreter;
        if (PyErr_CheckSignals() == 0) return false;
        raised.emplace();
        return true;
    }
    // What a handler has raised, with what was reached.
    void raise_with(const py::object& history) const {
        if (!raised) return;
        raised->value().attr("history") = history;
        throw py::error_already_set(*raised);
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point next = Clock::now();
    std::optional<py::error_already_set> raised;
};

py::dict element_test(const Sand& sand, const py::object& stages, const py::object& stress,
                      double void_ratio, const py::object& direction, double rho, double tolerance,
                      std::optional<bool> intergranular_strain,
                      const std::vector<std::string>& names,
                      const std::optional<element::Matrix6X>& stress_slope,
                      const std::optional<Eigen::RowVectorXd>& void_ratio_slope) {
    grit_sand_parameters parameters{};
    check(grit_sand_parameters_init(&parameters, sizeof parameters), "grit_sand_parameters_init");
    check(grit_sand_parameters_of(&sand.prepared, &parameters), "grit_sand_parameters_of");
    element::GritLawOptions options;
    options.tolerance = tolerance;
    using element::IntergranularStrain;
    element::Start start{vector_of("stress", stress), void_ratio,
                         element::usual_intergranular_strain(parameters)};
    start.rho = rho;
    if (intergranular_strain)
        start.intergranular_strain =
            *intergranular_strain ? IntergranularStrain::mobilised : IntergranularStrain::off;
    options.intergranular_strain = start.intergranular_strain != IntergranularStrain::off;
    if (!direction.is_none()) start.direction = vector_of("direction", direction);
    else if (options.intergranular_strain) start.intergranular_strain = IntergranularStrain::zero;
    if (names.empty() && (stress_slope || void_ratio_slope))
        refuse("stress_slope and void_ratio_slope are of parameters: name these");
    element::History history;
    Interruption interruption;
    element::Listeners listeners;
    listeners.increment = [&](const element::Progress&) { return !interruption.came(); };
    try {
        const element::GritLaw law(parameters, options);
        element::Sample sample;
        sample.point = element::start_point(law, start);
        element::Directions by;
        for (const std::string& name : names) by.push_back(direction_of(name));
        if (!by.empty())
            sample.slopes =
                element::start_slopes(law, start, by,
                                      {stress_slope.value_or(element::Matrix6X()),
                                       void_ratio_slope.value_or(Eigen::RowVectorXd())});
        const std::vector<element::Step> steps = steps_of(stages);
        const py::gil_scoped_release others_may_run;
        history = element::simulate(law, sample, steps, {}, listeners);
    } catch (const element::BadCase& bad) {
        refuse("%s", bad.what());
    }
    py::dict out = arrays_of(history.records);
    if (!names.empty()) add_slopes(out, history.records);
    interruption.raise_with(out);
    if (history.failure) {
        grit_error error{};
        error.status = GRIT_NOT_CONVERGED;
        error.point = -1;
        const std::string& message = history.failure->message;
        message.copy(error.message, sizeof error.message - 1);
        raise(error, "history", out);
    }
    return out;
}

// A stage that is told by one number.
void add_stage(py::module_& stage, const char* name, element::Step (*make)(double),
               const char* argument, const char* doc) {
    using py::arg;
    stage.def(
        name,
        [make, name](double value, int increments, double first_share) {
            return staged(name, make(value), py::make_tuple(value), increments, first_share);
        },
        arg(argument), arg("increments") = 100, arg("first_share") = 0.0, doc);
}

}  // namespace

void add_element(py::module_& module) {
    using py::arg;
    using namespace element;
    py::module_ stage = module.def_submodule(
        "stage",
        "Stages of a laboratory test. Changes over the whole stage, extension and tension +: "
        "compression is negative. The axis of the sample is 11; simple shear is 12, 22 normal to "
        "its plane. increments: of even size, or growing geometrically from first_share of the "
        "path, "
        "which resolves the first strain after a reversal.");
    py::class_<Stage> type(stage, "Stage", "What is done to a sample, for grit.element_test.");
    type.def("__reduce_ex__", &reduce_stage).def("__repr__", [](const Stage& self) {
        return py::str("grit.stage.{}{}").format(self.name, self.arguments);
    });
    reinterpret_cast<PyTypeObject*>(type.ptr())->tp_new = &make_none;
    add_stage(stage, "isotropic_stress", &isotropic_stress, "change",
              "All three stresses [stress].");
    add_stage(stage, "isotropic_strain", &isotropic_strain, "volumetric_strain",
              "A third each [-].");
    add_stage(stage, "oedometer", &oedometer_strain, "axial_strain", "Lateral strain zero.");
    add_stage(stage, "oedometer_stress", &oedometer_stress, "change",
              "Lateral strain zero, axial stress by change [stress].");
    add_stage(stage, "triaxial_drained", &triaxial_drained, "axial_strain",
              "Radial stress constant.");
    add_stage(stage, "triaxial_drained_stress", &triaxial_drained_stress, "change",
              "Radial stress constant, axial stress by change [stress].");
    add_stage(stage, "triaxial_undrained", &triaxial_undrained, "axial_strain",
              "Volume and total radial stress constant; the pore pressure follows.");
    add_stage(stage, "triaxial_undrained_stress", &triaxial_undrained_stress, "change",
              "The same, total axial stress by change [stress].");
    add_stage(stage, "triaxial_constant_p", &triaxial_constant_p, "axial_strain",
              "Effective mean stress constant.");
    add_stage(stage, "biaxial_drained", &biaxial_drained, "axial_strain",
              "Strain 33 zero, stress 22 constant.");
    add_stage(stage, "simple_shear_constant_stress", &simple_shear_constant_stress, "gamma",
              "Stress 22 constant, strain 11 and 33 zero.");
    add_stage(stage, "simple_shear_constant_volume", &simple_shear_constant_volume, "gamma",
              "All strains but 12 zero.");
    stage.def(
        "drain",
        [](int increments, double first_share) {
            return staged("drain", drainage(), py::tuple(), increments, first_share);
        },
        arg("increments") = 100, arg("first_share") = 0.0,
        "Total stress constant, the pore pressure of undrained stages to zero.");
    module.def(
        "element_test", &element_test, arg("sand"), arg("stages"), arg("stress"), arg("void_ratio"),
        py::arg_v("direction",
                  py::array_t<double>(std::vector<py::ssize_t>{6}, Start{}.direction.data()),
                  "[-1, -1, -1, 0, 0, 0]"),
        arg("rho") = Start{}.rho, arg("tolerance") = GritLawOptions{}.tolerance,
        arg("intergranular_strain") = py::none(), arg("parameters") = std::vector<std::string>(),
        arg("stress_slope") = py::none(), arg("void_ratio_slope") = py::none(), element_doc);
}

}  // namespace grit_python
